#include "estimator/identification/row_noise.hpp"

#include <Eigen/Dense>

namespace secular {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Equations that share all their noise (noise-free data, or a common error) stay a little apart.
constexpr double apart = 1e-9;

MatrixXd correlation_of(const EquationData::Rows& rows, const VectorXd& sd) {
  MatrixXd covariance = rows.variants * rows.variants.transpose();
  covariance.diagonal() += rows.own_variance;
  const VectorXd inverse_sd = sd.cwiseInverse();
  MatrixXd correlation = inverse_sd.asDiagonal() * covariance * inverse_sd.asDiagonal();
  correlation.diagonal().array() += apart;
  return correlation;
}

}  // namespace

VectorXd row_noise_sd(const EquationData::Rows& rows) {
  return (rows.variants.rowwise().squaredNorm() + rows.own_variance).cwiseSqrt();
}

RowNoise::RowNoise(const EquationData::Rows& rows)
    : sd(row_noise_sd(rows)), correlation(correlation_of(rows, sd)) {}

MatrixXd RowNoise::whitened(const MatrixXd& of_rows) const {
  return correlation.matrixL().solve(MatrixXd(sd.cwiseInverse().asDiagonal() * of_rows));
}

}  // namespace secular
