#pragma once

#include <Eigen/Core>

namespace secular {

/// How much of values of unit variance, up to a common factor, a combination of functions explains beyond what the
/// first of them, the constant, does.
struct ExplainedVariation {
  double rank = 0, freedom = 0;  ///< of the functions, and what they leave
  double all = 0, left = 0;      ///< sums of squares beside the constant, beside all functions

  /// That functions which explain nothing explain as much (F law); of rank 2 at least, with something left.
  double p_value() const;
};

/// `functions`: values x functions.
ExplainedVariation explained_variation(const Eigen::VectorXd& values, const Eigen::MatrixXd& functions);

}  // namespace secular
