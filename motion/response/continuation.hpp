#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "motion/response/curve_tracer.hpp"
#include "motion/response/equilibrium.hpp"
#include "motion/response/vector_field.hpp"

namespace secular {

struct ContinuationOptions {
  double lower = 0, upper = 1;  ///< of the continued parameter
  /// Bound of |state_i| over its typical magnitude.
  double state_bound = std::numeric_limits<double>::infinity();
  double parameter_scale = 0;  ///< length that counts as one in the parameter; 0: upper - lower
  StepOptions steps;
};

/// A branch of fixed points f(x, p) = 0 in one parameter, from one end to the other.
struct Branch {
  Eigen::Index parameter = 0;
  std::vector<Equilibrium> points;
  std::vector<SpecialPoint> special;  ///< by arclength
  TraceEnd first_end, last_end;       ///< how points.front() and points.back() came about
  bool closed = false;                ///< points.back() is points.front() again
};

/// The branch through the fixed point near `state` (Newton's method at the given parameters), traced both ways in
/// `parameter` by pseudo-arclength continuation; `parameters` holds all of them.
///
/// Special points are seen by sign changes of test functions from point to point: the parameter's component of the
/// tangent (saddle-node), det [f_x f_p; tangent'] (branch point), the product of pairwise sums of eigenvalues
/// (Hopf; neutral saddles are left out). Steps over which the number of unstable eigenvalues changes otherwise than
/// these explain are shortened. Located by Newton's method on minimally augmented equations
/// (augmented_systems.hpp). What begins and ends within one step leaves no trace in either and is missed: lower
/// steps.largest then.
///
/// Numerical failure is a status of the ends (TraceStatus::no_start with no points where Newton's method finds no
/// fixed point within the bounds). Throws std::invalid_argument for sizes, bounds or steps that make no sense and
/// for a start whose parameter is out of bounds.
Branch continue_fixed_points(const VectorField& field, const Eigen::Ref<const Eigen::VectorXd>& parameters,
                             Eigen::Index parameter, const Eigen::Ref<const Eigen::VectorXd>& state,
                             const ContinuationOptions& options);

/// The branch that crosses the one `crossing` was found on, traced both ways; it passes `crossing` again. Throws
/// std::invalid_argument if that is no pitchfork or transcritical point.
Branch switch_branch(const VectorField& field, const Eigen::Ref<const Eigen::VectorXd>& parameters,
                     Eigen::Index parameter, const SpecialPoint& crossing, const ContinuationOptions& options);

}  // namespace secular
