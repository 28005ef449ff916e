#pragma once

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// Derivatives of a lump N/D by the model's parameters, zeros left out. Where D is a sum they are written
///   d(N/D)/dp = (dN/dp - N/D dD/dp)/D,
/// which is many times shorter than the expanded quotient; otherwise they are rational functions by themselves.
struct LumpGradient {
  struct Entry {
    std::size_t parameter = 0;  ///< index into CanonicalModel::parameters
    std::size_t symbol = 0;     ///< its index into CanonicalModel::order
    RationalFunction rate;      ///< d(N/D)/dp, or dN/dp where `shared` is true
    RationalFunction denominator_rate;
  };
  bool shared = false;
  RationalFunction denominator;  ///< D, where `shared` is true
  std::vector<Entry> entries;
};

/// `definition`: N/D in the symbols of CanonicalModel::order.
LumpGradient lump_gradient(const CanonicalModel& model, const RationalFunction& definition);

}  // namespace secular
