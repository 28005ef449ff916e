#include "input/toml_table.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

TomlTable parse(const std::string& text) {
  return TomlTable::from_text(text, "a.toml");
}

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "(no InputError)";
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "'" << text << "' does not contain '" << part << "'";
}

TEST(TomlTable, ReadsEveryKindOfValue) {
  const TomlTable table = parse(
      "text = \"a\\tb\"\nwhole = -3\nfloat = 2.5\nflag = true\nnames = [\"x\", \"y\"]\nrow = [1, 2.5]\n"
      "rows = [[1, 2], [3.5]]\n[inner]\nkey = 1\n[[many]]\nn = 1\n[[many]]\nn = 2\n");
  EXPECT_EQ(table.string("text"), "a\tb");
  EXPECT_EQ(table.integer("whole"), -3);
  EXPECT_EQ(table.number("whole"), -3.0);
  EXPECT_EQ(table.number("float"), 2.5);
  EXPECT_TRUE(table.boolean("flag"));
  EXPECT_EQ(table.strings("names"), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(table.numbers("row"), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(table.number_rows("rows"), (std::vector<std::vector<double>>{{1, 2}, {3.5}}));
  EXPECT_EQ(table.table("inner").integer("key"), 1);
  ASSERT_EQ(table.tables("many").size(), 2u);
  EXPECT_EQ(table.tables("many")[1].integer("n"), 2);
  EXPECT_TRUE(table.tables("none").empty());
  EXPECT_EQ(table.string_or("none", "default"), "default");
  EXPECT_EQ(table.optional_number("none"), std::nullopt);
  EXPECT_EQ(table.optional_number("float"), 2.5);
  EXPECT_TRUE(table.boolean_or("none", true));
  EXPECT_EQ(table.keys(),
            (std::vector<std::string>{"flag", "float", "inner", "many", "names", "row", "rows", "text", "whole"}));
}

TEST(TomlTable, LinesAreThoseOfTheFile) {
  const TomlTable table = parse("# comment\na = 1\n\n[inner]\nb = 2\ntext = \"\"\"\nfirst\"\"\"\nline = '''x'''\n");
  EXPECT_EQ(table.line_of("a"), 2u);
  EXPECT_EQ(table.table("inner").line(), 4u);
  EXPECT_EQ(table.table("inner").line_of("b"), 5u);
  EXPECT_EQ(table.table("inner").line_of("text"), 6u);
  EXPECT_EQ(table.table("inner").first_text_line_of("text"), 7u);
  EXPECT_EQ(table.table("inner").first_text_line_of("line"), 8u);
  EXPECT_EQ(table.line_of("missing"), 1u);
  EXPECT_EQ(parse("a = 1\r\nb = \"\"\"\r\nx\"\"\"\r\n").first_text_line_of("b"), 3u);
}

TEST(TomlTable, AValueOfAnotherKindIsRefusedWithItsLine) {
  const TomlTable table = parse("s = \"x\"\nn = 1.5\nb = true\na = [1, \"x\"]\nd = 2000-01-01\ni = inf\n[t]\n");
  EXPECT_TRUE(
      contains(refusal([&] { table.number("s"); }), "a.toml, line 1, key s: is a string; a number was expected"));
  EXPECT_TRUE(contains(refusal([&] { table.string("n"); }), "line 2, key n: is a number; a string was expected"));
  EXPECT_TRUE(contains(refusal([&] { table.integer("n"); }), "an integer was expected"));
  EXPECT_TRUE(contains(refusal([&] { table.number("b"); }), "line 3, key b: is true or false"));
  EXPECT_TRUE(contains(refusal([&] { table.boolean("n"); }), "true or false was expected"));
  EXPECT_TRUE(contains(refusal([&] { table.strings("a"); }), "line 4, key a: holds an integer"));
  EXPECT_TRUE(contains(refusal([&] { table.numbers("a"); }), "line 4, key a: is a string"));
  EXPECT_TRUE(contains(refusal([&] { table.number_rows("a"); }), "holds an integer"));
  EXPECT_TRUE(contains(refusal([&] { table.string("d"); }), "a date or time"));
  EXPECT_TRUE(contains(refusal([&] { table.number("i"); }), "line 6, key i: is not finite"));
  EXPECT_TRUE(contains(refusal([&] { table.table("n"); }), "a table was expected"));
  EXPECT_TRUE(contains(refusal([&] { table.tables("t"); }), "[[t]] tables were expected"));
  EXPECT_TRUE(contains(refusal([&] { table.tables("a"); }), "[[a]] tables were expected"));
  EXPECT_TRUE(contains(refusal([&] { table.string("none"); }), "key none: is missing; a string was expected"));
}

TEST(TomlTable, AMissingKeyOfAnInnerTableNamesTheTablesLine) {
  const TomlTable inner = parse("a = 1\n[inner]\nb = 2\n").table("inner");
  EXPECT_TRUE(contains(refusal([&] { inner.number("c"); }), "line 2, key c: is missing"));
}

TEST(TomlTable, UnknownKeysAreRefused) {
  const TomlTable table = parse("name = \"x\"\nnmae = \"y\"\n");
  EXPECT_TRUE(contains(refusal([&] {
                         table.refuse_unknown_keys({"name", "source"});
                       }),
                       "line 2, key nmae: is not a known key; known here: name, source"));
  EXPECT_NO_THROW(table.refuse_unknown_keys({"name", "nmae"}));
}

TEST(TomlTable, TextThatIsNotTomlIsRefusedWithItsPlace) {
  EXPECT_TRUE(contains(refusal([] { parse("a = 1\nb = \n"); }), "a.toml, line 2"));
  EXPECT_TRUE(contains(refusal([] { parse("a = 1\na = 2\n"); }), "line 2"));
  EXPECT_TRUE(contains(refusal([] { parse("a = \"\xFF\"\n"); }), "line 1"));
  for (const char* const text :
       {"[", "[[", "[=]", "[.]", "[a.]", "[,]", "= 1", ".a = 1", "a. = 1", "a = [", "a = {", "a = \"", "a = \"\"\"",
        "[[a]\n", "[a]]\n", "[ [a]]", "a = 1e", "a = 0x", "a = 99999999999999999999"})
    EXPECT_TRUE(contains(refusal([&] { parse(text); }), "line ")) << text;
  EXPECT_TRUE(contains(refusal([] { parse(std::string("[\0a]\n", 5)); }), "line 1"));
}

// Texts on which toml++ 3.3 asserts, reaches what it holds for unreachable, or recurses as deep as keys are.
TEST(TomlTable, TextThatTheParserIsNotMadeForIsRefused) {
  for (const char* const text :
       {"[[[a]]]\n", "a = 1\n[\x01]\n", "[a]\n  [(b)]\n", "\xC2\xB5 = 1\n", "a \xE3\x80\x80= 1\n",
        "a = 1 \xC4\x98\n", "a = [1,\xC2\xA0 2]\n", "a = 'x\x7Fy'\n"})
    EXPECT_TRUE(contains(refusal([&] { parse(text); }), "a.toml, line ")) << text;
  for (const std::size_t parts : {33u, 5000u, 60000u}) {
    std::string key = "k";
    for (std::size_t i = 1; i < parts; ++i) key += i % 3 == 0 ? " . k" : ".k";
    for (const std::string& text :
         {key + " = 1\n", "[" + key + "]\n", "a = { " + key + " = 1 }\n", "[[" + key + "]]\nb = 1\n"})
      EXPECT_TRUE(contains(refusal([&] { parse("x = 1\n" + text); }), "line 2, column ")) << parts;
  }
}

TEST(TomlTable, TextThatIsUnusualIsRead) {
  const TomlTable table = parse(
      "\xEF\xBB\xBF# \xC2\xB5m\na = '\xC2\xB5'\nb = \"\"\"x\\\"\"\" y\"\"\"\"\"\nc = [\n  [1.5, 2.5],\n  [3]\n]\n"
      "d = [[[1]],\n[[2]]]\nx.'y.z'.w = 1\n[ e . \"f.g\" ]\nh = 1\n[[-k]]\n");
  EXPECT_EQ(table.string("a"), "\xC2\xB5");
  EXPECT_EQ(table.string("b"), "x\"\"\" y\"\"");
  EXPECT_EQ(table.table("e").table("f.g").integer("h"), 1);
  EXPECT_EQ(table.table("x").table("y.z").integer("w"), 1);
  EXPECT_TRUE(table.has("-k"));
}

TEST(TomlTable, SharedFilesAreRefusedWithTheirPlace) {
  const std::filesystem::path place = testing_support::source_folder() / "../shared/faults/robustness";
  if (!std::filesystem::exists(place)) GTEST_SKIP() << place << " is not there";
  std::vector<std::filesystem::path> files = {place / "segv_dotted_key_40000.toml"};
  for (const auto& entry : std::filesystem::directory_iterator(place / "toml_parser"))
    files.push_back(entry.path());
  for (const std::filesystem::path& file : files)
    EXPECT_TRUE(contains(refusal([&] { TomlTable::from_file(file); }), "line ")) << file;
}

TEST(TomlTable, DamagedTextIsReadOrRefused) {
  const std::string valid =
      "a = 1\n[[b]]\nc = \"x\"\nd = [[1.5, 2], [3]]\n[e.f]\ng = { h = true, i = \"\"\"j\"\"\" }\n";
  static const std::string telling = "0123456789.,;:-+eE=[]{}\"'\n\r\t #_naif\\\0\x80\xFF";
  std::mt19937_64 random(5);
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = valid;
    for (std::uint64_t change = random() % 3 + 1; change > 0; --change)
      text[random() % text.size()] = telling[random() % telling.size()];
    try {
      parse(text);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 2000);
  EXPECT_LT(refused, 20000);
}

TEST(TomlTable, FilesThatCannotBeReadAreNamed) {
  const std::filesystem::path folder = testing_support::process_folder();
  EXPECT_TRUE(contains(refusal([&] { TomlTable::from_file(folder); }), "is a folder"));
  EXPECT_TRUE(contains(refusal([&] { TomlTable::from_file(folder / "secular-none.toml"); }), "cannot be opened"));
  const std::filesystem::path file = folder / "file.toml";
  std::ofstream(file) << "a = 7\n";
  EXPECT_EQ(TomlTable::from_file(file).integer("a"), 7);
  EXPECT_EQ(TomlTable::from_file(file).file(), file.string());
  std::filesystem::remove(file);
}

TEST(TomlTable, CopiesOutliveTheTableTheyCameFrom) {
  const TomlTable inner = [] { return parse("[a]\nb = 3\n").table("a"); }();
  EXPECT_EQ(inner.integer("b"), 3);
}

TEST(InputError, SaysWhereWhatAndWhatWouldBeRight) {
  const InputError error("f", "line 2", "is wrong", "right was expected");
  EXPECT_STREQ(error.what(), "f, line 2: is wrong; right was expected");
  EXPECT_STREQ(InputError("f", "", "is wrong").what(), "f: is wrong");
  EXPECT_STREQ(InputError("", "", "is wrong").what(), "is wrong");
}

}  // namespace
}  // namespace secular
