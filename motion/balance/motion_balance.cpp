#include "motion/balance/motion_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "input/stop_request.hpp"
#include "motion/balance/balance_sweep.hpp"
#include "numerics/anderson_acceleration.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr int iteration_limit = 60;
constexpr double tolerance = 1e-10;

/// Steps remembered, and how far they depend on one another before they are not told apart.
constexpr std::size_t remembered_steps = 8;
constexpr double dependent_steps = 1e-8;

/// A step this many times longer than the last one says that the linear picture was wrong: what was learnt is
/// forgotten, and plain steps are shortened, to no less than `least_step_share`.
constexpr double step_growth = 2;
constexpr double least_step_share = 0.05;

}  // namespace

Complex line_rate(const Torus& torus, const std::array<Complex, 2>& rate, Index line) {
  const LinePhase& n = torus.phase(line);
  Complex sum = 0;
  for (std::size_t j = 0; j < 2; ++j) sum += Complex(std::abs(n[j]) * rate[j].real(), n[j] * rate[j].imag());
  return sum;
}

void place_masters(const MotionSetting& setting, const VectorXcd& amplitudes, MatrixXcd& displacement) {
  for (std::size_t m = 0; m < setting.masters.size(); ++m)
    displacement(static_cast<Index>(setting.masters[m].mode), setting.masters[m].line) =
        amplitudes(static_cast<Index>(m));
}

VectorXcd balance_of_masters(const MotionSetting& setting, const MatrixXcd& residual) {
  VectorXcd balance(static_cast<Index>(setting.masters.size()));
  for (std::size_t m = 0; m < setting.masters.size(); ++m)
    balance(static_cast<Index>(m)) = residual(static_cast<Index>(setting.masters[m].mode), setting.masters[m].line);
  return balance;
}

Motion MotionBalance::solve(const MotionSetting& setting, const VectorXcd& amplitudes,
                            std::span<const double> parameters, const Motion* start) const {
  Motion motion;
  motion.displacement =
      start ? start->displacement : MatrixXcd::Zero(static_cast<Index>(model_->modes()), setting.torus->lines());
  place_masters(setting, amplitudes, motion.displacement);
  const double scale = amplitudes.size() > 0 ? amplitudes.cwiseAbs().maxCoeff() : 0;
  const std::vector<SlavedLine> slaves = slaved_lines(setting, *model_, parameters);
  BalanceSweep sweep(*model_, forces_, setting);
  AndersonAcceleration acceleration(remembered_steps, dependent_steps);
  double share = 1, last_step = 0;
  bool lost = false;  // the latest step is longer than the motion: nothing is near
  MatrixXcd residual;
  VectorXd lines = gathered(slaves, motion.displacement);
  for (int i = 0; i < iteration_limit; ++i) {
    end_if_stopped();
    residual = sweep.residual(sweep.path(motion.displacement), parameters);
    const VectorXd step = BalanceSweep::steps(slaves, residual);
    if (!step.allFinite()) {
      motion.ending = SolverEnding::ran_away;
      break;
    }
    const double size = std::max(scale, motion.displacement.cwiseAbs().maxCoeff());
    const bool at_rest = step.size() == 0 || step.cwiseAbs().maxCoeff() <= tolerance * size;
    const double length = step.norm();
    lost = length > size;
    if (i > 0 && length > step_growth * last_step) {
      acceleration = AndersonAcceleration(remembered_steps, dependent_steps);
      share = std::max(least_step_share, 0.5 * share);
    }
    last_step = length;
    lines = at_rest ? VectorXd(lines + step) : acceleration.next(lines, lines + share * step);
    scattered(slaves, lines, motion.displacement);
    if (at_rest) {
      motion.ending = SolverEnding::converged;
      break;
    }
  }
  motion.balance = balance_of_masters(setting, residual);
  if (!motion.converged() && lost) {
    motion.ending = SolverEnding::ran_away;
    motion.displacement.setConstant(std::numeric_limits<double>::quiet_NaN());
    motion.balance.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return motion;
}

}  // namespace secular
