#include "input/toml_table.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "input/input_error.hpp"
#include "input/toml_text.hpp"

namespace secular {

struct TomlTable::Document {
  std::string file;
  std::vector<std::string> lines;
  toml::table root;
};

namespace {

const toml::table& as_table(const void* node) {
  return *static_cast<const toml::table*>(node);
}

std::string kind_name(const toml::node& node) {
  if (node.is_string()) return "a string";
  if (node.is_integer()) return "an integer";
  if (node.is_floating_point()) return "a number";
  if (node.is_boolean()) return "true or false";
  if (node.is_array()) return "an array";
  if (node.is_table()) return "a table";
  return "a date or time";
}

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TomlTable TomlTable::from_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path.string(), "", "is a folder", "a TOML file was expected");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw InputError(path.string(), "", "cannot be opened for reading", "check the path and its permissions");
  std::ostringstream text;
  text << stream.rdbuf();
  return from_text(text.str(), path.string());
}

TomlTable TomlTable::from_text(std::string_view text, std::string name) {
  auto document = std::make_shared<Document>();
  document->file = std::move(name);
  document->lines = split_lines(text);
  check_toml_text(text, document->file);
  try {
    document->root = toml::parse(text, document->file);
  } catch (const toml::parse_error& error) {
    throw InputError(document->file,
                     "line " + std::to_string(error.source().begin.line) + ", column " +
                         std::to_string(error.source().begin.column),
                     std::string(error.description()), "the file must be valid TOML 1.0");
  }
  const void* root = &document->root;
  return TomlTable(std::move(document), root);
}

const std::string& TomlTable::file() const {
  return document_->file;
}

std::uint32_t TomlTable::line() const {
  return std::max<std::uint32_t>(1, as_table(node_).source().begin.line);
}

std::uint32_t TomlTable::line_of(std::string_view key) const {
  const toml::node* node = as_table(node_).get(key);
  return node ? node->source().begin.line : line();
}

std::uint32_t TomlTable::first_text_line_of(std::string_view key) const {
  const std::uint32_t line = line_of(key);
  if (line == 0 || line > document_->lines.size()) return line;
  std::string text = document_->lines[line - 1];
  while (!text.empty() && (text.back() == '\r' || text.back() == ' ' || text.back() == '\t')) text.pop_back();
  const bool opens_alone = text.ends_with("\"\"\"") || text.ends_with("'''");
  const bool opens = text.find("\"\"\"") == text.rfind("\"\"\"") && text.find("'''") == text.rfind("'''");
  return opens_alone && opens ? line + 1 : line;
}

bool TomlTable::has(std::string_view key) const {
  return as_table(node_).contains(key);
}

bool TomlTable::is_string(std::string_view key) const {
  const toml::node* const node = as_table(node_).get(key);
  return node != nullptr && node->is_string();
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : as_table(node_)) names.emplace_back(key.str());
  std::sort(names.begin(), names.end());
  return names;
}

void TomlTable::fail(std::string_view key, std::string wrong, std::string right) const {
  const std::uint32_t at = has(key) ? line_of(key) : line();
  throw InputError(file(), "line " + std::to_string(at) + ", key " + std::string(key), std::move(wrong),
                   std::move(right));
}

namespace {

// The node of `key`, or an error that says what kind was expected.
const toml::node& required(const TomlTable& table, const void* node, std::string_view key, const char* expected) {
  const toml::node* found = as_table(node).get(key);
  if (!found) table.fail(key, "is missing", std::string(expected) + " was expected");
  return *found;
}

double finite_number(const TomlTable& table, const toml::node& node, std::string_view key) {
  const auto value = node.value<double>();
  if (!value || !(node.is_integer() || node.is_floating_point()))
    table.fail(key, "is " + kind_name(node), "a number was expected");
  if (!std::isfinite(*value)) table.fail(key, "is not finite", "a finite number was expected");
  return *value;
}

}  // namespace

std::string TomlTable::string(std::string_view key) const {
  const toml::node& node = required(*this, node_, key, "a string");
  if (!node.is_string()) fail(key, "is " + kind_name(node), "a string was expected");
  return node.as_string()->get();
}

double TomlTable::number(std::string_view key) const {
  return finite_number(*this, required(*this, node_, key, "a number"), key);
}

