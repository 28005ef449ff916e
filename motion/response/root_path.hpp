#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/response/newton.hpp"

namespace secular {

/// Roots of f on the path f(u) = lambda * direction through `root` (lambda = 0), traced both ways while all |u_i|
/// stay below `bound`. The path of a smooth f goes on until it leaves or closes, through folds of f, and changes
/// the sign of lambda at every simple root it meets: roots that Newton's method reaches from nowhere near are found
/// along it. As many equations as unknowns, both of the order of one.
std::vector<Eigen::VectorXd> roots_on_path(const EquationSystem& system,
                                           const Eigen::Ref<const Eigen::VectorXd>& root,
                                           const Eigen::Ref<const Eigen::VectorXd>& direction, double bound);

}  // namespace secular
