#include "measure/formats/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "input/input_error.hpp"

namespace secular {
namespace {

constexpr std::size_t page_multiple = std::size_t{1} << 16;  // of every page size in use
constexpr std::size_t release_step = std::size_t{1} << 22;

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path.string(), "", "is a folder", "a data file was expected");
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (file < 0 || ::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    if (file >= 0) ::close(file);
    throw InputError(path.string(), "", "cannot be opened for reading", "check the path and its permissions");
  }
  size_ = static_cast<std::size_t>(status.st_size);
  void* const memory = size_ > 0 ? ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0) : nullptr;
  ::close(file);
  if (memory == MAP_FAILED)
    throw InputError(path.string(), "", "cannot be read", "check the medium and the memory that is allowed");
  begin_ = static_cast<const char*>(memory);
}

MappedFile::~MappedFile() {
  if (begin_) ::munmap(const_cast<char*>(begin_), size_);
}

void MappedFile::release_before(std::size_t offset) {
  const std::size_t end = std::min(offset, size_) / release_step * release_step;
  if (end <= released_) return;
  forget(released_, end);
  released_ = end;
}

void MappedFile::forget(std::size_t begin, std::size_t end) {
  begin = (begin + page_multiple - 1) / page_multiple * page_multiple;
  end = std::min(end, size_) / page_multiple * page_multiple;
  if (begin < end) ::madvise(const_cast<char*>(begin_) + begin, end - begin, MADV_DONTNEED);
}

}  // namespace secular
