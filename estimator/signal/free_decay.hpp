#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace secular {

/// Where a free swing begins in a record, and its frequency there.
struct DecayStart {
  Eigen::Index sample = 0;
  double frequency = 0;  ///< rad/s, of the fundamental
};

/// Finds the beginning of a free decay: whatever the structure did before release (held still, pulled, struck), the
/// largest excursion comes last before it swings freely. The decay is taken from the first crossing of the rest
/// position after the signal was last within 1 % of its largest excursion, moved on by half periods while a damped
/// sine with harmonics leaves clearly more there than later on (a hand that still touches). Nothing if no
/// oscillation of at least eight half periods follows. samples: one channel; rate in Hz.
std::optional<DecayStart> find_decay_start(const Eigen::Ref<const Eigen::VectorXd>& samples, double rate);

/// One window of a decay. Phases and values hold at its centre.
struct DecayWindow {
  double centre_s = 0;  ///< from the first sample handed over
  double frequency = 0, growth = 0, frequency_sd = 0, growth_sd = 0;
  Eigen::MatrixXcd amplitude;  ///< [harmonic][channel], half of the peak
  Eigen::MatrixXd amplitude_sd;
  Eigen::VectorXd offset, noise_sd;
};

struct WindowOptions {
  double periods = 2;    ///< length of a window
  double overlap = 0.75;  ///< share of a window that the next one sees again, in [0, 1)
  std::vector<int> harmonics = {1, 3, 5};
  double end_at_noise = 6;  ///< the decay ends where its amplitude is below this many noise levels
};

/// Windows over samples x channels (the decay alone, from its start). Each is a tone with harmonics whose frequency
/// and growth change linearly in time, started from a circular-hyperbolic decomposition of the decimated window.
std::vector<DecayWindow> sliding_windows(const Eigen::Ref<const Eigen::MatrixXd>& channels, double rate,
                                         double frequency, const WindowOptions& options);

/// Dominant frequency (rad/s) near `expected` from a circular-hyperbolic decomposition of the samples, averaged
/// down to about 16 a period. Returns `expected` where the decomposition sees nothing within 20 % of it.
double decomposed_frequency(const Eigen::Ref<const Eigen::VectorXd>& samples, double rate, double expected);

}  // namespace secular
