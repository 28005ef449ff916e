#pragma once

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// Derivatives of a lump by the model's parameters, zeros left out.
struct LumpGradient {
  struct Entry {
    std::size_t parameter = 0;  ///< index into CanonicalModel::parameters
    std::size_t symbol = 0;     ///< its index into CanonicalModel::order
    RationalFunction rate;
  };
  std::vector<Entry> entries;
};

/// `definition`: in the symbols of CanonicalModel::order.
LumpGradient lump_gradient(const CanonicalModel& model, const RationalFunction& definition);

}  // namespace secular
