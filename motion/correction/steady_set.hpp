#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "measure/observe/mode_frequencies.hpp"
#include "measure/observe/observation_set.hpp"
#include "motion/correction/balanced_motions.hpp"

namespace secular {

/// What a campaign of dwells would show without noise if the structure had other parameters: of every dwell the
/// steady motion of the full equations of motion (harmonic balance, BalancedMotions) at the excitation that its
/// ensembles agree on, the one near what was measured.
class SteadySet {
 public:
  /// `measured` and its model must outlive this. Throws std::invalid_argument for a case without excitation.
  SteadySet(const ObservationSet& measured, unsigned threads);

  /// Ensembles of one dwell are alike and keep the noise that they have. Nothing where a dwell has no steady motion
  /// there, or the case has more than two independent frequencies. Each dwell is looked for from the motion found
  /// last, first from the measured one.
  std::optional<ObservationSet> at(const Eigen::VectorXd& parameters);

 private:
  struct Dwell {
    std::size_t begin = 0, end = 0;  ///< its observations
    Observation latest;
    std::optional<BalancedMotions::Balanced> balanced;  ///< of `latest`
    Eigen::MatrixXd inverse;  ///< of the growth's derivative there: unknowns x growth; empty: not known
  };
  bool find(Dwell& dwell, const Eigen::VectorXd& parameters) const;

  const ObservationSet& measured_;
  BalancedMotions motions_;
  ModeFrequencies modes_;
  unsigned threads_;
  std::vector<Dwell> dwells_;
};

}  // namespace secular
