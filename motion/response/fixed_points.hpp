#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "motion/response/vector_field.hpp"

namespace secular {

struct FixedPointOptions {
  Eigen::VectorXd lower, upper;  ///< the box, [dimension]
  int start_limit = 600;
  int quiet_starts = 60;  ///< stop after so many starts in a row without a new root
  int paths = 3;          ///< directions in which paths are followed from every root; 0: none
  int root_limit = 100;
  double decades = 4;        ///< starts fill boxes shrunk about the centre by 1 down to 10^-decades
  double distinct = 1e-6;    ///< roots closer than this, in half widths of the box, are one
  double tolerance = 1e-10;  ///< last Newton step, in half widths of the box
};

struct FixedPoint {
  Eigen::VectorXd state;
  double residual = 0;           ///< norm of the rate there
  double last_step = 0;          ///< of Newton's method, in half widths of the box
  Eigen::VectorXcd eigenvalues;  ///< by falling real part
  int unstable = 0;
};

enum class FixedPointStatus {
  nothing_new,  ///< the last quiet_starts starts found nothing new: probably complete
  start_limit,  ///< new roots still turned up among the last quiet_starts starts
  root_limit,   ///< as many roots as allowed: they may not be isolated
};

struct FixedPoints {
  FixedPointStatus status = FixedPointStatus::start_limit;
  std::string reason;
  std::vector<FixedPoint> points;  ///< by distance from the centre of the box
  int starts = 0;                  ///< used
};

/// Fixed points in a box, by three means in turn:
/// Newton's method from the centre and from low-discrepancy starts (Roberts' R sequence) in boxes of log-spaced
/// sizes about the centre, until the last quiet_starts of them found nothing new; from each start, deflated runs in
/// which found roots repel (Farrell, Birkisson & Funke 2015), until one fails; from each root, the paths f(x) =
/// lambda d in `paths` directions d, which lead on to other roots (root_path.hpp). What the paths find is followed
/// in turn. The same input gives the same output.
///
/// Guaranteed: every point returned lies in the box and Newton's method, undeflated, has converged there to
/// `tolerance`; no two are closer than `distinct`. Not guaranteed: completeness. It is heuristic, with the stopping
/// rule of FixedPointStatus. At a multiple root (a bifurcation point) Newton's method converges slowly and its
/// accuracy is only about 1e-6. Throws std::invalid_argument for a box or limits that make no sense.
FixedPoints find_fixed_points(const VectorField& field, const Eigen::Ref<const Eigen::VectorXd>& parameters,
                              const FixedPointOptions& options);

}  // namespace secular
