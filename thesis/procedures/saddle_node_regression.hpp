#pragma once

#include <Eigen/Core>
#include <optional>

namespace secular {

enum class NonlinearDamping {
  quadratic,  ///< linear and quadratic (drag), thesis Eqs. (5.34), (5.35)
  cubic       ///< linear and cubic, thesis Eqs. (5.36), (5.37)
};

/// Damping over effective parametric excitation, from stable points close to the saddle-nodes.
struct SaddleNodeFit {
  double linear = 0;           ///< mu1/|eta_e|, least squares
  double nonlinear = 0;        ///< mu2/|eta_e| or mu3/|eta_e|
  double lowered_linear = 0;   ///< mu1/|eta_e| lowered until no point lies left of the line
  Eigen::Matrix2d covariance;  ///< of (linear, nonlinear), from residuals
  Eigen::VectorXd fitted;      ///< force of the line at every amplitude, before it is lowered
  double residual_sd = 0;      ///< of the force
  bool converged = true;
};

/// Thesis section 5.5. `amplitude` (peak, of the modal displacement) and `forcing` (peak) by point, three or more.
///
/// As printed (no `stiffness_ratio`): F = w0 mu1/|eta_e| + (4 w0^2/(3 pi)) a mu2/|eta_e| and its cubic sibling
/// (3/8) w0^3 a^2 mu3/|eta_e|. That is where the radicand of (5.25) vanishes: the peak of the response, not the
/// saddle-node, which is where d(sigma)/d(a) = 0. With D(a) the printed right-hand side the saddle-node is at
///   F = D(a) sqrt(1 + (D'(a)/(2 r a))^2),   r = |alpha_e/eta_e|,
/// which is fitted where `stiffness_ratio` r is given (the factor is constant for cubic damping), by repeated least
/// squares. Throws std::invalid_argument for sizes that differ or fewer than three points.
SaddleNodeFit saddle_node_regression(NonlinearDamping law, const Eigen::Ref<const Eigen::VectorXd>& amplitude,
                                     const Eigen::Ref<const Eigen::VectorXd>& forcing, double omega0,
                                     std::optional<double> stiffness_ratio = {});

}  // namespace secular
