#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/inference/refit.hpp"

namespace secular {

/// Covariance of the free unknowns of a fit to `labels`' rows, as many of which as `freedom` says are independent:
/// what all rows leave says how large errors are (dispersion_of()), and where folds differ by more than that makes
/// of them, an error bar is what they differ by (docs/inference.md (43)). Correlations are those of the slopes.
/// `least_dispersion`: what is known to be left along directions that matter.
Eigen::MatrixXd covariance_of(const Refit& fit, const std::vector<RowLabel>& labels, double freedom,
                              double least_dispersion = 1);

}  // namespace secular
