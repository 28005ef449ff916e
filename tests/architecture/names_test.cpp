// Sources of one folder are compiled several at a time: what their unnamed namespaces hold has to differ in name,
// or a file more in the folder brings two together.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "folder_rules.hpp"
#include "tests/places.hpp"

namespace secular::architecture {
namespace {

namespace fs = std::filesystem;

// Constants and types of the unnamed namespaces of a file, as clang-format sets them; each name with the namespaces
// around it.
std::set<std::string> unnamed_names(const std::string& text) {
  static const std::regex type(R"(^(?:struct|class|enum class) (\w+))"), constant(R"(^(?:constexpr|const) .*$)"),
      declared(R"((\w+)(?:\[\w*\])? =)"), text_in(R"(R?".*|//.*)");
  std::set<std::string> names;
  std::string around;
  bool inside = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line == "namespace {") {
      inside = true;
    } else if (line.starts_with("}  // namespace")) {
      inside = false;
    } else if (line.starts_with("namespace ") && line.ends_with("{")) {
      around = line;
    } else if (inside && std::regex_search(line, match, type) && !line.ends_with(";")) {
      names.insert(around + " " + match[1].str());
    } else if (inside && std::regex_match(line, constant)) {
      const std::string code = std::regex_replace(line, text_in, "");
      for (std::sregex_iterator at(code.begin(), code.end(), declared); at != std::sregex_iterator(); ++at)
        names.insert(around + " " + (*at)[1].str());
    }
  }
  return names;
}

TEST(Names, OfUnnamedNamespacesDifferWithinAFolder) {
  std::size_t seen = 0;
  for (const std::string& folder : folders_of_sources(testing_support::source_folder())) {
    std::map<std::string, std::string> file_of;
    for (const fs::path& file : sources_of(testing_support::source_folder(), folder)) {
      if (file.extension() != ".cpp") continue;
      for (const std::string& name : unnamed_names(read(file))) {
        const auto [place, fresh] = file_of.emplace(name, file.filename().string());
        EXPECT_TRUE(fresh) << folder << ": " << name << " stands in " << place->second << " and in "
                           << file.filename().string();
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 1000U);
}

TEST(Names, TheScanSeesEveryDeclaration) {
  const std::string text =
      "namespace a {\nstruct Open {\n};\nnamespace {\nconstexpr double x = 1, y[] = {2};\nconst std::string z =\n"
      "    \"z\";\nstruct S;\nclass C {\n  int inner = 0;\n};\n}  // namespace\nconstexpr int free = 3;\n}\n";
  EXPECT_EQ(unnamed_names(text),
            (std::set<std::string>{"namespace a { C", "namespace a { x", "namespace a { y", "namespace a { z"}));
}

}  // namespace
}  // namespace secular::architecture
