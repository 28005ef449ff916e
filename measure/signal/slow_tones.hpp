#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// Tones whose complex amplitudes change slowly, seen through one window. With tau the time from the window's
/// centre and D the degree, tone j of a channel is
///   B_j(tau) exp(i*frequency_j*tau) + conj,   B_j(tau) = sum_{p=0..D} B_j^(p) tau^p / p!.
/// Derivatives of the order p = D-1, D-3, ... are biased by the first one that is left out: for D = 2 and a window
/// of length L, the slope B' by B''' L^2/40.
struct SlowToneFit {
  /// [p]: tones x channels, derivative p of the complex half-amplitude at the centre.
  std::vector<Eigen::MatrixXcd> derivative;
  /// [p]: tones x channels, standard deviation of its real and imaginary part alike.
  std::vector<Eigen::MatrixXd> sd;
  Eigen::VectorXd offset, offset_sd;  ///< [channel], at the centre
  Eigen::VectorXd noise_sd;           ///< [channel]
  Eigen::Index degrees_of_freedom = 0;
};

/// Linear least squares, hence without a bias of its own by noise: channels (samples x channels) on tones at
/// `frequencies` (rad/s, distinct, positive) and a polynomial of `offset_degree` at zero frequency. Sample i is at
/// tau = (i - (N-1)/2)/rate. Throws std::invalid_argument for fewer samples than unknowns.
SlowToneFit fit_slow_tones(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                           const std::vector<double>& frequencies, int degree, int offset_degree);

/// What fit_slow_tones() multiplies samples with.
struct SlowToneWeights {
  std::vector<Eigen::MatrixXcd> derivative;  ///< [p]: tones x samples
  Eigen::RowVectorXd offset;
};

SlowToneWeights slow_tone_weights(Eigen::Index samples, double sample_rate_hz,
                                  const std::vector<double>& frequencies, int degree, int offset_degree);

}  // namespace secular
