#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "diagnose/inference/gap_span.hpp"
#include "diagnose/inference/refit.hpp"

namespace secular {

/// Rows of every fold as predicted by a fit that never saw that fold.
struct HeldOut {
  Eigen::VectorXd rows;
  bool possible = false;  ///< false: fewer than three folds; rows are then those of the fit itself
};

/// Folds are gathered into at most eight groups that mix them; each is predicted by a fit to the others, from the
/// fit to everything on.
HeldOut predict_held_out(const Discrepancy& discrepancy, const Refit& fit, const std::vector<RowLabel>& labels);

/// Share of the gap closed, from -1 to 1, and its 95 % interval when conditions are drawn again (bootstrap, seeded,
/// docs/inference.md (30)). Of fewer than three conditions nothing says what it would be in another: from -1 to 1.
/// The share is that of what lies in `span` and along the change itself; before and after are root mean squares of
/// all rows.
struct ClosedShare {
  double before = 0, after = 0, closed = 0, low = 0, high = 0;
};
ClosedShare closed_share(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                         const std::vector<RowLabel>& labels, double floor, const GapSpan& span = {});

/// Whether rows are less `after` than `before` by more than the conditions differ in it (docs/inference.md (31)),
/// so that no few of them alone say so.
bool repeats(const Eigen::VectorXd& before, const Eigen::VectorXd& after, const std::vector<RowLabel>& labels);

/// Share of the gap of `null` that a column closes which means nothing, as a control on what is said of those that
/// mean something: `signature`, the change of the rows by an explanation, with a sign drawn for every condition
/// (seeded; mean over several draws), fitted to first order with all of the null's unknowns beside it and judged on
/// conditions that were held out. Zero but for chance. Nothing with fewer than three folds.
std::optional<double> placebo_closed(const Refit& null, const Eigen::VectorXd& signature,
                                     const std::vector<RowLabel>& labels, double floor, const GapSpan& span = {});

}  // namespace secular
