#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// Where a list of symbols, lumps or cases has an entry of that name; nothing where it has none.
template <typename List>
std::optional<std::size_t> place_of(const List& list, std::string_view name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.name == name; });
  if (found == list.end()) return std::nullopt;
  return static_cast<std::size_t>(found - list.begin());
}

/// By a name that the model is known to have; std::out_of_range where it has none.
inline std::size_t symbol_named(const CompiledModel& model, std::string_view name) {
  const std::optional<std::size_t> place = place_of(model.symbols, name);
  if (!place) throw std::out_of_range("model " + std::string(model.name) + " has no symbol " + std::string(name));
  return *place;
}

inline const CompiledCase& case_named(const CompiledModel& model, std::string_view name) {
  const std::optional<std::size_t> place = place_of(model.cases, name);
  if (!place) throw std::out_of_range("model " + std::string(model.name) + " has no case " + std::string(name));
  return model.cases[*place];
}

}  // namespace secular
