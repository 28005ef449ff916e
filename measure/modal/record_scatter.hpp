#pragma once

#include <Eigen/Core>
#include <vector>

#include "measure/modal/fit_residual.hpp"

namespace secular {

/// What differences between records add to the variance of one unknown.
struct RecordScatter {
  double variance = 0;            ///< of the common fit, in the unknown's unit squared; zero where they show none
  double degrees_of_freedom = 0;  ///< with which it is known; zero: fewer than three records tell
};

/// Eq. (M8), by unknown ((real, imaginary part) of each pole): the true values of records scatter by as much as the
/// steps from the common fit exceed the records' own noise. Nothing of fewer than three records.
std::vector<RecordScatter> record_scatter(const std::vector<PoleInformation>& records);

/// Inverse of a symmetric matrix without negative eigenvalues, of whatever scale; directions that it does not tell,
/// to rounding, have none.
Eigen::MatrixXd inverse_of_positive(const Eigen::MatrixXd& matrix);

}  // namespace secular
