#pragma once

#include <span>
#include <vector>

#include "motion/balance/motion_balance.hpp"
#include "motion/balance/velocity_jumps.hpp"

namespace secular {

/// A line of a mode that follows from its own balance, and the compliance 1/(omega^2 + rate^2) with which it does.
struct SlavedLine {
  Eigen::Index mode = 0, line = 0;
  std::complex<double> compliance;
};

/// All lines that are neither measured nor so near to resonance that the mode must be at rest on them.
std::vector<SlavedLine> slaved_lines(const MotionSetting& setting, const CompiledModel& model,
                                     std::span<const double> parameters);

/// Real and imaginary parts of the slaved lines' entries of a modes x lines matrix as one vector; the mean has a
/// real part only; and back into the matrix.
Eigen::VectorXd gathered(const std::vector<SlavedLine>& slaves, const Eigen::MatrixXcd& all);
void scattered(const std::vector<SlavedLine>& slaves, const Eigen::VectorXd& values, Eigen::MatrixXcd& all);

/// `all` with one entry of what `gathered` would make of it changed by a step.
Eigen::MatrixXcd with_step(const std::vector<SlavedLine>& slaves, const Eigen::MatrixXcd& all, Eigen::Index entry,
                           double step);

/// Evaluations of the equations of motion over one turn of the phases, with everything prepared that depends on the
/// setting alone. Keeps a reference to the setting.
class BalanceSweep {
 public:
  /// A motion with its displacements and velocities over one turn: modes x points.
  struct Path {
    Eigen::MatrixXcd lines;
    Eigen::MatrixXd position, velocity;
  };

  BalanceSweep(const CompiledModel& model, std::vector<StateForce> forces, const MotionSetting& setting);

  /// Of lines, modes x lines.
  Path path(Eigen::MatrixXcd displacement) const;

  /// Force minus inertia on every line, per unit of modal mass: modes x lines, zero for a motion in balance.
  Eigen::MatrixXcd residual(const Path& path, std::span<const double> parameters);

  /// Change of the residual with every entry of gathered(slaves): (modes*lines) x entries, each column a matrix by
  /// columns. `length`: a small displacement on the scale of the motion.
  Eigen::MatrixXcd residual_slopes(const Path& path, std::span<const double> parameters,
                                   const std::vector<SlavedLine>& slaves, double length);

  /// Change of the residual with each of some symbols of the model, divided by it: modes x lines. Not for the shape
  /// of a force, which the equations of motion do not show.
  std::vector<Eigen::MatrixXcd> parameter_slopes(const Path& path, std::span<const double> parameters,
                                                 const std::vector<std::size_t>& symbols);

  /// The steps that would bring the slaved lines into balance if nothing else depended on them.
  static Eigen::VectorXd steps(const std::vector<SlavedLine>& slaves, const Eigen::MatrixXcd& residual);

 private:
  /// Values of a force over one turn.
  struct Signal {
    const StateForce* force;
    Eigen::RowVectorXd values;
    double shape = 0;
  };

  Eigen::RowVectorXd values_of(const StateForce& force, const Eigen::MatrixXd& position,
                               const Eigen::MatrixXd& velocity, double shape) const;
  /// Of the forces that are switched on, and of those whose strength is among `strengths`.
  std::vector<Signal> signals(const Eigen::MatrixXd& position, const Eigen::MatrixXd& velocity,
                              std::span<const double> parameters,
                              const std::vector<std::size_t>& strengths = {}) const;
  /// What jumps at the turnings of a path.
  struct Jumps {
    std::vector<Turning> at;
    Eigen::MatrixXd sizes;  ///< of the accelerations: modes x turnings
  };
  Jumps jumps(const Path& path, std::span<const double> parameters, const std::vector<Signal>& signals);
  /// Calls `side(turning, +1 or -1)` with the model's state at every turning, its velocity vanishing on either
  /// side.
  template <class Side>
  void beside_turnings(const Path& path, const std::vector<Turning>& turnings, const std::vector<Signal>& signals,
                       const Side& side);
  /// How far a jump at one turning moves another: phase by size.
  double moves(const Turning& jump, const Turning& moved, std::span<const double> parameters) const;
  std::size_t driven(Eigen::Index row) const {
    return static_cast<std::size_t>(driven_[static_cast<std::size_t>(row)]);
  }
  /// What excites the model at one point.
  void excite(Eigen::Index point, const std::vector<Signal>& signals);
  /// Accelerations over one turn: modes x points.
  const Eigen::MatrixXd& accelerations(const Eigen::MatrixXd& position, const Eigen::MatrixXd& velocity,
                                       std::span<const double> parameters, const std::vector<Signal>& signals);

  const Eigen::MatrixXd& accelerations_side_by_side(const Eigen::MatrixXd& position,
                                                    const Eigen::MatrixXd& velocity,
                                                    std::span<const double> parameters,
                                                    const std::vector<Signal>& signals);

  /// The real or the imaginary part of a slaved line.
  struct Entry {
    Eigen::Index mode, line;
    std::complex<double> unit;
  };
  static std::vector<Entry> entries_of(const std::vector<SlavedLine>& slaves);
  enum class Variable { position, velocity };
  /// Central difference of the accelerations by what one coordinate does at the same point: modes x points.
  Eigen::MatrixXd slope_at_points(const Path& path, std::span<const double> parameters, Eigen::Index coordinate,
                                  Variable variable, double step);
  /// The signal of a force with memory, and the accelerations by it: modes x points.
  struct Memory {
    const Signal& signal;
    Eigen::MatrixXd felt;
  };
  std::vector<Memory> memories(const Path& path, std::span<const double> parameters,
                               const std::vector<Signal>& signals, double length);
  Eigen::RowVectorXd change_of(const Signal& signal, const Path& path, std::span<const double> parameters,
                               const Entry& entry, double length) const;
  /// Change of the accelerations by every entry, without jumps: (entries*modes) x lines.
  Eigen::MatrixXcd felt_on_lines(const Path& path, std::span<const double> parameters,
                                 const std::vector<Signal>& signals, const std::vector<Entry>& entries,
                                 double length);
  void take_jumps_along(const Entry& entry, const Jumps& jumps, Eigen::MatrixXcd& change) const;

  const CompiledModel& model_;
  std::vector<StateForce> forces_;
  const Torus& torus_;
  Eigen::RowVectorXcd rates_;
  std::vector<Eigen::Index> driven_;                         ///< excitations that are not zero
  Eigen::MatrixXd force_, force_rate_, force_acceleration_;  ///< of those: driven x points
  Eigen::MatrixXd acceleration_;
  double level_ = 0;  ///< squared_amplitude of the first excitation
  std::vector<ExcitationSample> excitation_;
  Eigen::VectorXd position_, velocity_;  ///< at one point
};

}  // namespace secular
