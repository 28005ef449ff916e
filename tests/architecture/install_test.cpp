// What `cmake --install` exports: headers of a folder and the library that they belong to go together.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "folder_rules.hpp"
#include "tests/places.hpp"

namespace secular::architecture {
namespace {

// Words of a CMake list, up to the parenthesis that closes it; empty where it does not begin so.
std::set<std::string> words_after(const std::string& text, const std::string& beginning) {
  const std::size_t at = text.find(beginning);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + beginning.size();
  std::istringstream list(text.substr(begin, text.find(')', begin) - begin));
  std::set<std::string> words;
  for (std::string word; list >> word;) words.insert(word);
  return words;
}

TEST(Install, EveryLibraryOfAFolderWhoseHeadersAreInstalledIsExported) {
  const auto root = testing_support::source_folder();
  const std::string install = read(root / "cmake/install.cmake"), libraries = read(root / "CMakeLists.txt");
  const std::set<std::string> exported = words_after(install, "set(secular_libraries "),
                              folders = words_after(install, "foreach(folder ");
  ASSERT_FALSE(exported.empty());
  ASSERT_FALSE(folders.empty());
  static const std::regex declared(R"(\nsecular_library\(([\w/]+))");
  std::size_t seen = 0;
  for (std::sregex_iterator at(libraries.begin(), libraries.end(), declared); at != std::sregex_iterator(); ++at) {
    const std::string folder = (*at)[1];
    if (!folders.contains(first_part(folder))) continue;
    EXPECT_TRUE(exported.contains("secular_" + std::regex_replace(folder, std::regex("/"), "_")))
        << folder << " is missing in cmake/install.cmake";
    ++seen;
  }
  EXPECT_GT(seen, 20U);
}

}  // namespace
}  // namespace secular::architecture
