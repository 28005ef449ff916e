#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "numerics/solver_ending.hpp"

namespace secular {

/// What fit_harmonic_tone estimates. With tau the time from the window's centre, harmonic h of the tone is
/// B_h exp(h*(growth*tau + growth_rate*tau^2/2 + i*(frequency*tau + sweep*tau^2/2))) + conj.
struct ToneOptions {
  std::vector<int> harmonics = {1};
  bool offset = true;       ///< a constant per channel
  bool fit_growth = false;  ///< otherwise growth is zero
  bool fit_sweep = false;   ///< frequency and growth change linearly in time
};

struct ToneFit {
  /// Ran away: the normal equations had no finite solution. What a stalled fit gives is used.
  SolverEnding ending = SolverEnding::ran_away;
  double frequency = 0, growth = 0;   ///< rad/s, 1/s, at the centre
  double sweep = 0, growth_rate = 0;  ///< rad/s^2, 1/s^2
  double frequency_sd = 0, growth_sd = 0;
  Eigen::MatrixXcd amplitude;    ///< [harmonic][channel], half of the peak, phase at the centre
  Eigen::MatrixXd amplitude_sd;  ///< of real and imaginary part alike
  Eigen::VectorXd offset;        ///< [channel]
  Eigen::VectorXd noise_sd;      ///< [channel]
  Eigen::Index samples = 0;
};

/// Maximum-likelihood fit of one tone with harmonics to channels (samples x channels) that share its poles, in
/// white Gaussian noise of a level per channel: variable projection, Gauss-Newton with Levenberg steps. `frequency`
/// (rad/s) is the starting value and should be within about one bin of the window. Sample i is at tau = (i -
/// (N-1)/2)/rate. Throws std::invalid_argument for fewer samples than unknowns or samples that are not finite.
ToneFit fit_harmonic_tone(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                          double frequency, const ToneOptions& options);

/// Of a complex amplitude that stands out of the noise, over the standard deviation of its real part: Rayleigh's
/// law exceeds it with `measure_thresholds().motion_false_alarm`.
double least_amplitude_sd();

/// Complex half-amplitudes at imposed frequencies.
struct KnownFrequencyFit {
  Eigen::MatrixXcd amplitude;    ///< [frequency][channel], phase at the window's centre
  Eigen::MatrixXd amplitude_sd;  ///< of real and imaginary part alike
  Eigen::VectorXd offset, noise_sd;
};

/// Linear least squares at `frequencies` (rad/s, positive, distinct), with a constant per channel if `offset`.
KnownFrequencyFit known_frequency_components(const Eigen::Ref<const Eigen::MatrixXd>& channels,
                                             double sample_rate_hz, std::span<const double> frequencies,
                                             bool offset);

}  // namespace secular
