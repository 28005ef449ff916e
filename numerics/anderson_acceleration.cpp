#include "numerics/anderson_acceleration.hpp"

#include <Eigen/Dense>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd AndersonAcceleration::next(const VectorXd& x, const VectorXd& value, const VectorXd& weight) {
  values_.push_back(value);
  remainders_.push_back(value - x);
  if (values_.size() > memory_ + 1) {
    values_.pop_front();
    remainders_.pop_front();
  }
  const auto differences = static_cast<Index>(values_.size()) - 1;
  if (differences == 0) return value;
  MatrixXd values(x.size(), differences), remainders(x.size(), differences);
  for (Index i = 0; i < differences; ++i) {
    const auto at = static_cast<std::size_t>(i);
    values.col(i) = values_[at + 1] - values_[at];
    remainders.col(i) = weight.cwiseProduct(remainders_[at + 1] - remainders_[at]);
    const double size = remainders.col(i).norm();
    if (!(size > 0)) return value;
    values.col(i) /= size;
    remainders.col(i) /= size;
  }
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(dependent_);
  solver.compute(remainders);
  return value - values * VectorXd(solver.solve(VectorXd(weight.cwiseProduct(remainders_.back()))));
}

VectorXd AndersonAcceleration::next(const VectorXd& x, const VectorXd& value) {
  return next(x, value, VectorXd::Ones(x.size()));
}

}  // namespace secular
