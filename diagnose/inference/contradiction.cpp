#include "diagnose/inference/contradiction.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "diagnose/inference/screening.hpp"
#include "numerics/orthonormal_span.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Directions that the data see this much less than the best one are rounding.
constexpr double rounding = 1e-9;

}  // namespace

Contradiction contradiction(const Refit& fit, const VectorXd& given, const VectorXd& sd) {
  const auto count = static_cast<Index>(fit.free.size());
  if (given.size() != count || sd.size() != count)
    throw std::invalid_argument("contradiction: one number and one error bar a free unknown");
  std::vector<Index> said, open;
  for (Index f = 0; f < count; ++f) (std::isfinite(sd(f)) ? said : open).push_back(f);
  Contradiction result;
  if (said.empty()) return result;
  // By scaled unknowns. With J = U S V^T of what the data tell: x^T (1 + S V^T D^2 V S)^-1 x, x = S V^T d.
  MatrixXd told = fit.jacobian(Eigen::all, said);
  if (!open.empty()) told = without_span(basis_of(fit.jacobian(Eigen::all, open)), told);
  VectorXd d(told.cols()), error(told.cols());
  for (Index i = 0; i < told.cols(); ++i) {
    const Index f = said[static_cast<std::size_t>(i)];
    const double scale = fit.scale(f) > 0 ? fit.scale(f) : 1;
    d(i) = (given(f) - fit.unknowns(static_cast<Index>(fit.free[static_cast<std::size_t>(f)]))) / scale;
    error(i) = sd(f) / scale;
  }
  const Eigen::BDCSVD<MatrixXd> svd(told, Eigen::ComputeThinV);
  const VectorXd& s = svd.singularValues();
  result.rank = (s.array() > rounding * s(0)).count();
  const MatrixXd seen = s.head(result.rank).asDiagonal() * svd.matrixV().leftCols(result.rank).transpose();
  const VectorXd x = seen * d;
  const MatrixXd noise = seen * error.asDiagonal();
  const MatrixXd covariance = MatrixXd::Identity(result.rank, result.rank) + noise * noise.transpose();
  result.chi_squared = x.dot(covariance.ldlt().solve(x));
  return result;
}

}  // namespace secular
