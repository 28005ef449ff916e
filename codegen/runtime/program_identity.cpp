#include "codegen/runtime/program_identity.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/stat.h>

#include <cstring>

namespace secular {
namespace {

// The first object is the program itself. A note is: sizes of name and content, type, name, content, each padded
// to 4.
int find_build_number(dl_phdr_info* object, std::size_t, void* result) {
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& header = object->dlpi_phdr[i];
    if (header.p_type != PT_NOTE) continue;
    const auto* note = reinterpret_cast<const char*>(object->dlpi_addr + header.p_vaddr);
    const char* const end = note + header.p_memsz;
    const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
    while (end - note >= static_cast<std::ptrdiff_t>(sizeof(ElfW(Nhdr)))) {
      ElfW(Nhdr) sizes;
      std::memcpy(&sizes, note, sizeof sizes);
      const char* const name = note + sizeof sizes;
      const char* const content = name + padded(sizes.n_namesz);
      if (static_cast<std::size_t>(end - name) < padded(sizes.n_namesz) + sizes.n_descsz) break;
      if (sizes.n_type == NT_GNU_BUILD_ID && sizes.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0)
        for (std::size_t b = 0; b < sizes.n_descsz; ++b)
          *static_cast<std::string*>(result) += fmt::format("{:02x}", static_cast<unsigned char>(content[b]));
      note = content + padded(sizes.n_descsz);
    }
  }
  return 1;
}

}  // namespace

std::string program_identity() {
  std::string number;
  dl_iterate_phdr(find_build_number, &number);
  if (!number.empty()) return number;
  struct stat status {};
  if (stat("/proc/self/exe", &status) != 0) return "unknown";
  return fmt::format("{} {}.{}", status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
}

}  // namespace secular
