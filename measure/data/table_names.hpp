#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "measure/formats/data_file.hpp"

namespace secular {

/// The variables of a table by name, with the unit behind it or without. Remembers which of them were found, and
/// which of the parts that one named were asked for.
class TableNames {
 public:
  /// `given`: parts of a table ("f", "tip.phase") to variables.
  TableNames(std::string file, std::vector<DataVariable> variables, std::map<std::string, std::string> given);

  /// The variable that a part was given, if it was. Throws InputError where there is no such variable.
  std::optional<std::string> given(const std::string& part);
  /// The first of these names that is a variable's.
  std::optional<std::string> first_of(const std::vector<std::string>& candidates);

  bool has(const std::string& name) const;
  /// Of the variables, as messages list them: the first 20.
  std::string listed() const;
  const std::vector<DataVariable>& variables() const { return variables_; }
  /// Variables with numbers that were not found.
  std::vector<std::string> unused() const;
  /// Throws InputError for a part that nobody asked for.
  void require_known_parts() const;

 private:
  std::string file_;
  std::vector<DataVariable> variables_;
  std::map<std::string, std::string> given_;
  std::set<std::string> found_, asked_;
};

}  // namespace secular
