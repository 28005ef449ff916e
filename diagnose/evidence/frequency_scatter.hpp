#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"

namespace secular {

/// Natural frequencies that differ from record to record by chance, as temperature, clamping and joints make them:
/// no law, but a variance. docs/inference.md (24).
struct FrequencyScatter {
  double relative_sd = 0;  ///< of a natural frequency between records
  double p_value = 1;      ///< that frequencies which do not scatter look like this
  /// What the rows leave along those changes, as rows, and how many of the changes are independent.
  Eigen::VectorXd along;
  double freedom = 0;
  std::vector<std::size_t> records;
  Eigen::MatrixXd shifts;  ///< record x mode: what each is likely to have been off by, relative
};

/// By the moments of what rows leave along a change of the natural frequencies of each record. `rows` and
/// `jacobian`: of a fit at unit variances, without scatter; `changes`: rows x modes, by a relative change of each
/// natural frequency; `freedom`: of all rows; `labels` belong to them. A mode that fewer than eight records show
/// tells nothing.
FrequencyScatter frequency_scatter(const Eigen::VectorXd& rows, const Eigen::MatrixXd& jacobian,
                                   const Eigen::MatrixXd& changes, const std::vector<RowLabel>& labels,
                                   double freedom);

}  // namespace secular
