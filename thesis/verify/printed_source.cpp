#include "thesis/verify/printed_source.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <system_error>
#include <utility>

#include "input/input_error.hpp"
#include "input/toml_table.hpp"

namespace secular::verify {
namespace {

FormulaSource formula(const TomlTable& table, const std::string& key) {
  return {table.string(key), table.file(), table.first_text_line_of(key)};
}
std::optional<FormulaSource> optional_formula(const TomlTable& table, const std::string& key) {
  return table.has(key) ? std::optional(formula(table, key)) : std::nullopt;
}
std::vector<std::string> strings_or_none(const TomlTable& table, const std::string& key) {
  return table.has(key) ? table.strings(key) : std::vector<std::string>{};
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

PrintedPlace place_of(const TomlTable& table) {
  PrintedPlace place{table.file(), table.line(), {}};
  for (const std::string& key : table.keys()) place.lines[key] = table.line_of(key);
  return place;
}

int integer_within(const TomlTable& table, const std::string& key, std::int64_t low, std::int64_t high) {
  const std::int64_t value = table.integer(key);
  if (value < low || value > high)
    table.fail(key, "is " + std::to_string(value),
               low == high ? "only " + std::to_string(low) + " is possible here"
                           : "an integer from " + std::to_string(low) + " to " + std::to_string(high));
  return static_cast<int>(value);
}

void require_one_of(const TomlTable& table, const std::string& key, const std::string& value,
                    const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), value) != known.end()) return;
  std::string right;
  for (std::size_t i = 0; i < known.size(); ++i)
    right += (i == 0 ? "" : i + 1 < known.size() ? ", " : " or ") + known[i];
  table.fail(key, "is '" + value + "'", right);
}
void require_one_of(const TomlTable& table, const std::string& key, const std::vector<std::string>& known) {
  require_one_of(table, key, table.string(key), known);
}

void require_different(const TomlTable& table, const std::string& key, std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) table.fail(key, "has '" + *twice + "' twice", "every name once");
}

// Chapters and statements count from no higher: far more than a source has.
constexpr std::int64_t highest_chapter = 9999;

/// What a kind of statement asks for.
struct KindOfStatement {
  const char* name;
  std::vector<std::string> needs;  ///< keys
  bool of_a_mode;
  std::size_t solves_for;  ///< how many names `solve_for` has
};
const std::vector<KindOfStatement>& kinds_of_statement() {
  static const std::vector<KindOfStatement> kinds = {{"order_equation", {"order"}, true, 0},
                                                     {"forcing", {"order"}, true, 0},
                                                     {"response", {"order"}, true, 0},
                                                     {"velocity", {}, true, 0},
                                                     {"modulation", {}, false, 0},
                                                     {"definition", {"term", "times"}, true, 0},
                                                     {"polar", {}, false, 0},
                                                     {"real_response", {}, true, 0},
                                                     {"fixed_points", {"solve_for"}, false, 2},
                                                     {"saddle_node", {"solve_for"}, false, 3},
                                                     {"threshold", {}, false, 0},
                                                     {"fourier_mean", {"of"}, true, 0},
                                                     {"motion", {}, true, 0},
                                                     {"detuning", {}, false, 0},
                                                     {"expansion", {}, true, 0},
                                                     {"time_derivative", {"order"}, false, 0},
                                                     {"polar_form", {}, true, 0},
                                                     {"phase", {}, false, 0},
                                                     {"line", {}, false, 0},
                                                     {"special_case", {"of"}, false, 0},
                                                     {"identity", {}, false, 0}};
  return kinds;
}

// Digits ahead of the point of "5.17"; -1 where there are none.
int chapter_of(const std::string& equation) {
  std::size_t digits = 0;
  while (digits < equation.size() && equation[digits] >= '0' && equation[digits] <= '9') ++digits;
  return digits == 0 || digits > 4 ? -1 : std::stoi(equation.substr(0, digits));
}

