#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/effects/candidate.hpp"
#include "diagnose/evidence/discrepancy.hpp"

namespace secular {

/// A share of the gap: rows of one kind.
struct GapShare {
  std::string mode;  ///< coordinate or channel
  EffectComponent component = EffectComponent::measurement;
  std::string harmonic, region;
  double share = 0;
};

/// Shares of a gap by mode or channel, component, harmonic and amplitude, largest first; those below 2 % are left
/// out. `rows` in units of repeatability by `labels`, `unmixed`: see Discrepancy::unmixed. `named`: the cause where
/// one is known (null otherwise); balances of its mode belong to its component then, where in phase and in
/// quadrature are all that can be said without.
std::vector<GapShare> gap_shares(const Eigen::VectorXd& rows, const Eigen::VectorXd& unmixed,
                                 const std::vector<RowLabel>& labels, const Candidate* named);

}  // namespace secular
