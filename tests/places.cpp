#include "tests/places.hpp"

namespace secular::testing_support {

std::filesystem::path source_folder() {
  return SECULAR_SOURCE_DIR;
}

std::string program() {
  return SECULAR_PROGRAM;
}

std::filesystem::path shared_cache() {
  return SECULAR_TEST_CACHE;
}

}  // namespace secular::testing_support
