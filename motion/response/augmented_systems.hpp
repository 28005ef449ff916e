#pragma once

#include <Eigen/Core>

#include "motion/response/scaled_field.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {

/// Unit vectors near the left and right null vector of a Jacobian, [dimension] each.
struct Borders {
  Eigen::VectorXd left, right;
  double rate = 1;  ///< norm of the Jacobian they were made from: their length in the bordered matrix
};

/// Singular vectors of the smallest singular value, turned towards `previous` where that is given.
Borders null_vectors(const Eigen::Ref<const Eigen::MatrixXd>& jacobian, const Borders* previous = nullptr);

/// [J b; c' 0] (v; g) = (0; 1) and [J b; c' 0]' (w; g) = (0; 1) with b, c the borders: g vanishes with det J, and
/// where it does v and w are null vectors (Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria,
/// section 3.2).
struct BorderedSolution {
  double g = 0;
  Eigen::VectorXd right, left;  ///< v, w
};

/// Not a number where the Jacobian is not finite.
BorderedSolution solve_bordered(const Eigen::Ref<const Eigen::MatrixXd>& jacobian, const Borders& borders);

/// Minimally augmented systems; y = (x, free parameters), scaled. Their solution sets do not depend on the borders.

/// Saddle-node: f = 0, g = 0; [dimension + 1].
Eigen::VectorXd fold_equations(const ScaledField& field, const Eigen::Ref<const Eigen::VectorXd>& unknowns,
                               const Borders& borders);

/// Branch point in the first free parameter: f + beta b = 0, g = 0, w . df/dp_1 = 0 with beta the last unknown
/// after y; [dimension + 2]. At a branch point beta = 0; where another parameter unfolds it, beta is not.
Eigen::VectorXd branch_point_equations(const ScaledField& field, const Eigen::Ref<const Eigen::VectorXd>& unknowns,
                                       const Borders& borders);

/// Hopf point: f = 0, sum of the eigenvalue pair nearest to (0, reference.product) = 0; [dimension + 1]. Also holds
/// at neutral saddles: look at the product.
Eigen::VectorXd hopf_equations(const ScaledField& field, const Eigen::Ref<const Eigen::VectorXd>& unknowns,
                               const EigenvaluePair& reference);

}  // namespace secular
