#include "codegen/runtime/file_bytes.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <mutex>
#include <system_error>

#include "input/interruption.hpp"

namespace secular {

namespace fs = std::filesystem;

std::optional<std::string> read_file_bytes(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string bytes;
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  if (size < 0) return std::nullopt;
  bytes.resize(static_cast<std::size_t>(size));
  stream.seekg(0);
  stream.read(bytes.data(), size);
  if (!stream) return std::nullopt;
  return bytes;
}

bool write_file_bytes(const fs::path& path, std::string_view bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  return static_cast<bool>(stream);
}

PrivateFolder::PrivateFolder(const fs::path& parent) {
  if (parent.empty()) return;
  std::string pattern = (parent / "build-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) return;
  path_ = pattern;
  Interruption& interruption = Interruption::instance();
  const std::lock_guard lock(interruption.guard());
  interruption.add(this, [this] {
    std::error_code error;
    fs::remove_all(path_, error);
    return !error;
  });
}

PrivateFolder::~PrivateFolder() {
  if (path_.empty()) return;
  Interruption& interruption = Interruption::instance();
  const std::lock_guard lock(interruption.guard());
  interruption.take_out(this);
  std::error_code error;
  fs::remove_all(path_, error);
}

}  // namespace secular
