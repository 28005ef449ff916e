#include "diagnose/evidence/error_directions.hpp"

#include <Eigen/Dense>
#include <utility>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;

// Twice, as what rounding leaves of the first pass is as large as short columns are.
MatrixXd orthonormal_beyond(const MatrixXd& basis, MatrixXd columns) {
  for (int pass = 0; pass < 2; ++pass)
    if (basis.cols() > 0) columns -= basis * (basis.transpose() * columns);
  for (Index i = 0; i < columns.cols(); ++i) {
    for (int pass = 0; pass < 2; ++pass)
      for (Index j = 0; j < i; ++j) columns.col(i) -= columns.col(j) * columns.col(j).dot(columns.col(i));
    const double length = columns.col(i).norm();
    if (length > 1e-12)
      columns.col(i) /= length;
    else
      columns.col(i).setZero();
  }
  return columns;
}

ErrorDirections::ErrorDirections(const MatrixXd& foreign_columns, const MatrixXd& state_columns,
                                 const MatrixXd& change_columns)
    : of_state(state_columns.rows(), foreign_columns.cols() + state_columns.cols()),
      foreign(foreign_columns.cols()) {
  of_state << orthonormal_beyond(MatrixXd(), foreign_columns),
      MatrixXd::Zero(state_columns.rows(), state_columns.cols());
  of_state.rightCols(state_columns.cols()) = orthonormal_beyond(of_state.leftCols(foreign), state_columns);
  of_change = orthonormal_beyond(of_state, change_columns);
}

MatrixXd ErrorDirections::of_motion() const {
  MatrixXd columns(of_state.rows(), count() - foreign);
  columns << of_state.rightCols(of_state.cols() - foreign), of_change;
  return columns;
}

}  // namespace secular