PrintedChapter read_chapter(const TomlTable& table) {
  table.refuse_unknown_keys({"number", "model", "case", "unknowns", "suffixes", "gamma", "definitions"});
  PrintedChapter chapter;
  chapter.place = place_of(table);
  chapter.number = integer_within(table, "number", 0, highest_chapter);
  chapter.model = table.string("model");
  chapter.resonance = table.string("case");
  for (const std::string& row : table.strings("unknowns")) chapter.unknowns.push_back(words_of(row));
  std::vector<std::string> all;
  for (const std::vector<std::string>& names : chapter.unknowns) all.insert(all.end(), names.begin(), names.end());
  require_different(table, "unknowns", all);
  chapter.suffixes = table.strings("suffixes");
  require_different(table, "suffixes", chapter.suffixes);
  chapter.gamma = formula(table, "gamma");
  if (table.has("definitions")) {
    const TomlTable definitions = table.table("definitions");
    for (const std::string& name : definitions.keys())
      chapter.definitions.emplace_back(name, formula(definitions, name));
  }
  return chapter;
}

// A statement's kind has what it asks for.
void check_kind(const TomlTable& table, const PrintedChapter& chapter) {
  std::vector<std::string> names;
  for (const KindOfStatement& kind : kinds_of_statement()) names.emplace_back(kind.name);
  require_one_of(table, "kind", names);
  const std::string name = table.string("kind");
  const KindOfStatement& kind = *std::find_if(kinds_of_statement().begin(), kinds_of_statement().end(),
                                              [&](const KindOfStatement& k) { return k.name == name; });
  for (const std::string& key : kind.needs)
    if (!table.has(key)) table.fail(key, "is missing", "kind " + name + " needs it");
  if (kind.of_a_mode && chapter.unknowns.size() > 1 && !table.has("mode"))
    table.fail("mode", "is missing", "kind " + name + " needs it where there are several modes");
  if (kind.solves_for == 0) return;
  const std::vector<std::string> unknowns = table.strings("solve_for");
  if (unknowns.size() != kind.solves_for)
    table.fail("solve_for", "has " + std::to_string(unknowns.size()) + " names",
               "kind " + name + " is solved for " + std::to_string(kind.solves_for));
  require_different(table, "solve_for", unknowns);
}

PrintedStatement read_statement(const TomlTable& table, const std::vector<PrintedChapter>& chapters) {
  table.refuse_unknown_keys({"equation",  "part",    "kind",    "mode",  "order",     "printed",
                             "corrected", "equals",  "of",      "name",  "scale",     "term",
                             "times",     "inside",  "without", "where", "solve_for", "only_secular",
                             "at_peak",   "verdict", "reason",  "remark"});
  PrintedStatement statement;
  statement.place = place_of(table);
  statement.equation = table.string("equation");
  statement.chapter = chapter_of(statement.equation);
  const auto chapter = std::find_if(chapters.begin(), chapters.end(),
                                    [&](const PrintedChapter& c) { return c.number == statement.chapter; });
  if (chapter == chapters.end())
    table.fail("equation", "belongs to no [[chapter]] of this file", "number it as 5.17");
  check_kind(table, *chapter);
  statement.part = table.string_or("part", "");
  statement.kind = table.string("kind");
  if (table.has("mode"))
    statement.mode = integer_within(table, "mode", 1, std::max<std::int64_t>(1, std::ssize(chapter->unknowns))) - 1;
  if (table.has("order"))
    statement.order = integer_within(table, "order", 0, std::numeric_limits<std::int16_t>::max());
  statement.printed = formula(table, "printed");
  statement.corrected = optional_formula(table, "corrected");
  statement.equals = optional_formula(table, "equals");
  if (statement.kind == "fourier_mean")
    statement.mean_of = table.string("of");
  else
    statement.of = optional_formula(table, "of");
  statement.name = table.string_or("name", "");
  statement.inside = table.string_or("inside", "");
  statement.scale = optional_formula(table, "scale");
  statement.term = optional_formula(table, "term");
  statement.times = optional_formula(table, "times");
  statement.without = strings_or_none(table, "without");
  statement.solve_for = strings_or_none(table, "solve_for");
  if (table.has("where")) {
    const TomlTable values = table.table("where");
    for (const std::string& name : values.keys()) statement.where[name] = formula(values, name);
  }
  statement.only_secular = table.boolean_or("only_secular", false);
  statement.at_peak = table.boolean_or("at_peak", false);
  statement.verdict = table.string("verdict");
  require_one_of(table, "verdict", {"confirmed", "convention", "misprint"});
  if (statement.verdict != "confirmed" && !statement.corrected)
    table.fail("verdict", "is '" + statement.verdict + "' without a corrected form", "give `corrected`");
  statement.reason = table.string_or("reason", "");
  statement.remark = table.string_or("remark", "");
  return statement;
}

