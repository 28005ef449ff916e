#include "measure/modal/record_scatter.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd inverse_of_positive(const MatrixXd& matrix) {
  const VectorXd shorten = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(
      MatrixXd(shorten.asDiagonal() * matrix * shorten.asDiagonal()));
  VectorXd values = spectrum.eigenvalues();
  const double least = 1e-10 * values.maxCoeff();
  for (double& v : values) v = v > least ? 1 / v : 0;
  return shorten.asDiagonal() *
         MatrixXd(spectrum.eigenvectors() * values.asDiagonal() * spectrum.eigenvectors().transpose()) *
         shorten.asDiagonal();
}

std::vector<RecordScatter> record_scatter(const std::vector<PoleInformation>& records) {
  if (records.empty()) return {};
  const Index unknowns = records.front().gradient.size(), count = static_cast<Index>(records.size());
  std::vector<RecordScatter> found(static_cast<std::size_t>(unknowns));
  if (count < 3) return found;
  MatrixXd steps(count, unknowns), weights(count, unknowns);
  for (Index j = 0; j < count; ++j) {
    const PoleInformation& record = records[static_cast<std::size_t>(j)];
    const MatrixXd covariance = inverse_of_positive(record.hessian);
    steps.row(j) = (covariance * record.gradient).transpose();
    for (Index u = 0; u < unknowns; ++u) weights(j, u) = covariance(u, u) > 0 ? 1 / covariance(u, u) : 0;
  }
  for (Index u = 0; u < unknowns; ++u) {
    const double all = weights.col(u).sum(), squares = weights.col(u).squaredNorm();
    if (!(all > 0) || !(all * all > squares)) continue;
    const double mean = weights.col(u).dot(steps.col(u)) / all;
    const double spread = (weights.col(u).array() * (steps.col(u).array() - mean).square()).sum();
    const auto freedom = static_cast<double>((weights.col(u).array() > 0).count() - 1);
    if (freedom < 2) continue;
    const double between = std::max(0.0, (spread - freedom) / (all - squares / all));
    found[static_cast<std::size_t>(u)] = {between * squares / (all * all), freedom};
  }
  return found;
}

}  // namespace secular
