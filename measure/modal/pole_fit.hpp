#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "measure/modal/residue_conversion.hpp"
#include "numerics/solver_ending.hpp"

namespace secular {

/// Poles common to several signals and the residues of each: one complex-conjugate pair a mode, the pole with
/// positive imaginary part given.
struct PoleFit {
  SolverEnding ending = SolverEnding::stalled;
  Eigen::VectorXcd poles;     ///< n, rad/s
  Eigen::VectorXd growth_sd;  ///< n, standard deviation of the real parts, 1/s
  Eigen::VectorXd omega_sd;   ///< n, standard deviation of the imaginary parts, rad/s
  Eigen::MatrixXcd residues;  ///< n x signals
  Eigen::VectorXd noise_sd;   ///< by signal: rms of what is left (of real and imaginary part in frequency)
};

/// Whether columns of a pole are numbers up to the end of a record: it grows by less than e^300, the square root of
/// the largest double.
bool representable(std::complex<double> pole, double duration_s);

/// Residues for given poles by linear least squares: samples(k, s) = sum_r R(r, s) exp(pole_r k / rate) + conj
/// + a constant. samples: N x signals. Throws std::invalid_argument for fewer samples than unknowns, poles off
/// the upper half or poles that grow by e^300 within the samples.
PoleFit fit_residues(const Eigen::Ref<const Eigen::MatrixXd>& samples, double sample_rate_hz,
                     const Eigen::Ref<const Eigen::VectorXcd>& poles);

/// Maximum likelihood of poles and residues in white Gaussian noise of a level per signal: variable projection from
/// the given start (as an eigensystem realization gives it), Levenberg-Marquardt. The standard deviations are those
/// of the linearised fit.
PoleFit refine_poles(const Eigen::Ref<const Eigen::MatrixXd>& samples, double sample_rate_hz,
                     const Eigen::Ref<const Eigen::VectorXcd>& start);

/// What noise of one standard deviation (`noise_sd`) at each sample does to a refined pole.
struct PoleInfluence {
  Eigen::MatrixXd growth, omega;  ///< samples x signals: 1/s, rad/s; sums of squares are those of the pole's sds
};

/// By pole of `fit`, which refine_poles made of these samples.
std::vector<PoleInfluence> pole_influences(const Eigen::Ref<const Eigen::MatrixXd>& samples, double sample_rate_hz,
                                           const PoleFit& fit);

/// The same for frequency responses H(w, s) (lines x signals) of one form at angular frequencies w (rad/s):
/// sum_r R(r, s)/(i w - pole_r) + conj(R(r, s))/(i w - conj(pole_r)) and three real terms for the modes outside the
/// band and the direct pulse: (1, i w, -w^2) (i w)^(form - 2). Residues are those of that form. All lines count the
/// same; the residual includes whatever the model lacks.
PoleFit refine_poles(const Eigen::Ref<const Eigen::VectorXd>& omega,
                     const Eigen::Ref<const Eigen::MatrixXcd>& responses, ResponseForm form,
                     const Eigen::Ref<const Eigen::VectorXcd>& start);

}  // namespace secular
