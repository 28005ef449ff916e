#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <string>
#include <vector>

namespace secular {

/// The structure on its own, in one or several records: rows x (channels of record 0, of record 1, ...).
struct FreeMotions {
  Eigen::MatrixXd samples;
  Eigen::Index channels = 0;
  double sample_rate_hz = 0;
  std::vector<std::string> groups;  ///< by record: how it was excited; those of one group should repeat
};

/// What the free motions say of a pole that was handed over.
struct PoleSupport {
  bool stands = false;
  std::string reason;  ///< why it does not stand
  bool moves = false;  ///< it is motion and not noise; of what does not stand: without a resonance
  std::complex<double>
      pole;              ///< rad/s, maximum likelihood in the noise as it was measured; as given where it falls
  double growth_sd = 0;  ///< of the real part, 1/s, in this noise, were the motion as the fit has it
  double omega_sd = 0;   ///< of the imaginary part, rad/s, likewise
  std::complex<double> value;  ///< the pole in noise that holds nothing of what the fit lacks near its poles
  double growth_error = 0, omega_error = 0;  ///< standard deviations of the value, with what Eqs. (M7), (M8) add
  std::vector<double> amplitudes;  ///< by record, at its first row: root of the sum of squares over channels
  bool more_than_noise = false;    ///< is left near the pole: Eqs. (M5), (M6)
  bool all_constant = true;        ///< no pole of the fit leaves more than noise
  int beside = -1;                 ///< of a second mode that was seen as one with a candidate: place of that
};

/// Which of the candidates are motion and not noise. The noise is what all of them together leave, and its colour
/// is taken out first. Then poles are added one by one, each time the one that explains most, all carried to
/// maximum likelihood together. In white noise the sum of squares falls by chi-squared with 2 + 2 signals degrees
/// of freedom for a pole that means nothing; as poles are looked for everywhere, its probability counts once for
/// every pole that the records can tell apart, and must stay below `false_alarm`. The poles that stand are left out
/// again in turn, since of two that lie close the first may have served for both. Where records repeat each other
/// (one group), the one that shows a pole most is left out, and the others must still show it. A pole whose error
/// bar is as wide as its resonance says nothing. Where more than noise is left near a pole, two in its place are
/// held against one that changes with amplitude, Eq. (M9): second modes follow behind the candidates. Channels that
/// are sums of others, or constant, do not count. `progress` hears which share of the candidates is decided on.
std::vector<PoleSupport> pole_support(const FreeMotions& motions,
                                      const std::vector<std::complex<double>>& candidates,
                                      double false_alarm = 0.01, const std::function<void(double)>& progress = {});

}  // namespace secular
