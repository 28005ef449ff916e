#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/identification/case_regression.hpp"
#include "estimator/identification/equation_data.hpp"

namespace secular {

/// docs/inference.md (44), (45): what windows of a decay that overlap do to sums over whitened rows.
/// `rows_by_noise`: by observation with rows, in their order: whitened rows by varied quantity (EquationData), then
/// by each row's own noise.
WindowOverlap window_overlap(const CaseFit& fit, const EquationData& data,
                             const std::vector<Eigen::MatrixXd>& rows_by_noise);

}  // namespace secular
