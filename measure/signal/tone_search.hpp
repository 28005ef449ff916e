#pragma once

#include <Eigen/Core>
#include <vector>

#include "measure/signal/pole.hpp"
#include "measure/signal/refine_poles.hpp"

namespace secular {

/// Highest ordinate of the periodograms of samples x channels, summed over channels after each is put into units of
/// its noise, and the probability that white noise gives one as high anywhere between the first bin and Nyquist.
struct SpectralPeak {
  double frequency = 0;  ///< rad/s
  double ordinate = 0;   ///< sum over channels, each exponential with mean one in white noise
  double probability = 1;
};

/// `padding` is the ratio of transform length to samples; `unknowns` were fitted to each channel before. With white
/// noise of unknown level the ordinate z of one channel is turned into one with exactly exponential law, and the
/// maximum over frequency follows from the rate of upcrossings (Davies 1987; Baluev 2008 for one channel):
/// P ~ Q(z) + W z^(c-1/2) e^-z / Gamma(c), W = (N/2) sqrt(pi/3) for c channels.
SpectralPeak spectral_peak(const Eigen::Ref<const Eigen::MatrixXd>& residual, double sample_rate_hz, int padding,
                           double unknowns);

struct ToneSearchOptions {
  int max_tones = 12;
  double false_alarm = 0.01;  ///< a further tone must be this unlikely in white noise; 1 takes max_tones always
  std::vector<Pole> beside;   ///< poles that are there anyway (constant, imposed)
};

/// Tones found one by one.
struct ToneSearch {
  std::vector<double> probability;  ///< of each tone in the order found, then of the peak that was refused
  RefinedPoles fit;                 ///< `beside` first, then the tones in the order found
  int tones = 0;
};

/// Number of tones by a test: the highest peak of what is left is tested against white noise; while it is
/// significant, a circular pole is added there and all are refined together.
ToneSearch search_tones(const Eigen::Ref<const Eigen::MatrixXd>& channels, double sample_rate_hz,
                        const ToneSearchOptions& options);

}  // namespace secular
