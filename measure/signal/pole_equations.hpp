#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "measure/signal/circular_moments.hpp"
#include "measure/signal/pole.hpp"

namespace secular {

/// G^T G in columns of unit norm, factored.
struct Gram {
  Eigen::LLT<Eigen::MatrixXd> factor;
  Eigen::VectorXd scale;  ///< columns of G are multiplied by it
  double rcond = 0;

  explicit Gram(const Eigen::MatrixXd& gram);
  /// (G^T G)^-1 right.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
};

/// What a turn of the poles does to the least-squares amplitudes, and to the residual. Time in half windows.
struct PoleMoments {
  Gram gram;
  Eigen::MatrixXd drag;  ///< (G^T G)^-1 G^T (tau G)
  Eigen::MatrixXd free;  ///< (tau G)^T (1 - P) (tau G), the part that the amplitudes cannot imitate
  bool usable = false;

  PoleMoments(Gram factored, const TimedMoments& moments);
};

/// Derivatives of the signal by the unknowns of the poles: each is time times the pole's own functions, with these
/// amplitudes. One row for every unknown and function of its pole.
struct PoleTurns {
  Eigen::MatrixXd amplitudes;                   ///< [row][channel], per unknown in 1/half window
  std::vector<Eigen::Index> unknown, function;  ///< of each row

  PoleTurns(std::span<const Pole> poles, const Eigen::MatrixXd& of);

  /// J^T W J for weights by channel, without what the amplitudes imitate.
  Eigen::MatrixXd hessian(const PoleMoments& m, const Eigen::VectorXd& weight) const;
  /// -J^T W r from the moments (tau G)^T r, functions x channels.
  Eigen::VectorXd slope(const Eigen::MatrixXd& timed, const Eigen::VectorXd& weight) const;
  /// Change of the least-squares amplitudes by a step of the unknowns.
  Eigen::MatrixXd dragged(const PoleMoments& m, const Eigen::VectorXd& step) const;
  /// Minus that change by unknown, in one channel: functions x unknowns.
  Eigen::MatrixXd drag(const PoleMoments& m, Eigen::Index channel) const;

 private:
  Eigen::Index unknowns_ = 0, functions_ = 0;
};

/// Decrease of the log-likelihood below which a step is a change within the model linearised where the poles stand:
/// a hundredth of a standard deviation, of which a Gauss-Newton step leaves less than a hundredth.
inline constexpr double linear_decrease = 1e-4;
/// Below this a step changes nothing but rounding.
inline constexpr double no_decrease = 1e-7;

/// The poles after a step of their unknowns, in radians (or exponents) at the ends of a window of this half length.
std::vector<Pole> moved(std::vector<Pole> poles, const Eigen::VectorXd& step, double half);

}  // namespace secular
