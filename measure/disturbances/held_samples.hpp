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
  std::vector<Run> likely;  ///< rising; one by one more likely held than not, chance may explain all of them
  double expected = 0;      ///< runs that chance makes, at most
};

/// A sample equals the one before by chance with a probability of at most q times the density of their difference
/// at zero, where q is the smallest gap between values of that size. Let s be the sd of that difference about the
/// local slope and y the slope, both as measured around it: the density is at most 1/s, and by Gauss's inequality
/// for laws with one mode 16/9 s^2/y^3. The runs found are compared with the sum of these probabilities by a
/// Poisson law; a run of n repeats, of that probability to the n-th power, may be long enough by itself. Where the
/// slope before a run and the jump behind it have different signs (turning points, rest) y is zero, and s the noise
/// where that is less: sampling in step with the motion repeats one turning point. Rest at the begin of a record is
/// not held. A clipped channel is not judged.
HeldSamples find_held(std::span<const double> samples, const ChannelValues& values, double false_alarm);

}  // namespace secular
