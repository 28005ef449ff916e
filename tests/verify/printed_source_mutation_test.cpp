// Printed sources that somebody else wrote: whatever stands in one, the outcome is verdicts or one InputError.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "input/input_error.hpp"
#include "perturb/model.hpp"
#include "tests/campaign/damage.hpp"
#include "tests/places.hpp"
#include "tests/verify/verify_anything.hpp"

namespace secular::verify {
namespace {

const Derivation& known_derivation() {
  static const Model model = read_model(testing_support::source_folder() / "models/two_mass_mode1.toml");
  static const Derivation derivation = derive(model, model.find_case("principal_parametric"));
  return derivation;
}

std::string every_kind() {
  std::ifstream file(testing_support::source_folder() / "tests/fuzz/corpus/source/every_kind.toml");
  return {std::istreambuf_iterator<char>(file), {}};
}

// What the InputError says; empty where there is none.
std::string refusal_of(const std::string& text) {
  try {
    verify_anything(text, known_derivation());
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// A table of the file, as lines of "key = value".
struct Table {
  std::string header;
  std::vector<std::pair<std::string, std::string>> entries;

  std::string text() const {
    std::string result = header + "\n";
    for (const auto& [key, value] : entries) result += key + " = " + value + "\n";
    return result;
  }
};

std::vector<Table> tables_of(const std::string& text) {
  std::vector<Table> tables{{"", {}}};
  bool inside = false;  // of """
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (inside) {
      tables.back().entries.back().second += "\n" + line;
      if (line.ends_with("\"\"\"")) inside = false;
    } else if (line.starts_with('[')) {
      tables.push_back({line, {}});
    } else if (const std::size_t equals = line.find(" = "); equals != std::string::npos && line[0] != '#') {
      std::string key = line.substr(0, equals);
      while (key.ends_with(' ')) key.pop_back();
      tables.back().entries.emplace_back(key, line.substr(equals + 3));
      inside = line.ends_with("\"\"\"");
    }
  }
  return tables;
}

std::string joined(const std::vector<Table>& tables) {
  std::string text;
  for (const Table& table : tables) text += table.text();
  return text;
}

// The file with the chapter and one of its other tables.
std::vector<Table> with_one(const std::vector<Table>& all, std::size_t table) {
  std::vector<Table> kept;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i == table || all[i].header.empty() || all[i].header.find("chapter") != std::string::npos)
      kept.push_back(all[i]);
  return kept;
}

std::vector<std::string> hostile_values() {
  std::vector<std::string> values = {"true",
                                     "-5",
                                     "-1",
                                     "0",
                                     "2",
                                     "3",
                                     "7",
                                     "9",
                                     "1e400",
                                     "nan",
                                     "inf",
                                     "1.5",
                                     "[]",
                                     "[\"nothing\"]",
                                     "[\"mu1\"]",
                                     "[\"omega0\", \"omega0\"]",
                                     "[\"i\", \"eta_e\", \"Pi\"]",
                                     "{}",
                                     "{ x = 1 }",
                                     "{ omega0 = \"0\" }",
                                     "{ nothing = \"1\" }",
                                     "1979-05-27",
                                     "9223372036854775807",
                                     "-9223372036854775808",
                                     "4294967297"};
  const std::string deep(400, '(');
  for (const std::string& formula : {std::string(""),
                                     std::string(" "),
                                     std::string("nothing"),
                                     std::string("1/0"),
                                     std::string("0^0"),
                                     std::string("0^(-1)"),
                                     std::string("(a - a)^0"),
                                     std::string("1/(A - A)"),
                                     std::string("log(0)"),
                                     std::string("f(x)"),
                                     std::string("a = b = c"),
                                     std::string("= 1"),
                                     std::string("1 ="),
                                     std::string("9^9^9^9"),
                                     std::string("1e999999999"),
                                     std::string("abs(A)"),
                                     std::string("conj(1/E(omega0))"),
                                     std::string("E(omega0^2)"),
                                     std::string("E(5)"),
                                     std::string("E(i*omega0)"),
                                     std::string("E(1e30*omega0)"),
                                     std::string("E(omega0/3)"),
                                     std::string("cos(1/t)"),
                                     std::string("cos(t^2*omega0)"),
                                     std::string("E(1/omega0)"),
                                     std::string("1/E(sigma)/0"),
                                     std::string("a^64^2"),
                                     std::string("(a + A + F + mu1 + sigma)^64"),
                                     std::string("1/(Pi - Pi)"),
                                     std::string("D0(D1(D2(v0*v1)))"),
                                     std::string("D0(1/v0)"),
                                     std::string("i"),
                                     std::string("det/det"),
                                     std::string("dgamma"),
                                     std::string("nan"),
                                     std::string("inf"),
                                     std::string("-1"),
                                     std::string("0"),
                                     std::string("1e308"),
                                     std::string("sigma"),
                                     std::string("3*sigma - 7*beta"),
                                     std::string("sigma/2"),
                                     std::string("1e30*sigma"),
                                     std::string("sigma + omega0"),
                                     std::string("0*sigma"),
                                     deep + "a" + std::string(400, ')'),
                                     std::string(300, '-') + "a"})
    values.push_back("\"" + formula + "\"");
  std::string nested = "v0*v1*v2*a*F";
  for (int i = 0; i < 60; ++i) nested = (i % 3 == 0 ? "cc(" : i % 3 == 1 ? "D0(" : "conj(") + nested + ")";
  values.push_back("\"" + nested + "\"");
  return values;
}

TEST(PrintedSourceMutation, TheFileItselfIsRight) {
  EXPECT_EQ(joined(tables_of(every_kind())).empty(), false);
  EXPECT_EQ(refusal_of(every_kind()), "");
  EXPECT_EQ(refusal_of(joined(tables_of(every_kind()))), "");
}

TEST(PrintedSourceMutation, EveryKeyMissingOrOfAnotherValue) {
  const std::vector<Table> all = tables_of(every_kind());
  const std::vector<std::string> values = hostile_values();
  int refused = 0, tried = 0;
  const auto run = [&](const std::string& text) {
    ++tried;
    std::string refusal;
    ASSERT_NO_THROW(refusal = refusal_of(text)) << text;
    if (refusal.empty()) return;
    ++refused;
    EXPECT_NE(refusal.find("source.toml, line "), std::string::npos) << refusal << "\n" << text;
  };
  for (std::size_t t = 0; t < all.size(); ++t) {
    std::vector<Table> kept = with_one(all, t);
    for (Table& table : kept) {
      if (table.header != all[t].header || table.entries != all[t].entries) continue;
      for (std::size_t e = 0; e < table.entries.size(); ++e) {
        const auto entry = table.entries[e];
        for (const std::string& value : values) {
          table.entries[e].second = value;
          run(joined(kept));
          if (HasFatalFailure()) return;
        }
        table.entries[e] = entry;
        table.entries.erase(table.entries.begin() + static_cast<std::ptrdiff_t>(e));
        run(joined(kept));
        if (HasFatalFailure()) return;
        table.entries.insert(table.entries.begin() + static_cast<std::ptrdiff_t>(e), entry);
      }
    }
  }
  EXPECT_GT(refused, tried / 2) << "of " << tried;
}

TEST(PrintedSourceMutation, Bytes) {
  const std::vector<Table> all = tables_of(every_kind());
  std::mt19937_64 random(20);
  int refused = 0;
  for (int round = 0; round < 600; ++round) {
    const std::string text = damaged(joined(with_one(all, 3 + random() % (all.size() - 3))), random);
    ASSERT_NO_THROW(refused += refusal_of(text).empty() ? 0 : 1) << text;
  }
  EXPECT_GT(refused, 200);
}

// Each with the one message that says where it is and what would be right.
TEST(PrintedSourceMutation, SaysWhatIsWrongAndWhatWouldBeRight) {
  const std::string head = joined(with_one(tables_of(every_kind()), 0)) + "[[statement]]\nequation = \"5.1\"\n";
  const struct {
    const char *statement, *place, *wrong, *right;
  } cases[] = {
      {"kind = \"forcing\"\nmode = 1\norder = 9\nprinted = \"0\"", "key order", "is 9", "orders 1 to 2"},
      {"kind = \"forcing\"\nmode = 0\norder = 1\nprinted = \"0\"", "key mode", "is 0", "only 1 is possible"},
      {"kind = \"response\"\nmode = 2\norder = 1\nprinted = \"0\"", "key mode", "is 2", "only 1 is possible"},
      {"kind = \"response\"\norder = 3\nprinted = \"0\"", "key order", "is 3", "orders 0 to 2"},
      {"kind = \"response\"\nprinted = \"0\"", "key order", "is missing", "kind response needs it"},
      {"kind = \"order_equation\"\norder = -1\nprinted = \"0\"", "key order", "is -1", "an integer from 0"},
      {"kind = \"order_equation\"\nmode = -5\norder = 0\nprinted = \"0\"", "key mode", "is -5", "only 1"},
      {"kind = \"modulation\"\nmode = 7\nprinted = \"D1A = 0\"", "key mode", "is 7", "only 1 is possible"},
      {"kind = \"fixed_points\"\nsolve_for = [\"mu1\"]\nprinted = \"0\"", "key solve_for", "has 1 names", "for 2"},
      {"kind = \"fixed_points\"\nsolve_for = [\"mu1\", \"no\"]\nprinted = \"0\"", "key solve_for",
       "'no' is no symbol", "a symbol of model two_mass_mode1"},
      {"kind = \"fixed_points\"\nsolve_for = [\"sigma\", \"mu1\"]\nprinted = \"0\"", "key solve_for",
       "'sigma' is nothing that its condition is linear in", "da = 0"},
      {"kind = \"identity\"\nprinted = \"a + 1/0\"", "column 6", "division by zero", "correct the denominator"},
      {"kind = \"identity\"\nprinted = \"a = 0^0\"", "column 6", "zero to the power of zero", "correct the power"},
      {"kind = \"identity\"\nwithout = [\"eta_e\"]\nprinted = \"0\"", "key without", "'eta_e' is no symbol",
       "no definition"},
      {"kind = \"identity\"\nprinted = \"E(omega0^2)\"", "column 9", "is not a linear combination", "2*omega0"},
      {"kind = \"definition\"\nterm = \"A\"\nprinted = \"0\"", "key times", "is missing", "kind definition"},
      {"kind = \"guess\"\nprinted = \"0\"", "key kind", "is 'guess'", "special_case or identity"},
  };
  for (const auto& c : cases) {
    const std::string refusal = refusal_of(head + c.statement + "\nverdict = \"confirmed\"\n");
    for (const char* part : {"source.toml, line ", c.place, c.wrong, c.right})
      EXPECT_NE(refusal.find(part), std::string::npos) << c.statement << "\n" << refusal << "\n" << part;
  }
  const std::string table = joined(with_one(tables_of(every_kind()), 0)) +
                            "[[arithmetic]]\ntable = \"1\"\nentry = \"x\"\nverdict = \"agrees\"\n";
  EXPECT_NE(refusal_of(table + "printed = \"nan\"\nformula = \"a\"\nfrom = { a = \"1\" }\n")
                .find("key printed: is 'nan'"),
            std::string::npos);
  EXPECT_NE(
      refusal_of(table + "printed = \"1\"\nformula = \"a\"\nfrom = { a = \"one\" }\n").find("key a: is 'one'"),
      std::string::npos);
  EXPECT_NE(refusal_of(table + "printed = \"1\"\nformula = \"1/(a - a)\"\nfrom = { a = \"1\" }\n")
                .find("division by zero"),
            std::string::npos);
}

}  // namespace
}  // namespace secular::verify
