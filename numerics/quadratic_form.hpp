#pragma once

#include <Eigen/Core>

namespace secular {

/// Probability that a normal vector z of mean zero and this `covariance` has z'Az/z'z below `ratio`, exact up to
/// rounding (J. P. Imhof, Biometrika 48, 1961, 419-426). `form`: A, symmetric; of `covariance`, rows x rows, a
/// common factor does not matter. One where the covariance is zero.
double ratio_lower_tail(double ratio, const Eigen::MatrixXd& form, const Eigen::MatrixXd& covariance);

}  // namespace secular
