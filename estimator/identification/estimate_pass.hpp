#pragma once

#include <Eigen/Core>
#include <memory>

#include "estimator/identification/shared_parameters.hpp"

namespace secular {

struct EstimationState;

/// One estimate of the loop that takes out the expansion's truncation (correct_truncation), docs/inference.md (11)
/// to (13): where it begins, what it knows of the correction, and what it may leave out. By default an estimate by
/// itself, from nothing.
struct EstimatePass {
  /// Only the next pass reads its numbers: parameters' error bars come by way of the lumps', which are wider,
  /// instead of from the rows; there is no bootstrap, and damping laws are not compared.
  bool between = false;
  /// Whether equations that do not hold as well as repeats agree widen the error bars: not before the truncation is
  /// taken out, which would be the larger part of what is seen.
  bool judge_fit = true;
  /// Of the same observations: which equations are regressed, and coefficients and weights near the final ones.
  std::shared_ptr<const EstimationState> start = nullptr;
  /// With a start: weights are those that its coefficients make, and are not found anew: only the correction has
  /// changed a little.
  bool keep_weights = false;
  /// Symbols x moves: where parameters were moved to see how the correction depends on them, see
  /// ObservationSet::truncation_of_moves: lumps are fitted as they would be corrected at the parameters that fit
  /// them. Empty: not known.
  Eigen::MatrixXd moves = {};
  Eigen::VectorXd corrected_at = {};     ///< with moves: the parameters that ObservationSet::truncation belongs to
  NullSpacePlace null_space_place = {};  ///< along the directions of ObservationSet::truncation_change
};

/// A pass between, not judged.
inline EstimatePass pass_between() {
  return {.between = true, .judge_fit = false};
}

}  // namespace secular
