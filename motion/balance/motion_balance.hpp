#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <memory>
#include <span>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "motion/balance/state_force.hpp"
#include "motion/balance/torus.hpp"
#include "numerics/solver_ending.hpp"

namespace secular {

/// A line of a mode whose amplitude is measured, not solved for: its own balance is what a model is judged by.
struct MasterLine {
  std::size_t mode = 0;
  Eigen::Index line = 0;
};

/// Rate of a line on a torus whose base phases turn at `rate`: sum |n_j| growth_j + i sum n_j frequency_j.
std::complex<double> line_rate(const Torus& torus, const std::array<std::complex<double>, 2>& rate,
                               Eigen::Index line);

/// One steady or slowly decaying motion: base phases theta_j turn at the rates growth + i*frequency.
struct MotionSetting {
  std::shared_ptr<const Torus> torus;
  std::array<std::complex<double>, 2> rate;
  Eigen::MatrixXcd excitation;  ///< model's excitations x lines
  std::vector<MasterLine> masters;
  std::vector<MasterLine> resting;  ///< lines near resonance on which a mode could move and was seen not to

  std::complex<double> line_rate(Eigen::Index line) const { return secular::line_rate(*torus, rate, line); }
};

struct Motion {
  Eigen::MatrixXcd displacement;  ///< modes x lines
  Eigen::VectorXcd balance;       ///< by master: force minus inertia on that line, per unit of modal mass
  SolverEnding ending = SolverEnding::stalled;

  bool converged() const { return ending == SolverEnding::converged; }
};

/// Writes amplitudes, by master, into a modes x lines matrix.
void place_masters(const MotionSetting& setting, const Eigen::VectorXcd& amplitudes,
                   Eigen::MatrixXcd& displacement);
/// The masters' entries of a modes x lines matrix of balances.
Eigen::VectorXcd balance_of_masters(const MotionSetting& setting, const Eigen::MatrixXcd& residual);

/// Harmonic balance on the full equations of motion with the master lines given. Every other line follows from its
/// own balance (it is far from resonance, so that an iteration by its compliance converges); what is left on the
/// master lines is the discrepancy between model and measurement. No expansion in small amplitudes is made: lines
/// are truncated, and nothing else. Nonlinear forces are evaluated over one turn of the phases (alternating
/// frequency and time, Cameron and Griffin 1989).
class MotionBalance {
 public:
  MotionBalance(const CompiledModel& model, std::vector<StateForce> forces)
      : model_(&model), forces_(std::move(forces)) {}

  const CompiledModel& model() const { return *model_; }
  const std::vector<StateForce>& forces() const { return forces_; }

  /// `amplitudes`: of the masters, half of the peak. `parameters` by CompiledModel::symbols. `start`: a
  /// neighbouring motion to begin with, or nullptr. Not finite where the iteration runs away: there is no motion
  /// near. (One that only has not come to rest, as at kinks, is returned as far as it came.)
  Motion solve(const MotionSetting& setting, const Eigen::VectorXcd& amplitudes, std::span<const double> parameters,
               const Motion* start = nullptr) const;

 private:
  const CompiledModel* model_;
  std::vector<StateForce> forces_;
};

/// A line whose dynamic stiffness |1 - (line/natural frequency)^2| is less than this is no slave, as iteration
/// would not reach its motion: where it is no master either, the mode counts as at rest on it. That is 5.4 % above
/// it and 5.7 % below: less than the 6 % that possible_layouts looks at up to the third multiple (half of
/// resonant_reach, 1 - 0.94^2 = 0.116 here), so that there is no line between the two that moves unseen.
constexpr double least_slaved_stiffness = 0.11;

}  // namespace secular
