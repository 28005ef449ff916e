#include "thesis/verify/printed_source.hpp"

#include <sstream>

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

PrintedChapter read_chapter(const TomlTable& table) {
  table.refuse_unknown_keys({"number", "model", "case", "unknowns", "suffixes", "gamma", "definitions"});
  PrintedChapter chapter;
  chapter.number = static_cast<int>(table.integer("number"));
  chapter.model = table.string("model");
  chapter.resonance = table.string("case");
  for (const std::string& row : table.strings("unknowns")) {
    std::istringstream words(row);
    std::vector<std::string> names;
    for (std::string name; words >> name;) names.push_back(name);
    chapter.unknowns.push_back(names);
  }
  chapter.suffixes = table.strings("suffixes");
  chapter.gamma = formula(table, "gamma");
  if (table.has("definitions")) {
    const TomlTable definitions = table.table("definitions");
    for (const std::string& name : definitions.keys())
      chapter.definitions.emplace_back(name, formula(definitions, name));
  }
  return chapter;
}

PrintedStatement read_statement(const TomlTable& table) {
  table.refuse_unknown_keys({"equation",  "part",    "kind",    "mode",  "order",     "printed",
                             "corrected", "equals",  "of",      "name",  "scale",     "term",
                             "times",     "inside",  "without", "where", "solve_for", "only_secular",
                             "at_peak",   "verdict", "reason",  "remark"});
  PrintedStatement statement;
  statement.line = table.line();
  statement.equation = table.string("equation");
  statement.chapter = statement.equation.empty() ? 0 : statement.equation.front() - '0';
  statement.part = table.string_or("part", "");
  statement.kind = table.string("kind");
  statement.mode = table.has("mode") ? static_cast<int>(table.integer("mode")) - 1 : 0;
  statement.order = table.has("order") ? static_cast<int>(table.integer("order")) : 0;
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
  if (statement.verdict != "confirmed" && statement.verdict != "convention" && statement.verdict != "misprint")
    table.fail("verdict", "is '" + statement.verdict + "'", "confirmed, convention or misprint");
  if (statement.verdict != "confirmed" && !statement.corrected)
    table.fail("verdict", "is '" + statement.verdict + "' without a corrected form", "give `corrected`");
  statement.reason = table.string_or("reason", "");
  statement.remark = table.string_or("remark", "");
  return statement;
}

PrintedArithmetic read_arithmetic(const TomlTable& table) {
  table.refuse_unknown_keys({"table", "entry", "printed", "formula", "from", "verdict", "reason"});
  PrintedArithmetic arithmetic{
      table.string("table"),   table.string("entry"),        table.string("printed"), formula(table, "formula"), {},
      table.string("verdict"), table.string_or("reason", "")};
  if (arithmetic.verdict != "agrees" && arithmetic.verdict != "disagrees")
    table.fail("verdict", "is '" + arithmetic.verdict + "'", "agrees or disagrees");
  const TomlTable from = table.table("from");
  for (const std::string& name : from.keys()) arithmetic.from[name] = from.string(name);
  return arithmetic;
}

}  // namespace

PrintedSource read_printed_source(const std::filesystem::path& path) {
  const TomlTable root = TomlTable::from_file(path);
  root.refuse_unknown_keys({"schema", "name", "source", "chapter", "statement", "arithmetic", "symmetry"});
  if (root.integer("schema") != 1) root.fail("schema", "is not 1", "this program reads schema 1");
  PrintedSource source;
  source.file = root.file();
  source.name = root.string("name");
  source.source = root.string("source");
  for (const TomlTable& table : root.tables("chapter")) source.chapters.push_back(read_chapter(table));
  for (const TomlTable& table : root.tables("statement")) {
    PrintedStatement statement = read_statement(table);
    bool known = false;
    for (const PrintedChapter& chapter : source.chapters) known = known || chapter.number == statement.chapter;
    if (!known) table.fail("equation", "belongs to no [[chapter]] of this file", "number it as 5.17");
    source.statements.push_back(std::move(statement));
  }
  for (const TomlTable& table : root.tables("arithmetic")) source.arithmetic.push_back(read_arithmetic(table));
  for (const TomlTable& table : root.tables("symmetry")) {
    table.refuse_unknown_keys({"equations", "model", "without", "verdict"});
    source.symmetries.push_back(
        {table.string("equations"), table.string("model"), table.strings("without"), table.string("verdict")});
  }
  return source;
}

}  // namespace secular::verify
