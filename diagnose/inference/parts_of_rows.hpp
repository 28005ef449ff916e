#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/inference/refit.hpp"

namespace secular {

/// Do parts of the rows tell the same numbers? What numbers of each part's own would take off the rows' squares,
/// in units of their noise (docs/inference.md (65)).
struct PartsAgreement {
  double chi_squared = 0, freedom = 0;
  double p_value = 1;

  /// Variance of what parts tell over what independent rows make of it; 1 where they differ no more than these do.
  double dispersion() const;
};

/// `part`: by row, equal for rows of one part. Of fewer than two parts, or a fit that sees nothing, there is
/// nothing to compare: no degrees of freedom.
PartsAgreement agreement_of_parts(const Refit& fit, const std::vector<int>& part);

/// By row, as agreement_of_parts() takes them: folds, in which a misfit along a record shows.
std::vector<int> parts_by_fold(const std::vector<RowLabel>& labels);

/// By row: records; of a single record its folds, in order, until they hold half of what all rows tell, and the
/// others.
std::vector<int> large_parts(const Refit& fit, const std::vector<RowLabel>& labels);

}  // namespace secular
