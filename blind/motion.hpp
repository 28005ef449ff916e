#pragma once

#include <cstddef>
#include <vector>

#include "blind/structure.hpp"

namespace secular::blind {

inline constexpr double sample_rate_hz = 256;
inline constexpr std::size_t ensemble_samples = 1024;

/// How a dwell is brought to its steady state: by going through it in blocks of about one time constant and a whole
/// number of periods, until the ends of blocks have a limit that is near. What repeats after two periods of the
/// excitation only is watched by itself.
struct Settling {
  double time_constant = 1;        ///< s, of the slowest decay
  std::size_t periods_of_two = 1;  ///< the response repeats after this many periods of the excitation
  int least_blocks = 12, most_blocks = 400;
  double tolerance = 1e-4;   ///< largest distance of a mode's state from its limit, relative to its amplitude
  std::size_t substeps = 4;  ///< integration steps between two samples
};

/// Samples of a record at `sample_rate_hz`, from t = 0 on.
struct Motion {
  std::vector<std::vector<double>> displacement, acceleration;  ///< of each mode
  std::vector<double> extra_displacement, extra_acceleration;   ///< of the mode that no model knows
  std::size_t samples() const { return extra_displacement.size(); }
};

/// How far mode k's state is from another one, as an amplitude: sqrt(q^2 + (q'/omega)^2) of their difference.
double distance(const Structure& structure, const State& a, const State& b, std::size_t k);

/// The state at t = 0 of a settled dwell.
State settled_state(const Structure& structure, const Drive& drive, const State& from, const Settling& settling);

/// The motion that goes on from a state at t = 0, by `substeps` integration steps from sample to sample.
Motion recorded_motion(const Structure& structure, const Drive& drive, const State& from, std::size_t samples,
                       std::size_t substeps);

}  // namespace secular::blind
