#pragma once

#include <Eigen/Dense>

namespace secular {

/// Singular directions of a Jacobian in columns of unit length (zero where nothing moves the rows). There are many
/// more rows than unknowns: they are turned into the columns' span first, J = QR, and R = USV' is small.
class Directions {
 public:
  explicit Directions(const Eigen::MatrixXd& jacobian);

  Eigen::Index rank() const { return rank_; }
  double value(Eigen::Index i) const { return svd_.singularValues()(i); }
  /// Of the unknowns, in columns of unit length: the first rank() ones are seen.
  const Eigen::MatrixXd& of_unknowns() const { return svd_.matrixV(); }
  /// One over the columns' lengths.
  const Eigen::VectorXd& per_length() const { return per_length_; }

  /// The Jacobian times this has orthonormal columns, one for each direction that is seen.
  Eigen::MatrixXd to_orthonormal() const;
  /// Rows along every direction.
  Eigen::VectorXd along(const Eigen::VectorXd& rows) const;
  /// The step that takes rows away: of minimum norm in columns of unit length.
  Eigen::VectorXd step(const Eigen::VectorXd& rows, double damping) const;

 private:
  Eigen::VectorXd per_length_;
  Eigen::HouseholderQR<Eigen::MatrixXd> turned_;
  Eigen::JacobiSVD<Eigen::MatrixXd> svd_;
  Eigen::Index rank_ = 0;
};

/// Corrects slopes by what a step showed of them (Broyden 1965): how the rows have changed.
void correct_slopes(Eigen::MatrixXd& jacobian, const Eigen::VectorXd& step, const Eigen::VectorXd& change);

}  // namespace secular
