#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "estimator/model/compiled_model.hpp"

namespace secular::testing_support {

/// Where a model has a symbol of that name; std::out_of_range where it has none.
inline std::size_t symbol_of(const CompiledModel& model, const std::string& name) {
  const auto found = std::find_if(model.symbols.begin(), model.symbols.end(),
                                  [&](const CompiledSymbol& symbol) { return symbol.name == name; });
  if (found == model.symbols.end()) throw std::out_of_range(name);
  return static_cast<std::size_t>(found - model.symbols.begin());
}

}  // namespace secular::testing_support
