#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace secular {

/// A table of a TOML file, read with checks: every complaint is an InputError that names the file, the line, the
/// key and what was expected. Keys that nobody asked for are found by `refuse_unknown_keys` (a misspelt key is an
/// error, not a default). A value type: copies share the parsed document.
class TomlTable {
 public:
  /// Parses the file. Throws InputError if it cannot be read or is not TOML.
  static TomlTable from_file(const std::filesystem::path& path);
  /// Parses text; `name` stands for the file in messages.
  static TomlTable from_text(std::string_view text, std::string name);

  /// As messages name it.
  const std::string& file() const;
  /// Line of this table's header or of the value of `key`, counted from 1.
  std::uint32_t line() const;
  std::uint32_t line_of(std::string_view key) const;
  /// Line on which the characters of a string value begin: one line below the key for """ with a line break after
  /// it.
  std::uint32_t first_text_line_of(std::string_view key) const;

  /// Whatever its value is.
  bool has(std::string_view key) const;
  bool is_string(std::string_view key) const;  ///< whether it is there and of that type
  std::vector<std::string> keys() const;       ///< in alphabetical order

  // Values of a key, which must be there and of that type; `..._or` and `optional_...` ask no more of a key than
  // that its value, if there is one, is of that type.
  std::string string(std::string_view key) const;
  double number(std::string_view key) const;  ///< integer or float, finite
  std::int64_t integer(std::string_view key) const;
  bool boolean(std::string_view key) const;
  std::string string_or(std::string_view key, std::string fallback) const;
  std::optional<double> optional_number(std::string_view key) const;
  bool boolean_or(std::string_view key, bool fallback) const;
  std::vector<std::string> strings(std::string_view key) const;                   ///< array of strings
  std::vector<double> numbers(std::string_view key) const;                        ///< array of numbers
  std::vector<std::vector<double>> number_rows(std::string_view key) const;       ///< array of arrays of numbers
  std::vector<std::vector<std::string>> string_rows(std::string_view key) const;  ///< array of arrays of strings
  TomlTable table(std::string_view key) const;                                    ///< [key], which must be there
  std::vector<TomlTable> tables(std::string_view key) const;                      ///< [[key]]; empty if absent

  /// Throws InputError for the first key of this table that is not in `known`.
  void refuse_unknown_keys(const std::vector<std::string_view>& known) const;
  /// An InputError at the line of `key` of this table.
  [[noreturn]] void fail(std::string_view key, std::string wrong, std::string right = {}) const;

 private:
  struct Document;
  TomlTable(std::shared_ptr<const Document> document, const void* node)
      : document_(std::move(document)), node_(node) {}
  std::shared_ptr<const Document> document_;
  const void* node_;  // toml::table inside *document_
};

}  // namespace secular
