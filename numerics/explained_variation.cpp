#include "numerics/explained_variation.hpp"

#include <Eigen/Dense>

#include "numerics/distribution.hpp"

namespace secular {

double ExplainedVariation::p_value() const {
  return f_upper_tail((all - left) / (rank - 1) / (left / freedom), rank - 1, freedom);
}

ExplainedVariation explained_variation(const Eigen::VectorXd& values, const Eigen::MatrixXd& functions) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(functions);
  const Eigen::VectorXd constant = functions.col(0).normalized();
  ExplainedVariation result;
  result.rank = static_cast<double>(fit.rank());
  result.freedom = static_cast<double>(values.size()) - result.rank;
  result.all = (values - constant * constant.dot(values)).squaredNorm();
  result.left = (values - functions * Eigen::VectorXd(fit.solve(values))).squaredNorm();
  return result;
}

}  // namespace secular
