// Limits of functions: 80 lines, unless a comment above or inside says what makes it as long as it is ("as long as
// there are effects"); and six parameters, unless the comment above it, or above its declaration, says of the
// arguments why they are so many ("other arguments as of diagnose()").
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "folder_rules.hpp"
#include "tests/places.hpp"

namespace secular::architecture {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_lines = 80, most_parameters = 6;

struct ScannedFunction {
  std::string name;
  std::size_t lines = 0, parameters = 0;
  std::string above, inside;  // comments
};

// Where a string or a character ends that begins at `at`, or a comment.
std::size_t end_of_text(const std::string& code, std::size_t at) {
  const auto is_of_word = [&](std::size_t i) { return std::isalnum(static_cast<unsigned char>(code[i])) != 0; };
  if (code[at] == '/') return std::min(code.find('\n', at), code.size());
  if (code[at] == '"' && at > 0 && code[at - 1] == 'R' && (at == 1 || !is_of_word(at - 2))) {
    const std::string closing = ")" + code.substr(at + 1, code.find('(', at) - at - 1) + "\"";
    return std::min(code.find(closing, at), code.size() - closing.size()) + closing.size();
  }
  if (code[at] == '\'' && at > 0 && is_of_word(at - 1)) return at + 1;  // parts digits
  std::size_t end = at + 1;
  while (end < code.size() && code[end] != code[at]) end += code[end] == '\\' ? 2U : 1U;
  return end + 1;
}

// With strings and characters empty; lines and comments stay.
std::string without_strings(const std::string& code) {
  std::string text;
  for (std::size_t at = 0; at < code.size();) {
    const bool is_comment = code.compare(at, 2, "//") == 0;
    if (!is_comment && code[at] != '"' && code[at] != '\'') {
      text += code[at++];
      continue;
    }
    const std::string whole = code.substr(at, end_of_text(code, at) - at);
    text += is_comment ? whole : std::string(static_cast<std::size_t>(std::ranges::count(whole, '\n')), '\n');
    at += whole.size();
  }
  return text;
}

// Between the parenthesis that opens there and the one that closes it.
std::size_t parameters_in(const std::string& declaration, std::size_t open) {
  std::size_t commas = 0, at = open;
  for (int depth = 0; at < declaration.size(); ++at) {
    const char c = declaration[at];
    depth +=
        (c == '(' || c == '<' || c == '{') - (c == ')' || c == '}' || (c == '>' && declaration[at - 1] != '-'));
    commas += c == ',' && depth == 1;
    if (depth == 0) break;
  }
  return at == open + 1 ? 0 : commas + 1;
}

// Functions of namespaces and classes as clang-format sets them: they begin at the depth of what is around them,
// and end at the next brace that closes there.
std::vector<ScannedFunction> functions_in(const std::string& text) {
  static const std::regex type(R"(^(?:struct|class|union)\b[^(;]*\{$)"), end_of_head(R"([{};]$)"),
      function(R"(^(?!namespace|using|static_assert|enum)[^=({]*?(operator(?:\(\)|[^\w\s(]+)|~?\w+) ?\()");
  std::vector<std::string> lines;
  std::istringstream stream(without_strings(text));
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const auto blanks = [&](std::size_t at) { return std::min(lines[at].find_first_not_of(' '), lines[at].size()); };
  const auto closes = [&](std::size_t at, std::size_t depth) {
    return blanks(at) == depth && lines[at].substr(depth).starts_with("}");
  };
  std::vector<ScannedFunction> functions;
  std::string above;
  std::size_t depth = 0;
  for (std::size_t at = 0; at < lines.size(); ++at) {
    if (depth >= 2 && closes(at, depth - 2)) depth -= 2;
    std::string head = lines[at].substr(blanks(at));
    if (head.empty() || head.starts_with("#") || head.starts_with("}")) above.clear();
    if (head.starts_with("//")) above += head + "\n";
    if (blanks(at) != depth || head.empty() || std::string("#}/").find(head[0]) != std::string::npos ||
        head.starts_with("template <"))
      continue;
    const std::size_t first = at;
    const auto without_comment = [](const std::string& code) { return code.substr(0, code.find("  //")); };
    head = without_comment(head);
    while (!std::regex_search(head, end_of_head) && at + 1 < lines.size()) {
      ++at;
      head += " " + without_comment(lines[at].substr(blanks(at)));
    }
    std::smatch match;
    const bool opens = head.ends_with("{") && !head.starts_with("namespace") && !head.starts_with("extern");
    if (std::regex_search(head, match, type)) {
      depth += 2;
    } else if (opens) {
      while (at + 1 < lines.size() && !closes(at, depth)) ++at;
    }
    if (std::regex_search(head, match, function)) {
      functions.push_back({match[1], at - first + 1,
                           parameters_in(head, static_cast<std::size_t>(match.length(0)) - 1), above, ""});
      for (std::size_t i = first; i <= at; ++i)
        if (const std::size_t comment = lines[i].find("//"); comment != std::string::npos)
          functions.back().inside += lines[i].substr(comment) + "\n";
    }
    above.clear();
  }
  return functions;
}

bool says(const std::string& comment, const char* words) {
  return comment.find(words) != std::string::npos;
}

// Of the files of one folder.
std::vector<std::string> beyond_limits(const std::vector<std::string>& texts) {
  std::vector<ScannedFunction> all;
  for (const std::string& text : texts)
    for (ScannedFunction& function : functions_in(text)) all.push_back(std::move(function));
  std::map<std::string, std::string> said;  // of functions of one name, by all their declarations
  for (const ScannedFunction& function : all) said[function.name] += function.above;
  std::vector<std::string> found;
  for (const ScannedFunction& f : all) {
    if (f.lines > most_lines && !says(f.above + f.inside, "as long as"))
      found.push_back(f.name + " has " + std::to_string(f.lines) + " lines");
    if (f.parameters > most_parameters && !says(said.at(f.name), "rguments"))
      found.push_back(f.name + " has " + std::to_string(f.parameters) + " parameters");
  }
  return found;
}

TEST(Functions, AreWithinTheirLimitsOrSayWhyNot) {
  const fs::path root = testing_support::source_folder();
  std::size_t seen = 0;
  for (const std::string& folder : folders_of_sources(root)) {
    if (folder == "generated") continue;
    std::vector<std::string> texts;
    for (const fs::path& file : sources_of(root, folder)) texts.push_back(read(file));
    for (const std::string& text : texts) seen += functions_in(text).size();
    for (const std::string& found : beyond_limits(texts)) ADD_FAILURE() << folder << ": " << found;
  }
  EXPECT_GT(seen, 5000U);
}

std::string made_up(const std::string& above, std::size_t lines, const std::string& parameters) {
  std::string text = "namespace a {\nnamespace {\n\n" + above + "int f(" + parameters + ") {\n";
  for (std::size_t i = 2; i < lines; ++i) text += "  g(1, 2, 3, 4, 5, 6, 7);\n";
  return text + "}\n\n}  // namespace\n}  // namespace a\n";
}

TEST(Functions, TheScanSeesNamesLengthsParametersAndComments) {
  const std::string text =
      "// Of the class.\nclass C : public B {\n public:\n  explicit C(int x)\n      : x_(x),\n        y_{1, 2} {}\n"
      "  // Turns.\n  template <typename T>\n  void turn(const std::map<int, T>& by, int n = 3,\n"
      "            std::function<void(int, int)> f = {}) {\n    // Inside.\n  }\n"
      "  bool operator()(int a) const { return a < x_; }\n\n private:\n  int x_ = g(1, 2), y_;\n};\n"
      "const char* text = R\"(\n}\nint no(int a) {\n)\";\nint list[] = {\n    f(1, 2),\n};\n// Free.\n"
      "std::string free(const char* a = \"(,,, R\",\n                 char b = ',')  // it's not {\n{\n}\nvoid "
      "declared();\n";
  std::string seen;
  for (const ScannedFunction& f : functions_in(text))
    seen += f.name + " " + std::to_string(f.lines) + " " + std::to_string(f.parameters) + " " + f.above + f.inside +
            ";";
  EXPECT_EQ(
      seen,
      "C 3 1 ;turn 4 3 // Turns.\n// Inside.\n;operator() 1 1 ;free 4 2 // Free.\n// it's not {\n;declared 1 0 ;");
}

TEST(Functions, TheLimitsHoldWithoutAReason) {
  using Found = std::vector<std::string>;
  const std::string seven = "int a, int b, int c, int d, int e, int f, int g";
  EXPECT_EQ(beyond_limits({made_up("", 80, "int a, int b, int c, int d, int e, int f")}), Found{});
  EXPECT_EQ(beyond_limits({made_up("// Adds.\n", 81, "")}), Found{"f has 81 lines"});
  EXPECT_EQ(beyond_limits({made_up("// A table, as long as there are rows.\n", 81, "")}), Found{});
  EXPECT_EQ(beyond_limits({made_up("// Adds.\n", 9, seven)}), Found{"f has 7 parameters"});
  EXPECT_EQ(beyond_limits({made_up("// Arguments as of g().\n", 9, seven)}), Found{});
  EXPECT_EQ(beyond_limits({made_up("", 9, seven), "// Other arguments as of g().\nint f(" + seven + ");\n"}),
            Found{});
}

}  // namespace
}  // namespace secular::architecture