std::int64_t TomlTable::integer(std::string_view key) const {
  const toml::node& node = required(*this, node_, key, "an integer");
  if (!node.is_integer()) fail(key, "is " + kind_name(node), "an integer was expected");
  return node.as_integer()->get();
}

bool TomlTable::boolean(std::string_view key) const {
  const toml::node& node = required(*this, node_, key, "true or false");
  if (!node.is_boolean()) fail(key, "is " + kind_name(node), "true or false was expected");
  return node.as_boolean()->get();
}

std::string TomlTable::string_or(std::string_view key, std::string fallback) const {
  return has(key) ? string(key) : std::move(fallback);
}

std::optional<double> TomlTable::optional_number(std::string_view key) const {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}

bool TomlTable::boolean_or(std::string_view key, bool fallback) const {
  return has(key) ? boolean(key) : fallback;
}

std::vector<std::string> TomlTable::strings(std::string_view key) const {
  const toml::node& node = required(*this, node_, key, "an array of strings");
  if (!node.is_array()) fail(key, "is " + kind_name(node), "an array of strings was expected");
  std::vector<std::string> values;
  for (const toml::node& element : *node.as_array()) {
    if (!element.is_string()) fail(key, "holds " + kind_name(element), "an array of strings was expected");
    values.push_back(element.as_string()->get());
  }
  return values;
}

std::vector<double> TomlTable::numbers(std::string_view key) const {
  const toml::node& node = required(*this, node_, key, "an array of numbers");
  if (!node.is_array()) fail(key, "is " + kind_name(node), "an array of numbers was expected");
  std::vector<double> values;
  for (const toml::node& element : *node.as_array()) values.push_back(finite_number(*this, element, key));
  return values;
}

std::vector<std::vector<double>> TomlTable::number_rows(std::string_view key) const {
  const toml::node& node = required(*this, node_, key, "an array of rows of numbers");
  if (!node.is_array()) fail(key, "is " + kind_name(node), "an array of rows of numbers was expected");
  std::vector<std::vector<double>> rows;
  for (const toml::node& row : *node.as_array()) {
    if (!row.is_array()) fail(key, "holds " + kind_name(row), "an array of rows of numbers was expected");
    std::vector<double> values;
    for (const toml::node& element : *row.as_array()) values.push_back(finite_number(*this, element, key));
    rows.push_back(std::move(values));
  }
  return rows;
}

std::vector<std::vector<std::string>> TomlTable::string_rows(std::string_view key) const {
  const toml::node& node = required(*this, node_, key, "an array of rows of strings");
  if (!node.is_array()) fail(key, "is " + kind_name(node), "an array of rows of strings was expected");
  std::vector<std::vector<std::string>> rows;
  for (const toml::node& row : *node.as_array()) {
    if (!row.is_array()) fail(key, "holds " + kind_name(row), "an array of rows of strings was expected");
    std::vector<std::string>& values = rows.emplace_back();
    for (const toml::node& element : *row.as_array()) {
      if (!element.is_string()) fail(key, "holds " + kind_name(element), "strings were expected");
      values.push_back(element.as_string()->get());
    }
  }
  return rows;
}

TomlTable TomlTable::table(std::string_view key) const {
  const toml::node& node = required(*this, node_, key, "a table");
  if (!node.is_table()) fail(key, "is " + kind_name(node), "a table was expected");
  return TomlTable(document_, node.as_table());
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  std::vector<TomlTable> found;
  if (!has(key)) return found;
  const toml::node& node = *as_table(node_).get(key);
  const std::string header = "[[" + std::string(key) + "]] tables were expected";
  if (!node.is_array()) fail(key, "is " + kind_name(node), header);
  for (const toml::node& element : *node.as_array()) {
    if (!element.is_table()) fail(key, "holds " + kind_name(element), header);
    found.push_back(TomlTable(document_, element.as_table()));
  }
  return found;
}

void TomlTable::refuse_unknown_keys(const std::vector<std::string_view>& known) const {
  for (const std::string& key : keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string right = "known here: ";
    for (std::size_t i = 0; i < known.size(); ++i) right += (i ? ", " : "") + std::string(known[i]);
    fail(key, "is not a known key", right);
  }
}

}  // namespace secular
