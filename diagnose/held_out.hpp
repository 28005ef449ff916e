#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/refit.hpp"

namespace secular {

/// Rows of every fold as predicted by a fit that never saw that fold.
struct HeldOut {
  Eigen::VectorXd rows;
  bool possible = false;  ///< false: fewer than three folds; rows are then those of the fit itself
};

/// Folds are gathered into at most `groups` groups that mix them; each is predicted from the others by two
/// Gauss-Newton steps from the fit to everything.
HeldOut predict_held_out(const Discrepancy& discrepancy, const Refit& fit, const std::vector<RowLabel>& labels,
                         int groups = 8);

/// Shares of the gap closed and its spread when conditions are drawn again (bootstrap, seeded).
struct ClosedShare {
  double before = 0, after = 0, closed = 0, low = 0, high = 0;
};
ClosedShare closed_share(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                         const std::vector<RowLabel>& labels, double floor);

}  // namespace secular
