#include "measure/data/table_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "input/input_error.hpp"
#include "measure/formats/number_table.hpp"

namespace secular {
namespace {

bool is_called(const DataVariable& variable, const std::string& name) {
  return variable.name == name || bracketed_unit(variable.name).name == name;
}

}  // namespace

TableNames::TableNames(std::string file, std::vector<DataVariable> variables,
                       std::map<std::string, std::string> given)
    : file_(std::move(file)), variables_(std::move(variables)), given_(std::move(given)) {}

std::optional<std::string> TableNames::given(const std::string& part) {
  const auto at = given_.find(part);
  if (at == given_.end()) return std::nullopt;
  asked_.insert(part);
  const auto found = first_of({at->second});
  if (!found)
    throw InputError(file_, "column " + part, fmt::format("there is no variable '{}'", at->second),
                     "its variables are " + listed());
  return found;
}

std::optional<std::string> TableNames::first_of(const std::vector<std::string>& candidates) {
  for (const std::string& name : candidates)
    for (const DataVariable& variable : variables_)
      if (is_called(variable, name)) {
        found_.insert(variable.name);
        return variable.name;
      }
  return std::nullopt;
}

bool TableNames::has(const std::string& name) const {
  return std::any_of(variables_.begin(), variables_.end(),
                     [&](const DataVariable& variable) { return is_called(variable, name); });
}

std::string TableNames::listed() const {
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, variables_.size()); ++i) list += (i ? ", " : "") + variables_[i].name;
  return list + (variables_.size() > most ? fmt::format(" and {} more", variables_.size() - most) : "");
}

std::vector<std::string> TableNames::unused() const {
  std::vector<std::string> names;
  for (const DataVariable& variable : variables_)
    if (found_.count(variable.name) == 0 && variable.fault.empty()) names.push_back(variable.name);
  return names;
}

void TableNames::require_known_parts() const {
  for (const auto& [part, variable] : given_)
    if (asked_.count(part) == 0)
      throw InputError(file_, "column " + part, "belongs to no channel of the table",
                       "parts are f, condition, and CHANNEL, CHANNEL.phase, .re, .im, .sd, .phase_sd, also of "
                       "CHANNEL@N at N times the excitation's frequency");
}

}  // namespace secular
