#include "estimator/identification/beyond_chance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {

double beyond_chance(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& target, Eigen::Index at, double freedom,
                     double trusted) {
  const Eigen::VectorXd found = matrix.colPivHouseholderQr().solve(target);
  const double scatter = std::max(1.0, (target - matrix * found).squaredNorm() / freedom);
  const double variance = (matrix.transpose() * matrix).inverse()(at, at) * scatter;
  const double by_chance = f_upper_quantile(estimator_thresholds().contradiction_alarm, 1, freedom);
  const double counts = trusted * (1 - by_chance * variance / (found(at) * found(at)));
  return counts > 0 ? found(at) * std::sqrt(counts) : 0;
}

}  // namespace secular
