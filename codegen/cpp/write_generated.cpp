#include <filesystem>
#include <fstream>
#include <sstream>

#include "codegen/cpp/emit_cpp.hpp"
#include "input/input_error.hpp"

namespace secular {

void write_generated(const std::vector<GeneratedFile>& files, const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw InputError(folder, "", "cannot be made a folder", "name a folder that can be written");
  for (const GeneratedFile& file : files) {
    const fs::path target = fs::path(folder) / file.name;
    std::ifstream old(target, std::ios::binary);
    if (old) {
      std::ostringstream text;
      text << old.rdbuf();
      if (text.str() == file.text) continue;
    }
    const fs::path fresh = target.string() + ".new";
    {
      std::ofstream stream(fresh, std::ios::binary);
      stream << file.text;
      stream.flush();
      if (!stream) {
        fs::remove(fresh, error);
        throw InputError(target.string(), "", "cannot be written", "check the folder's permissions and space");
      }
    }
    fs::rename(fresh, target);
  }
}

}  // namespace secular
