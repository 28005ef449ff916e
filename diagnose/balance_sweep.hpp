#pragma once

#include <span>
#include <vector>

#include "diagnose/motion_balance.hpp"

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
/// real part only.
Eigen::VectorXd gathered(const std::vector<SlavedLine>& slaves, const Eigen::MatrixXcd& all);
void scattered(const std::vector<SlavedLine>& slaves, const Eigen::VectorXd& values, Eigen::MatrixXcd& all);

/// One evaluation of the equations of motion over one turn of the phases, with everything that does not depend on
/// the motion prepared. Keeps references to the setting and the parameters.
class BalanceSweep {
 public:
  BalanceSweep(const CompiledModel& model, const std::vector<StateForce>& forces, const MotionSetting& setting,
               std::span<const double> parameters);

  /// Force minus inertia on every line, per unit of modal mass: modes x lines, zero for a motion in balance.
  Eigen::MatrixXcd residual(const Eigen::MatrixXcd& displacement);

  /// The steps that would bring the slaved lines into balance if nothing else depended on them.
  static Eigen::VectorXd steps(const std::vector<SlavedLine>& slaves, const Eigen::MatrixXcd& residual);

 private:
  const CompiledModel& model_;
  const std::vector<StateForce>& forces_;
  const Torus& torus_;
  std::span<const double> parameters_;
  Eigen::RowVectorXcd rates_;
  Eigen::MatrixXd force_, force_rate_, force_acceleration_, acceleration_;
  std::vector<ExcitationSample> excitation_;
};

}  // namespace secular
