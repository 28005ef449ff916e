#pragma once

#include <Eigen/Core>
#include <span>

#include "estimator/identification/case_regression.hpp"

namespace secular {

/// From `change`, rows x directions: how a step along the null space of one along each moves the whitened response
/// of the regression `fit`, whose rows belong to the conditions `condition`. Errors are those that the residuals
/// have, or, along combinations in which it is larger, the scatter of the conditions' contributions: equations that
/// lack something else as well differ from condition to condition. Nothing where the conditions are too few to see
/// that.
ResidualInformation residual_information(const Eigen::MatrixXd& change, const LinearFit& fit,
                                         std::span<const int> condition);

}  // namespace secular
