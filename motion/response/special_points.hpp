#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "motion/response/curve_tracer.hpp"
#include "motion/response/equilibrium.hpp"
#include "motion/response/scaled_field.hpp"

namespace secular {

/// What a point of a branch says about the special points near it.
struct BranchTests {
  std::array<double, 3> value = {0, 0, 0};  ///< saddle-node, branch point, Hopf; below 1e-9: no sign
  int unstable = 0;
};

/// At a point of a branch with one free parameter.
BranchTests branch_tests(const ScaledField& field, const CurvePoint& point);

/// As small as rounding makes it.
bool has_no_sign(double test);

/// Whether the crossings that sign changes tell of explain the change in the number of unstable eigenvalues.
bool explained(const BranchTests& from, const BranchTests& to);

/// A special point in scaled unknowns.
struct LocatedPoint {
  SpecialPoint special;
  CurvePoint point;
};

/// Whether both are one point: within 1e-6 of each other, which rounding leaves.
bool are_one(const LocatedPoint& one, const LocatedPoint& other);

/// A step along a branch, with the tests of its ends.
struct BranchStep {
  const CurvePoint &from, &to;
  BranchTests before, after;
};

/// Special points between two neighbouring points of the branch f = 0 of a field with one free parameter.
std::vector<LocatedPoint> special_points_between(const ScaledField& field, const EquationSystem& curve,
                                                 const BranchStep& step);

}  // namespace secular
