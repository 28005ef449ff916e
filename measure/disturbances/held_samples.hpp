#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measure/data/watched_reader.hpp"

namespace secular {

/// Samples that repeat the one before although the signal went on.
struct HeldSamples {
  /// Samples that repeat the one before `begin`.
  struct Run {
    std::size_t begin = 0, end = 0;
  };
  std::vector<Run> runs;    ///< rising; empty where chance explains them
  std::vector<Run> likely;  ///< rising; that chance makes with less than one half, and may all have made
  double expected = 0;      ///< runs that chance makes, at most
};

/// A sample equals the one before by chance with a probability of at most q times the density of their difference
/// at zero, where q is the smallest gap between values of that size. Let y be what the samples around the two tell
/// of their difference, and s the sd of it about that: the density is at most 1/s, and by Gauss's inequality for
/// laws with one mode 16/9 s^2/y^3. Told is it by one sample on either side, or by two, whichever leaves less. Where
/// y is below s, or the slope before a run and the jump behind it have different signs (turning points, rest), y is
/// zero, and s the noise where that is less: sampling in step with the motion repeats one turning point.
/// The runs found are compared with the sum of these probabilities by a Poisson law, among all samples and among
/// those that chance repeats once in 10, 100 and 1000 times at most: where the signal is steep few held samples are
/// enough. The excess tells the share of samples that are held, and what chance repeats more seldom than that is
/// held. A run of n repeats, of that probability to the n-th power, may be long enough by itself. Rest at the begin
/// of a record is not held. A clipped channel is not judged.
HeldSamples find_held(std::span<const double> samples, const ChannelValues& values, double false_alarm);

}  // namespace secular
