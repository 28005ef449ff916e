#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "measure/observe/observation_set.hpp"
#include "motion/correction/balanced_motions.hpp"

namespace secular {

/// What the full equations of motion do at the amplitudes of a set, by balance instead of integration: rates and
/// harmonics of every dwell at what its ensembles agree on (mean_motion), of a decay at every window.
class BalancedSet {
 public:
  /// `set` and its model must outlive this.
  BalancedSet(const ObservationSet& set, unsigned threads);

  /// The set with exact values: observations of one dwell are alike. They keep the noise that they have. Nothing
  /// where any motion has no balance.
  std::optional<ObservationSet> at(const Eigen::VectorXd& parameters);

 private:
  struct Group {
    Observation mean;
    std::size_t begin, end;
    std::optional<Motion> latest;  ///< to begin the next search with
  };

  const ObservationSet& set_;
  BalancedMotions motions_;
  std::vector<Group> groups_;
  unsigned threads_;
};

}  // namespace secular
