#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "measure/signal/pole.hpp"
#include "measure/signal/symmetric_polynomial.hpp"
#include "measure/signal/tone_fit.hpp"

namespace secular {

struct DecompositionOptions {
  int order = 1;  ///< n: unknown pairs of poles; a product of circular and hyperbolic functions takes two
  PolynomialMethod method = PolynomialMethod::noise_eigenvector;
  std::vector<double> imposed;  ///< known frequencies, rad/s, besides the `order` unknown ones
  bool offset = false;          ///< a constant per channel, imposed in the same way
  bool refine = false;          ///< Gauss-Newton to maximum likelihood, with covariances
  double origin_s = 0;          ///< time of the functions' zero, from the first sample
};

/// One circular term of one channel as amplitude * cos(frequency t + phase).
struct ToneEstimate {
  double frequency = 0, amplitude = 0, phase = 0;           ///< rad/s, unit of the channel (peak), rad
  double frequency_sd = 0, amplitude_sd = 0, phase_sd = 0;  ///< NaN without refinement
};

/// Channels as sums of circular and hyperbolic functions that share their poles, thesis Eq. (4.3).
struct Decomposition {
  bool determined = true;       ///< false: no finite poles describe the samples, and nothing below is filled in
  std::vector<Pole> poles;      ///< unknown ones by family and frequency, then constant and imposed
  Eigen::MatrixXd amplitudes;   ///< [function][channel], functions in the order of the poles
  Eigen::VectorXd correlation;  ///< gamma^2 between samples and fit, by channel
  Eigen::VectorXd signal_to_noise_db;      ///< power of the fit over power of what is left, by channel
  Eigen::VectorXd noise_sd;                ///< of what is left, corrected for the unknowns, by channel
  std::optional<SolverEnding> refinement;  ///< how it ended; empty if not asked for
  int iterations = 0;
  /// Of (pole parameters, amplitudes of channel 0, of channel 1, ...), thus
  /// (parameter_count + functions * channels) square; empty without refinement.
  Eigen::MatrixXd covariance;
  double sample_rate_hz = 0, origin_s = 0;
  Eigen::Index samples = 0;

  /// samples x channels.
  Eigen::MatrixXd reconstruct(Eigen::Index count) const;
  /// Row of the first function of a pole in `amplitudes`.
  Eigen::Index first_function(std::size_t pole) const;
  /// Row of a pole's first parameter in `covariance`.
  Eigen::Index first_parameter(std::size_t pole) const;
  /// Row of an amplitude in `covariance`.
  Eigen::Index amplitude_row(Eigen::Index function, Eigen::Index channel) const;
  /// Amplitude and phase of a circular pole; throws std::invalid_argument for another family.
  ToneEstimate tone(std::size_t pole, Eigen::Index channel) const;
  /// The circular pole next to `frequency` (rad/s), if there is any.
  std::optional<std::size_t> nearest(double frequency) const;
};

/// Circular-hyperbolic decomposition of samples x channels (thesis section 4.3): characteristic polynomial by
/// `method`, its poles by family, amplitudes by linear least squares (4.19). With `refine` the poles are carried to
/// the maximum of the likelihood; when they leave a tone behind (the closed form may be off by more than a bin
/// where noise is high), poles from a search in the periodogram compete, and the larger likelihood wins. Throws
/// std::invalid_argument for too few samples, an order below one or samples whose squares are
/// not finite.
Decomposition decompose(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                        const DecompositionOptions& options);

}  // namespace secular
