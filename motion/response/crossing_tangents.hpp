#pragma once

#include <Eigen/Core>

#include "motion/response/equilibrium.hpp"
#include "motion/response/scaled_field.hpp"

namespace secular {

struct CrossingTangents {
  SpecialKind kind = SpecialKind::branch_point;
  Eigen::MatrixXd tangents;  ///< [unknown][2], scaled: along `reference`, and across; empty for kind branch_point
};

/// Directions of the branches through a branch point of a field with one free parameter, from the algebraic
/// bifurcation equation w . f_yy[t, t] = 0 on the plane where [f_x f_p] t = 0, with w the left null vector
/// (Keller 1977). Two real directions: a pitchfork if one of them leaves the parameter alone (its component below
/// 1e-6: the tangent test), transcritical otherwise.
CrossingTangents crossing_tangents(const ScaledField& field, const Eigen::Ref<const Eigen::VectorXd>& unknowns,
                                   const Eigen::Ref<const Eigen::VectorXd>& reference);

}  // namespace secular
