#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <vector>

namespace secular {

/// A tone in the readings of a channel that neither excitation nor motion make (mains hum), or that a mode makes
/// which the model does not have. Channel: index of the campaign; in a segment, of its response channels.
struct ForeignTone {
  std::size_t channel = 0;
  double frequency = 0;  ///< rad/s
  double rate = 0;       ///< 1/s, by which it falls; 0: it lasts
};

/// By record.
using ForeignTones = std::map<std::size_t, std::vector<ForeignTone>>;

/// Noise of a channel beside white noise, with a correlation that falls exponentially. Channel: index of the
/// campaign; in a segment, of its response channels, and standard deviations in units of their noise.
struct ColouredNoise {
  std::size_t channel = 0;
  double sd = 0, time_s = 0;
  double white_sd = 0;  ///< of what is white beside it
};

/// By record.
using ColouredNoises = std::map<std::size_t, std::vector<ColouredNoise>>;

struct Segment;

/// What a segment's readings may hold beside its motion, as columns of its errors (channel after channel), of unit
/// length: first zeros that wander, the slowest terms first, then of tones a cosine and a sine and how they grow.
/// Their sizes are unknowns of the segment (docs/inference.md (36)).
Eigen::MatrixXd foreign_columns(const Segment& segment);

/// How many of them, the first ones, so many samples show of zeros.
Eigen::Index zero_count(const Segment& segment, Eigen::Index samples);

/// What a zero that wanders would do to one response channel of a segment, as columns of its errors.
Eigen::MatrixXd wander_columns(const Segment& segment, Eigen::Index channel);

}  // namespace secular
