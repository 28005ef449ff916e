#include "blind/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blind/integrator.hpp"

namespace secular::blind {

State settled_state(const Structure& structure, const Drive& drive, const State& from, const Settling& settling) {
  const double period = 2 * std::numbers::pi / drive.frequency * static_cast<double>(settling.periods_of_two);
  const double block = period * std::max(1.0, std::round(settling.time_constant / period));
  const double wanted = 1 / (sample_rate_hz * static_cast<double>(settling.substeps));
  const auto steps = static_cast<std::size_t>(std::ceil(block / wanted));
  const double step = block / static_cast<double>(steps);
  State before = from;
  for (int count = 1; count <= settling.most_blocks; ++count) {
    Integrator integrator(structure, drive, -block, before);
    for (std::size_t i = 0; i < steps; ++i) integrator.advance(step);
    const State& after = integrator.state();
    double worst = 0;
    for (std::size_t k = 0; k < structure.modes; ++k) {
      const double omega = structure.mode[k].omega;
      const double size = std::hypot(displacement(after, k), velocity(after, k) / omega);
      const double change = std::hypot(displacement(after, k) - displacement(before, k),
                                       (velocity(after, k) - velocity(before, k)) / omega);
      if (size > 0) worst = std::max(worst, change / size);
    }
    before = after;
    if (count >= settling.least_blocks && worst < settling.tolerance) break;
  }
  return before;
}

Motion recorded_motion(const Structure& structure, const Drive& drive, const State& from, std::size_t samples,
                       std::size_t substeps) {
  Motion motion;
  motion.displacement.assign(structure.modes, std::vector<double>(samples));
  motion.acceleration.assign(structure.modes, std::vector<double>(samples));
  motion.extra_displacement.assign(samples, 0);
  motion.extra_acceleration.assign(samples, 0);
  Integrator integrator(structure, drive, 0, from);
  const double step = 1 / (sample_rate_hz * static_cast<double>(substeps));
  for (std::size_t i = 0; i < samples; ++i) {
    const Accelerations a = integrator.acceleration();
    for (std::size_t k = 0; k < structure.modes; ++k) {
      motion.displacement[k][i] = displacement(integrator.state(), k);
      motion.acceleration[k][i] = a.modal[k];
    }
    motion.extra_displacement[i] = integrator.state()[extra_at];
    motion.extra_acceleration[i] = a.extra;
    for (std::size_t j = 0; j < substeps; ++j) integrator.advance(step);
  }
  return motion;
}

}  // namespace secular::blind
