#include "tests/places.hpp"

namespace secular::testing_support {

std::filesystem::path source_folder() {
  return SECULAR_SOURCE_DIR;
}

std::string program() {
  return SECULAR_PROGRAM;
}

}  // namespace secular::testing_support
