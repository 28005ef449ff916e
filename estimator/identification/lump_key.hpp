#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// A lump's name means something in its own case alone: the same name may stand for another combination in another
/// case. (A symbol of the model means the same in every case.)
struct LumpKey {
  std::string resonance, name;
  auto operator<=>(const LumpKey&) const = default;
};

using LumpValues = std::map<LumpKey, double>;

inline LumpKey key_of(const CompiledCase& resonance, std::size_t lump) {
  return {std::string(resonance.name), std::string(resonance.lumps[lump].name)};
}

/// Whether the lump is this symbol of the model and nothing else.
inline bool is_symbol(const CompiledLump& lump, std::string_view symbol) {
  return lump.name == symbol && lump.definition == symbol;
}

}  // namespace secular
