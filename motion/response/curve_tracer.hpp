#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "motion/response/newton.hpp"

namespace secular {

/// How one end of a traced curve came about.
enum class TraceStatus {
  parameter_bound,  ///< the continued parameter reached its bound; the last point lies on it
  state_bound,      ///< a state reached its bound; the last point lies on it
  closed_loop,      ///< back at the start; the last point is the start
  special_end,      ///< a point beyond which the curve means something else (Hopf curve at a double zero)
  not_persistent,   ///< a curve of branch points that a second parameter unfolds
  point_limit,
  step_too_small,  ///< the corrector fails at the smallest step
  no_start,        ///< no solution near the start
};

struct TraceEnd {
  TraceStatus status = TraceStatus::no_start;
  std::string reason;
};

/// Steps along a curve in scaled unknowns (states over their typical magnitude, parameters over their range).
struct StepOptions {
  double first = 0.005, least = 1e-8, largest = 0.02;
  double turn = 0.1;  ///< rad, of the tangent from point to point, aimed at; three times as much is refused
  int point_limit = 5000;
};

/// A point of a curve in R^(N+1), with its unit tangent.
struct CurvePoint {
  Eigen::VectorXd unknowns, tangent;
};

/// lower <= unknown `coordinate` <= upper.
struct CurveBound {
  Eigen::Index coordinate = 0;
  double lower = 0, upper = 0;
  TraceStatus status = TraceStatus::parameter_bound;
  std::string name;
};

/// What the caller thinks of an accepted step.
enum class Visit { accept, shorten, stop };

/// Called for every step with whether it may still be shortened. After Visit::stop the visitor says why in `end`.
using StepVisitor =
    std::function<Visit(const CurvePoint& from, const CurvePoint& to, bool may_shorten, TraceEnd& end)>;

/// Solution of `curve` (N equations, N + 1 unknowns) in the hyperplane normal . (y - guess) = 0, by Newton's
/// method.
NewtonResult correct(const EquationSystem& curve, const Eigen::Ref<const Eigen::VectorXd>& guess,
                     const Eigen::Ref<const Eigen::VectorXd>& normal);

/// Unit null vector of the curve's Jacobian with a positive component along `reference`: [J; reference'] t =
/// e_last.
Eigen::VectorXd tangent_at(const EquationSystem& curve, const Eigen::Ref<const Eigen::VectorXd>& unknowns,
                           const Eigen::Ref<const Eigen::VectorXd>& reference);

/// Point of the curve over the chord from `from` to `to`, at `share` of it; nothing where the corrector fails.
std::optional<CurvePoint> point_between(const EquationSystem& curve, const CurvePoint& from, const CurvePoint& to,
                                        double share);

/// A sign change of `test` between two points, by the Illinois false position along the chord down to
/// `tolerance` of it. Nothing where the corrector fails before anything was found.
std::optional<CurvePoint> zero_between(const EquationSystem& curve, const CurvePoint& from, const CurvePoint& to,
                                       const std::function<double(const CurvePoint&)>& test, double tolerance);

/// Pseudo-arclength continuation (Keller 1977) from `start` along its tangent, with a Newton corrector in the
/// hyperplane normal to the tangent and step lengths from its effort and from the turn of the tangent. `visit` sees
/// every step in order. Ends at a bound (the last point lies on it), where the start comes round again, when
/// `visit` stops it, at the point limit, or when the corrector fails at the smallest step.
TraceEnd trace_curve(const EquationSystem& curve, const CurvePoint& start, const std::vector<CurveBound>& bounds,
                     const StepOptions& options, const StepVisitor& visit);

/// Throws std::invalid_argument for steps that are not positive and ordered.
void check_steps(const StepOptions& options);

}  // namespace secular
