#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// Which modes of a case oscillate and what their observed frequencies follow from: with u the frequencies that the
/// resonance leaves free and Omega those of the excitations, f = coupling*u + forced*Omega. Modes that are locked
/// one by one have no free part; an additive combination Omega = omega1 + omega2 has one, u = f2, f1 = Omega - f2.
struct ModeFrequencies {
  std::vector<bool> oscillates;   ///< [mode]; false: at rest, or not driven by this resonance
  std::vector<std::size_t> free;  ///< natural frequencies whose observed values are u
  Eigen::MatrixXd coupling;       ///< modes x free
  Eigen::MatrixXd forced;         ///< modes x excitations

  /// Observed frequencies of all modes, rad/s; 0 for modes that do not oscillate.
  Eigen::VectorXd observed(const Eigen::VectorXd& u, const std::vector<double>& excitation) const;
};

/// An excited case drives the modes whose observed frequency involves the excitation's, and those that share a free
/// frequency with them; without excitation every mode that is not at rest is free.
ModeFrequencies mode_frequencies(const CompiledModel& model, const CompiledCase& resonance);

}  // namespace secular
