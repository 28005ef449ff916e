// docs/limits.md names the line that holds each limit and the test that goes beyond it.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "folder_rules.hpp"
#include "tests/places.hpp"

namespace secular::architecture {
namespace {

namespace fs = std::filesystem;

// SUITE.NAME of all tests of the project.
std::set<std::string> all_tests(const fs::path& root) {
  static const std::regex declared(R"(\nTEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = read(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), declared); at != std::sregex_iterator(); ++at)
      names.insert((*at)[1].str() + "." + (*at)[2].str());
  }
  return names;
}

// With one blank wherever there are some.
std::string in_one_line(const std::string& text) {
  return std::regex_replace(text, std::regex(R"(\s+)"), " ");
}

TEST(LimitsPage, EveryRowIsInTheSourceAndItsTestIsThere) {
  const fs::path root = testing_support::source_folder();
  const std::set<std::string> tests = all_tests(root);
  static const std::regex row(R"(\n\|[^|\n]+\|[^|\n]+\| `([^`\n]+)`: `([^`\n]+)`[^|\n]*\|(?: `([^`\n]+)`)? \|)");
  const std::string page = read(root / "docs/limits.md");
  std::size_t rows = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), row); at != std::sregex_iterator(); ++at, ++rows) {
    const std::string file = (*at)[1], line = (*at)[2], test = (*at)[3];
    EXPECT_NE(in_one_line(read(root / file)).find(line), std::string::npos) << file << " does not hold: " << line;
    if (!test.empty()) {
      EXPECT_TRUE(tests.contains(test)) << "there is no test " << test;
    }
  }
  EXPECT_GT(rows, 15U);
}

}  // namespace
}  // namespace secular::architecture
