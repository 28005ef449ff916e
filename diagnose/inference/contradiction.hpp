#pragma once

#include <Eigen/Core>

#include "diagnose/inference/refit.hpp"

namespace secular {

/// By how much data contradict numbers that were given with error bars: chi-squared on `rank` degrees of freedom
/// where the numbers are right.
struct Contradiction {
  double chi_squared = 0;
  Eigen::Index rank = 0;
};

/// To first order about `fit`, the data's own choice: d^T (I^-1 + D^2)^-1 d with d the given numbers minus the
/// fitted ones, I what the data tell of them beside those of which nothing was said, and D the given standard
/// deviations. `given` and `sd` by Refit::free; an sd of 0: exact; infinite: nothing was said.
Contradiction contradiction(const Refit& fit, const Eigen::VectorXd& given, const Eigen::VectorXd& sd);

}  // namespace secular
