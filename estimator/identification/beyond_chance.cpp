#include "estimator/identification/beyond_chance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {

double beyond_chance(double ratio, double freedom, double alarm, double numerator) {
  return std::max(0.0, 1 - f_upper_tail(ratio, numerator, freedom) / alarm);
}

double beyond_chance(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& target, Eigen::Index at, double freedom,
                     double trusted) {
  const Eigen::VectorXd found = matrix.colPivHouseholderQr().solve(target);
  const double scatter = std::max(1.0, (target - matrix * found).squaredNorm() / freedom);
  const double variance = (matrix.transpose() * matrix).inverse()(at, at) * scatter;
  const double alarm = estimator_thresholds().contradiction_alarm;
  return found(at) * beyond_chance(found(at) * found(at) / variance, freedom, alarm) * std::sqrt(trusted);
}

}  // namespace secular
