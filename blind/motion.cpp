#include "blind/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "blind/integrator.hpp"

namespace secular::blind {
namespace {

// Of a subharmonic below this share of the motion that does not grow there is nothing to see.
constexpr double no_subharmonic = 1e-7;

/// A sequence of states that goes somewhere.
class Approach {
 public:
  explicit Approach(const Structure& structure) : structure_(structure) {}

  void add(const State& state) {
    last_ = std::exchange(now_, state);
    for (std::size_t k = 0; k < structure_.modes; ++k) {
      const double step = distance(structure_, now_, last_, k);
      factor_[k] = step / step_[k];
      step_[k] = step;
    }
  }

  double size(std::size_t k) const { return distance(structure_, now_, State{}, k); }
  bool grows(std::size_t k) const { return size(k) > distance(structure_, last_, State{}, k); }

  // Steps that shrink by the same factor add up to what is left to go.
  bool has_arrived(std::size_t k, double tolerance) const {
    constexpr double rounding = 0.01;  // steps below this share have no factor that could be told
    if (step_[k] <= rounding * tolerance) return true;
    return step_[k] < tolerance && factor_[k] < 1 && step_[k] * factor_[k] / (1 - factor_[k]) < tolerance;
  }

 private:
  const Structure& structure_;
  State now_{}, last_{};
  std::array<double, most_modes> step_{}, factor_{};
};

}  // namespace

double distance(const Structure& structure, const State& a, const State& b, std::size_t k) {
  return std::hypot(displacement(a, k) - displacement(b, k),
                    (velocity(a, k) - velocity(b, k)) / structure.mode[k].omega);
}

State settled_state(const Structure& structure, const Drive& drive, const State& from, const Settling& settling) {
  const double period = two_pi / drive.frequency;
  const double turn = period * static_cast<double>(settling.periods_of_two);
  const auto periods =
      settling.periods_of_two * static_cast<std::size_t>(std::max(1.0, std::round(settling.time_constant / turn)));
  const double wanted = 1 / (sample_rate_hz * static_cast<double>(settling.substeps));
  const auto steps_of_period = static_cast<std::size_t>(std::ceil(period / wanted));
  const double step = period / static_cast<double>(steps_of_period);

  State state = from;
  Approach motion(structure), subharmonic(structure);
  for (int count = 1; count <= settling.most_blocks; ++count) {
    Integrator integrator(structure, drive, -period * static_cast<double>(periods), state);
    for (std::size_t i = 0; i < (periods - 1) * steps_of_period; ++i) integrator.advance(step);
    const State a_period_ago = integrator.state();
    for (std::size_t i = 0; i < steps_of_period; ++i) integrator.advance(step);
    state = integrator.state();
    motion.add(state);
    // What changes its sign from one period of the excitation to the next may still grow from next to nothing
    // beneath a large motion that has long settled.
    State alternating{};
    for (std::size_t i = 0; i < state.size(); ++i) alternating[i] = 0.5 * (state[i] - a_period_ago[i]);
    subharmonic.add(alternating);
    const auto has_settled = [&](std::size_t k) {
      if (!motion.has_arrived(k, settling.tolerance * motion.size(k))) return false;
      if (settling.periods_of_two == 1) return true;
      const bool is_none = subharmonic.size(k) <= no_subharmonic * motion.size(k) && !subharmonic.grows(k);
      return is_none || subharmonic.has_arrived(k, settling.tolerance * subharmonic.size(k));
    };
    bool settled = count >= settling.least_blocks;
    for (std::size_t k = 0; k < structure.modes; ++k) settled = settled && has_settled(k);
    if (settled) break;
  }
  return state;
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