// Every corner of what rounding leaves open is computed: 2^n of them.
constexpr std::size_t most_entries = 12;

// A decimal number as a table prints it, with as many digits and as large an exponent as double precision has.
void require_digits(const TomlTable& table, const std::string& key, const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto result = std::from_chars(begin, end, value);
  const bool decimal = text.find_first_not_of("+-.eE0123456789") == std::string::npos;
  if (!decimal || text.empty() || text.size() > 40 || result.ec != std::errc() || result.ptr != end ||
      !std::isfinite(value))
    table.fail(key, "is '" + text.substr(0, 40) + "'", "a decimal number as printed, for example -10.62e6");
}

// Rows and columns of a matrix that a source prints or talks about.
constexpr std::size_t largest_matrix = 16;

// Rows as strings of digits with blanks between.
std::vector<std::vector<std::string>> digit_rows(const TomlTable& table, const std::string& key) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& row : table.strings(key)) {
    rows.push_back(words_of(row));
    for (const std::string& digits : rows.back()) require_digits(table, key, digits);
  }
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  const bool same = std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row.size() == columns; });
  if (columns == 0 || !same || columns > largest_matrix || rows.size() > largest_matrix)
    table.fail(key, "is no matrix",
               "rows of equally many numbers, at most " + std::to_string(largest_matrix) + " of both");
  return rows;
}

PrintedMatrix read_matrix(const TomlTable& table) {
  table.refuse_unknown_keys({"equation", "part", "printed", "formula", "from", "verdict", "reason"});
  PrintedMatrix matrix{table.string("equation"),
                       table.string_or("part", ""),
                       digit_rows(table, "printed"),
                       formula(table, "formula"),
                       {},
                       table.string("verdict"),
                       table.string_or("reason", "")};
  require_one_of(table, "verdict", {"agrees", "disagrees"});
  const TomlTable from = table.table("from");
  for (const std::string& name : from.keys()) matrix.from[name] = digit_rows(from, name);
  return matrix;
}

PrintedIdentity read_identity(const TomlTable& table) {
  table.refuse_unknown_keys(
      {"equation", "part", "printed", "corrected", "define", "sizes", "complex", "verdict", "reason", "remark"});
  PrintedIdentity identity;
  identity.place = place_of(table);
  identity.equation = table.string("equation");
  identity.part = table.string_or("part", "");
  identity.printed = formula(table, "printed");
  identity.corrected = optional_formula(table, "corrected");
  for (const std::string& line : strings_or_none(table, "define")) {
    const std::size_t at = line.find('=');
    const std::vector<std::string> name = words_of(line.substr(0, at));
    if (at == std::string::npos || name.size() != 1)
      table.fail("define", "has '" + line.substr(0, 40) + "'", "name = formula");
    identity.define.emplace_back(
        name[0], FormulaSource{line.substr(at + 1), table.file(), table.first_text_line_of("define")});
  }
  if (table.has("sizes")) {
    const TomlTable sizes = table.table("sizes");
    for (const std::string& name : sizes.keys()) {
      const std::vector<double> size = sizes.numbers(name);
      const auto possible = [](double n) { return n == std::floor(n) && n >= 1 && n <= largest_matrix; };
      if (size.size() != 2 || !possible(size[0]) || !possible(size[1]))
        sizes.fail(name, "is no size of a matrix",
                   "[rows, columns], at most " + std::to_string(largest_matrix) + " of both");
      identity.sizes[name] = {static_cast<int>(size[0]), static_cast<int>(size[1])};
    }
  }
  identity.complex = strings_or_none(table, "complex");
  require_different(table, "complex", identity.complex);
  identity.verdict = table.string("verdict");
  require_one_of(table, "verdict", {"confirmed", "convention", "misprint"});
  if (identity.verdict != "confirmed" && !identity.corrected)
    table.fail("verdict", "is '" + identity.verdict + "' without a corrected form", "give `corrected`");
  identity.reason = table.string_or("reason", "");
  identity.remark = table.string_or("remark", "");
  return identity;
}

