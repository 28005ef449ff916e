#pragma once

#include <Eigen/Core>

namespace secular {

/// A signal as a sum of complex exponentials residue * exp(pole t), thesis Eq. (4.1), t = 0 at the first sample.
struct ExponentialFit {
  Eigen::VectorXcd poles;     ///< 1/s, imaginary part within Nyquist
  Eigen::MatrixXcd residues;  ///< [pole][channel]

  /// samples x channels.
  Eigen::MatrixXd reconstruct(Eigen::Index samples, double sample_rate_hz) const;
};

/// Prony's method, Eqs. (4.9)-(4.13): `pairs` pairs of exponentials through exactly 4*pairs samples of one channel,
/// a transformation and no estimate. Throws std::invalid_argument for another number of samples.
ExponentialFit prony(const Eigen::Ref<const Eigen::VectorXd>& samples, double sample_rate_hz, int pairs);

/// Complex exponential algorithm (least-squares Prony), Eqs. (4.14)-(4.19): samples x channels that share 2*pairs
/// poles, rows of all channels stacked. Its polynomial is biased by noise. At least 4*pairs samples.
ExponentialFit complex_exponential(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                                   int pairs);

/// Pisarenko's harmonic decomposition: frequencies (rad/s, ascending) of `tones` stationary tones of one channel,
/// from the eigenvector of the smallest eigenvalue of the Toeplitz matrix of autocorrelations; poles are put on the
/// unit circle. noise_variance is that eigenvalue. It assumes a stationary signal and loses its phases.
struct PisarenkoFit {
  Eigen::VectorXd frequencies;
  double noise_variance = 0;
};
PisarenkoFit pisarenko(const Eigen::Ref<const Eigen::VectorXd>& samples, double sample_rate_hz, int tones);

/// Highest ordinate of the discrete Fourier transform of one channel (boxcar, no padding) within one bin around
/// `near` (rad/s), as p cos + q sin with t = 0 at the first sample.
struct SpectrumPeak {
  double frequency = 0;  ///< rad/s, centre of a bin
  double p = 0, q = 0;
};
SpectrumPeak spectrum_peak(const Eigen::Ref<const Eigen::VectorXd>& samples, double sample_rate_hz, double near);

}  // namespace secular
