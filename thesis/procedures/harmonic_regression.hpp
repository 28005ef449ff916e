#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/regression/linear_fit.hpp"

namespace secular {

/// Complex equations target = columns * coefficients with real coefficients, one a row; rows of one condition are
/// its ensembles.
struct HarmonicData {
  Eigen::MatrixXcd columns;
  Eigen::VectorXcd target;
  std::vector<int> condition;
};

struct HarmonicFit {
  Eigen::MatrixXd by_condition;  ///< [condition][coefficient]: each condition's ensembles alone
  std::vector<int> conditions;   ///< labels of its rows
  Eigen::VectorXd mean, sd;      ///< of the columns of by_condition: the numbers in the thesis's tables
  LinearFit pooled;              ///< all rows at once, clustered by condition
};

/// Least squares over real and imaginary parts, thesis Eqs. (5.38), (6.43)-(6.48): repeated for every condition, as
/// the thesis does, and once for all. Throws std::invalid_argument for sizes that differ or no rows.
HarmonicFit harmonic_regression(const HarmonicData& data);

}  // namespace secular
