#pragma once

#include <Eigen/Core>
#include <vector>

#include "measure/modal/eigensystem_realization.hpp"

namespace secular {

/// One impact: force (N samples) and responses (N x p) that begin together, shortly before the hammer touches.
struct ImpactBlock {
  Eigen::VectorXd force;
  Eigen::MatrixXd responses;
};

/// Windows of an impact test; t from the block's first sample. The force is kept as it is up to `force_s`, let down
/// to zero by a quarter cosine over the next tenth of that time, and zero beyond (no window where it is zero).
/// Force and responses alike are multiplied by exp(-decay t): that moves every pole by -decay, which the user of
/// the frequency response takes off again.
struct ImpactWindows {
  double force_s = 0;  ///< s
  double decay = 0;    ///< 1/s
};

/// Frequency responses of p channels to one reference, from impacts at one point.
struct FrequencyResponse {
  Eigen::VectorXd frequency_hz;  ///< lines, from zero to half the sample rate
  Eigen::MatrixXcd h1;           ///< lines x p, sum(X conj F) / sum(|F|^2): unbiased by noise on the response
  Eigen::MatrixXcd h2;           ///< lines x p, sum(|X|^2) / sum(F conj X): unbiased by noise on the force
  Eigen::MatrixXd coherence;     ///< lines x p, H1/H2; one where a single impact leaves nothing to compare
  Eigen::MatrixXd h1_sd;         ///< lines x p, of |H1| from coherence and number of impacts; zero for one impact
  int impacts = 0;
  ImpactWindows windows;
};

/// Sums over impacts from which the estimates follow: impacts come one at a time and leave again.
struct ImpactSpectra {
  Eigen::VectorXd force_power;  ///< lines, sum of |F|^2
  Eigen::MatrixXd power;        ///< lines x p, sum of |X|^2
  Eigen::MatrixXcd cross;       ///< lines x p, sum of X conj F
  int impacts = 0;

  /// Empty sums take the size of the first; throws std::invalid_argument for one of another size.
  void add(const ImpactSpectra& other);
  /// Of one that was added.
  void remove(const ImpactSpectra& other);
};

/// Those of one impact. Throws std::invalid_argument for an odd number of samples, fewer than four, or no response.
ImpactSpectra impact_spectra(const ImpactBlock& impact, double sample_rate_hz, const ImpactWindows& windows);

/// H1, H2 and coherence from the sums. Throws std::invalid_argument for none and for sums without any force.
FrequencyResponse frequency_response(const ImpactSpectra& sums, double sample_rate_hz,
                                     const ImpactWindows& windows);

/// First samples of the impacts in a force record: where its modulus first passes `share` of the record's largest
/// value after having been below for at least `apart_s`. Two within `apart_s` are one impact with a bounce, counted
/// in `bounces`. None are found where the force is zero throughout. `force`: any unit; rate in Hz.
struct ImpactTimes {
  std::vector<Eigen::Index> samples;
  int bounces = 0;
};
ImpactTimes find_impacts(const Eigen::Ref<const Eigen::VectorXd>& force, double sample_rate_hz, double apart_s,
                         double share = 0.1);

/// Responses to a unit pulse (Appendix A's Y) from accelerances, mobilities or receptances of every reference:
/// lines up to `highest_hz` (all lines x p, one matrix a reference) through the inverse discrete Fourier transform,
/// a sequence with the sample rate 2 * highest line; the second half, which holds what a sharp band limit sends
/// ahead of the impact, is left out. pulse_response throws std::invalid_argument for no reference, and for fewer
/// than four lines.
struct PulseResponse {
  ResponseSequence samples;
  double sample_rate_hz = 0;
};
PulseResponse pulse_response(const Eigen::Ref<const Eigen::VectorXd>& frequency_hz,
                             const std::vector<Eigen::MatrixXcd>& references, double highest_hz);

}  // namespace secular
