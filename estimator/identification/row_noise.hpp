#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "estimator/identification/equation_data.hpp"

namespace secular {

/// docs/inference.md (3): standard deviation of each row of an observation, as the noise of what was measured makes
/// it.
Eigen::VectorXd row_noise_sd(const EquationData::Rows& rows);

/// The joint noise of an observation's rows.
struct RowNoise {
  explicit RowNoise(const EquationData::Rows& rows);

  /// Rows x any, in units of this noise and decorrelated.
  Eigen::MatrixXd whitened(const Eigen::MatrixXd& of_rows) const;

  Eigen::VectorXd sd;
  Eigen::LLT<Eigen::MatrixXd> correlation;
};

/// docs/inference.md (16): what is left of whitened rows beside a direction of length 1.
template <class Rows>
void take_out_direction(const Eigen::VectorXd& direction, Rows&& rows) {
  rows -= (direction * (direction.transpose() * rows)).eval();
}

}  // namespace secular
