#pragma once

#include <Eigen/Core>

namespace secular {

/// Orthonormal columns that span what `columns` adds to the orthonormal ones of `basis`; zero where one adds
/// nothing.
Eigen::MatrixXd orthonormal_beyond(const Eigen::MatrixXd& basis, Eigen::MatrixXd columns);

/// Directions in which the errors of a segment move, as orthonormal columns, samples*channels long: what is
/// eliminated from its rows, E_x and Z of docs/inference.md (36), and what makes its first rows.
struct ErrorDirections {
  Eigen::MatrixXd of_state;   ///< foreign content, then what the state adds to it
  Eigen::MatrixXd of_change;  ///< what a change of every mode's stiffness and damping adds to these
  Eigen::Index foreign = 0;   ///< columns of the first that are foreign content's

  ErrorDirections() = default;
  /// From columns of any length.
  ErrorDirections(const Eigen::MatrixXd& foreign_columns, const Eigen::MatrixXd& state_columns,
                  const Eigen::MatrixXd& change_columns);

  /// How many there are.
  Eigen::Index count() const { return of_state.cols() + of_change.cols(); }
  /// Those that move with a motion: of its state and of changes.
  Eigen::MatrixXd of_motion() const;
};

}  // namespace secular
