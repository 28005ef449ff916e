#pragma once

#include <Eigen/Core>
#include <complex>
#include <optional>
#include <vector>

#include "motion/correction/balanced_motions.hpp"

namespace secular {

/// What the modulation equations of a case leave at the full equations of motion: dA/dt of a motion in balance
/// (BalancedMotions::rate_of) less dA/dt as derived. From any thread. The model must outlive it.
class ExpansionRemainder {
 public:
  ExpansionRemainder(const CompiledModel& model, const CompiledCase& resonance);

  /// Whether there is one: BalancedMotions::known.
  bool known() const { return motions_.known(); }

  /// [mode], 1/s times the coordinate's unit, zero of modes at rest. `parameters` as
  /// ResponseField::parameter_names: symbols, excitation frequencies (rad/s), excitation amplitudes (peak, at phase
  /// zero; not read where the case has none). `amplitude`: [mode], half of the peak. Nothing where no balance is
  /// found.
  std::optional<std::vector<std::complex<double>>> at(const Eigen::VectorXd& parameters,
                                                      const std::vector<std::complex<double>>& amplitude) const;

 private:
  const CompiledModel& model_;
  const CompiledCase& resonance_;
  BalancedMotions motions_;
};

}  // namespace secular
