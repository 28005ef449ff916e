#pragma once

#include <Eigen/Core>

#include "measure/signal/ensembles.hpp"

namespace secular {

/// Phase difference gamma = arg(F conj(A1) conj(A2)) of a resonance Omega ~ omega1 + omega2 (thesis section 6.5),
/// the angle of the bispectrum averaged over ensembles.
struct BispectralPhase {
  double gamma = 0;               ///< rad, in (-pi, pi], corrected for `bias`
  double gamma_sd = 0;            ///< rad
  double bias = 0;                ///< rad, expected error of the plain angle, second order in the scatter
  double degrees_of_freedom = 0;  ///< of gamma_sd
  double bicoherence = 0;         ///< |mean F A1* A2*|^2 / (mean |F|^2 mean |A1 A2|^2), between 0 and 1
  bool locked = false;            ///< gamma stands still: bicoherence beyond what independent phases would show
};

/// Complex amplitudes of excitation and both responses by ensemble, phases all at the same instant of each
/// ensemble; with A1 = A2 a principal parametric resonance. At least two ensembles, else std::invalid_argument.
/// `false_alarm` is the probability that independent phases pass as locked.
BispectralPhase bispectral_phase(const Eigen::Ref<const Eigen::VectorXcd>& excitation,
                                 const Eigen::Ref<const Eigen::VectorXcd>& first,
                                 const Eigen::Ref<const Eigen::VectorXcd>& second, const EnsembleLayout& layout,
                                 double false_alarm = 0.01);

}  // namespace secular