PrintedArithmetic read_arithmetic(const TomlTable& table) {
  table.refuse_unknown_keys({"table", "entry", "printed", "claim", "formula", "from", "verdict", "reason"});
  PrintedArithmetic arithmetic{table.string("table"),     table.string("entry"),
                               table.string("printed"),   table.string_or("claim", "equals"),
                               formula(table, "formula"), {},
                               table.string("verdict"),   table.string_or("reason", "")};
  require_one_of(table, "claim", arithmetic.claim, {"equals", "at least", "at most"});
  require_one_of(table, "verdict", {"agrees", "disagrees"});
  require_digits(table, "printed", arithmetic.printed);
  const TomlTable from = table.table("from");
  for (const std::string& name : from.keys()) {
    arithmetic.from[name] = from.string(name);
    require_digits(from, name, arithmetic.from[name]);
  }
  if (arithmetic.from.size() > most_entries)
    table.fail("from", "has " + std::to_string(arithmetic.from.size()) + " entries",
               "at most " + std::to_string(most_entries));
  return arithmetic;
}

PrintedSource source_of(const TomlTable& root) {
  root.refuse_unknown_keys(
      {"schema", "name", "source", "chapter", "statement", "identity", "arithmetic", "matrix", "symmetry"});
  if (root.integer("schema") != 1) root.fail("schema", "is not 1", "this program reads schema 1");
  PrintedSource source;
  source.file = root.file();
  source.name = root.string("name");
  source.source = root.string("source");
  for (const TomlTable& table : root.tables("chapter")) {
    source.chapters.push_back(read_chapter(table));
    for (std::size_t i = 0; i + 1 < source.chapters.size(); ++i)
      if (source.chapters[i].number == source.chapters.back().number)
        table.fail("number", "is that of an earlier [[chapter]]", "every chapter once");
  }
  for (const TomlTable& table : root.tables("statement"))
    source.statements.push_back(read_statement(table, source.chapters));
  for (const TomlTable& table : root.tables("identity")) source.identities.push_back(read_identity(table));
  for (const TomlTable& table : root.tables("arithmetic")) source.arithmetic.push_back(read_arithmetic(table));
  for (const TomlTable& table : root.tables("matrix")) source.matrices.push_back(read_matrix(table));
  for (const TomlTable& table : root.tables("symmetry")) {
    table.refuse_unknown_keys({"equations", "model", "without", "verdict"});
    require_one_of(table, "verdict", {"confirmed", "misprint"});
    source.symmetries.push_back({place_of(table), table.string("equations"), table.string("model"),
                                 table.strings("without"), table.string("verdict")});
  }
  return source;
}

}  // namespace

void PrintedPlace::fail(const std::string& key, const std::string& wrong, const std::string& right) const {
  const auto found = lines.find(key);
  throw InputError(file, "line " + std::to_string(found == lines.end() ? line : found->second) + ", key " + key,
                   wrong, right);
}

PrintedSource read_printed_source(const std::filesystem::path& path) {
  return source_of(TomlTable::from_file(path));
}

PrintedSource read_printed_source_text(std::string_view text, std::string name) {
  return source_of(TomlTable::from_text(text, std::move(name)));
}

}  // namespace secular::verify
