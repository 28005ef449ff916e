#include "tests/app/program_run.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace secular::testing_support {

namespace fs = std::filesystem;

Outcome run_program(const fs::path& folder, const std::string& arguments, const RunOptions& options) {
  const int raw = std::system(("cd " + folder.string() + " && env " + options.environment + " " + options.program +
                               " " + arguments + " > stdout.txt 2> stderr.txt < /dev/null")
                                  .c_str());
  return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, text_of(folder / "stdout.txt"), text_of(folder / "stderr.txt")};
}

Outcome run_with_shared_cache(const fs::path& folder, const std::string& arguments) {
  fs::create_directories(shared_cache());
  return run_program(folder, arguments, {.environment = "XDG_CACHE_HOME=" + shared_cache().string()});
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace secular::testing_support
