#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "motion/response/curve_tracer.hpp"
#include "motion/response/equilibrium.hpp"
#include "motion/response/vector_field.hpp"

namespace secular {

struct ParameterRange {
  Eigen::Index parameter = 0;
  double lower = 0, upper = 1;
  double scale = 0;  ///< length that counts as one; 0: upper - lower
};

struct BifurcationCurveOptions {
  ParameterRange first, second;
  /// Bound of |state_i| over its typical magnitude.
  double state_bound = std::numeric_limits<double>::infinity();
  StepOptions steps;
};

enum class BifurcationKind { saddle_node, branch_point, hopf };

struct BifurcationCurvePoint {
  Eigen::VectorXd state;  ///< [dimension]
  double first = 0, second = 0;
  double frequency = 0;  ///< rad per unit of time, on Hopf curves
  Eigen::VectorXcd eigenvalues;
};

/// Points of a curve in two parameters at which a further condition holds.
enum class CodimensionTwo {
  cusp,             ///< saddle-node curve: the quadratic coefficient w . f_xx[v, v] vanishes
  bogdanov_takens,  ///< saddle-node or Hopf curve: double zero eigenvalue, w . v = 0 or frequency 0
};

struct CodimensionTwoPoint {
  CodimensionTwo kind = CodimensionTwo::cusp;
  BifurcationCurvePoint at;
};

struct BifurcationCurve {
  BifurcationKind kind = BifurcationKind::saddle_node;
  std::vector<BifurcationCurvePoint> points;
  std::vector<CodimensionTwoPoint> special;
  TraceEnd first_end, last_end;
  bool closed = false;
};

/// The curve of saddle-nodes, branch points or Hopf points through `start` in two parameters, traced both ways by
/// pseudo-arclength continuation of the minimally augmented equations (augmented_systems.hpp) in (state, first,
/// second). `parameters` holds all of them at `start`; the kind follows from it (pitchforks and transcritical
/// points are branch points, such as the threshold of the trivial solution).
///
/// A Hopf curve ends where its frequency reaches zero (TraceStatus::special_end). Branch points persist in a second
/// parameter only for a reason, such as a symmetry or a trivial solution; without one the curve ends with
/// TraceStatus::not_persistent. Throws std::invalid_argument for sizes and ranges that make no sense, equal
/// parameters, a start outside of the ranges, and starts of kind branch_point or double_zero.
BifurcationCurve continue_bifurcation(const VectorField& field, const Eigen::Ref<const Eigen::VectorXd>& parameters,
                                      const SpecialPoint& start, const BifurcationCurveOptions& options);

}  // namespace secular
