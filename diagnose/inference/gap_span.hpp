#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/inference/explanation.hpp"

namespace secular {

/// Directions of the rows along which the model's numbers and the explanations that were fitted move them: a gap
/// that any of them can close lies there (docs/inference.md, "A weak gap in many rows").
class GapSpan {
 public:
  /// All directions: every row counts as it is.
  GapSpan() = default;
  /// Of slopes and finite changes, rows x any number of columns.
  explicit GapSpan(const Eigen::MatrixXd& columns);
  /// With one direction more; all of them stay all.
  GapSpan with(const Eigen::VectorXd& column) const;

  /// By row: its square. What it has beside these directions beyond the expected, `floor` squared for a row that is
  /// all beside them, counts by how much its fold is moved along them, and not at all where folds together have
  /// less than is expected (docs/inference.md (49), (49a)).
  Eigen::VectorXd squares(const Eigen::VectorXd& rows, const std::vector<RowLabel>& labels, double floor) const;

 private:
  Eigen::MatrixXd basis_;  // orthonormal; empty: all directions
};

/// Of the model as it is, of every explanation by its members' unknowns and by what it changes in all, and of rows
/// before the model's numbers were fitted (empty: there are none).
GapSpan span_of_gap(const Refit& null, const std::vector<Explanation>& explanations,
                    const Eigen::VectorXd& unfitted);

}  // namespace secular
