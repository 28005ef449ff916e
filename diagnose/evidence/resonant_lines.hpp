#pragma once

#include <optional>
#include <vector>

#include "motion/balance/torus.hpp"

namespace secular {

/// How the motion of a dwell is laid out: which base phases it has, which line the excitation is on, and which line
/// of which mode is near resonance.
struct LineLayout {
  struct Resonance {
    std::size_t mode = 0;
    LinePhase line{};
  };
  int dimensions = 1;
  int divisor = 1;  ///< one dimension: the base frequency is the excitation's divided by this
  LinePhase excitation{1, 0};
  std::vector<Resonance> resonances;
};

/// Layouts that natural frequencies suggest for an excitation at `excitation` (rad/s), the likeliest first; the
/// last has no resonance: forced motion alone. Two dimensions: line {1,0} belongs to the lower mode of the pair,
/// {0,1} to the higher.
std::vector<LineLayout> possible_layouts(const std::vector<double>& natural_frequency, double excitation);

}  // namespace secular
