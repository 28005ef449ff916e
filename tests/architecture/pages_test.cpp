// Pages: links lead somewhere, and docs/README.md lists every page.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

std::string page_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<fs::path> pages() {
  const fs::path root = testing_support::source_folder();
  std::vector<fs::path> found = {root / "README.md", root / "CONTRIBUTING.md", root / "CHANGELOG.md"};
  for (const auto& entry : fs::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

// What a link to a heading says: lower case, blanks as hyphens, no punctuation.
std::set<std::string> anchors_of(const std::string& text) {
  std::set<std::string> anchors;
  static const std::regex heading(R"((^|\n)#+ ([^\n]*))");
  for (std::sregex_iterator it(text.begin(), text.end(), heading), end; it != end; ++it) {
    std::string anchor;
    for (const char c : (*it)[2].str()) {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
        anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      if (c == ' ') anchor += '-';
    }
    anchors.insert(anchor);
  }
  return anchors;
}

TEST(Pages, LinksLeadSomewhere) {
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  std::size_t checked = 0;
  for (const fs::path& page : pages()) {
    const std::string text = page_text(page);
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      const std::string target = (*it)[1];
      if (target.find("://") != std::string::npos) continue;
      const std::size_t hash = target.find('#');
      const std::string name = target.substr(0, hash);
      const fs::path file = name.empty() ? page : page.parent_path() / name;
      EXPECT_TRUE(fs::exists(file)) << page << " links to " << target;
      if (hash != std::string::npos && file.extension() == ".md") {
        EXPECT_TRUE(anchors_of(page_text(file)).contains(target.substr(hash + 1)))
            << page << " links to " << target;
      }
      ++checked;
    }
  }
  EXPECT_GT(checked, 50U);
}

TEST(Pages, AllAreListed) {
  const fs::path docs = testing_support::source_folder() / "docs";
  const std::string list = page_text(docs / "README.md");
  for (const fs::path& page : pages()) {
    if (page.parent_path() != docs || page.filename() == "README.md") continue;
    EXPECT_NE(list.find("(" + page.filename().string() + ")"), std::string::npos) << page;
  }
}

}  // namespace
}  // namespace secular
