#include "simulate/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "input/input_error.hpp"

namespace secular {
namespace {

namespace odeint = boost::numeric::odeint;
using State = std::vector<double>;  // displacements, then velocities

constexpr std::size_t most_steps_in_a_sample_interval = 100000;

class Motion {
 public:
  Motion(const CompiledModel& model, const double* parameters, const ExcitationSignal& excitation,
         const MotionSettings& settings)
      : model_(model),
        parameters_(parameters),
        excitation_(excitation),
        settings_(settings),
        modes_(model.modes()),
        held_(modes_, false),
        samples_(std::max<std::size_t>(1, model.excitations.size())) {}

  void accelerations(const State& x, double time, double* result) const {
    if (excitation_) excitation_(time, samples_.data());
    model_.acceleration(parameters_, samples_.data(), x.data(), x.data() + modes_, result);
    for (std::size_t k = 0; k < modes_; ++k)
      if (held_[k]) result[k] = 0;
  }

  void operator()(const State& x, State& rate, double time) const {
    for (std::size_t k = 0; k < modes_; ++k) rate[k] = held_[k] ? 0.0 : x[modes_ + k];
    accelerations(x, time, rate.data() + modes_);
    const double largest = std::abs(
        *std::max_element(x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    if (!std::isfinite(largest) || largest > 1e12)
      throw InputError(settings_.label, fmt::format("t = {:.6g} s", time),
                       "the simulated motion grows beyond bounds",
                       "check the signs of stiffness and damping, or lower the excitation");
  }

  // Accelerations of mode k for a vanishing velocity from above and from below.
  std::pair<double, double> one_sided(State x, double time, std::size_t k) const {
    std::vector<double> a(modes_);
    const bool was_held = held_[k];
    held_[k] = false;
    x[modes_ + k] = 1e-300;
    accelerations(x, time, a.data());
    const double above = a[k];
    x[modes_ + k] = -1e-300;
    accelerations(x, time, a.data());
    held_[k] = was_held;
    return {above, a[k]};
  }

  // Dry friction holds where motion either way is pushed back.
  bool sticks(const State& x, double time, std::size_t k) const {
    const auto [above, below] = one_sided(x, time, k);
    return above <= 0 && below >= 0 && above < below;
  }
  // Jumps at zero velocity at all: otherwise nothing of this applies.
  bool has_dry_friction(const State& x, double time, std::size_t k) const {
    const auto [above, below] = one_sided(x, time, k);
    return std::abs(above - below) > 1e-12 * (std::abs(above) + std::abs(below));
  }

  std::size_t modes() const { return modes_; }
  bool held(std::size_t k) const { return held_[k]; }
  void hold(std::size_t k, bool value) const { held_[k] = value; }

 private:
  const CompiledModel& model_;
  const double* parameters_;
  const ExcitationSignal& excitation_;
  const MotionSettings& settings_;
  std::size_t modes_;
  mutable std::vector<bool> held_;
  mutable std::vector<ExcitationSample> samples_;
};

}  // namespace

void integrate_motion(const CompiledModel& model, const double* parameters, const ExcitationSignal& excitation,
                      double from, std::vector<double>& displacement, std::vector<double>& velocity, double first,
                      double step, std::size_t count, const MotionSettings& settings,
                      const std::function<void(const MotionSample&)>& sample) {
  Motion motion(model, parameters, excitation, settings);
  const std::size_t modes = motion.modes();
  State x = displacement;
  x.insert(x.end(), velocity.begin(), velocity.end());
  auto stepper = odeint::make_dense_output(settings.absolute_tolerance, settings.relative_tolerance,
                                           settings.largest_step, odeint::runge_kutta_dopri5<State>());
  const double first_step = settings.largest_step > 0 ? std::min(settings.largest_step, 0.1 * step) : 0.1 * step;
  bool dry = false;
  for (std::size_t k = 0; k < modes; ++k) dry = dry || motion.has_dry_friction(x, from, k);
  double time = from;
  const auto restart = [&] { stepper.initialize(x, time, first_step); };
  const auto settle_friction = [&] {
    for (std::size_t k = 0; k < modes; ++k)
      if (x[modes + k] == 0) motion.hold(k, motion.sticks(x, time, k));
  };
  if (dry) settle_friction();
  restart();
  State at(2 * modes), previous(2 * modes);
  MotionSample out;
  std::vector<double> acceleration(modes);
  const auto emit = [&](const State& state, double when) {
    motion.accelerations(state, when, acceleration.data());
    out.time = when;
    out.displacement.assign(state.begin(), state.begin() + static_cast<std::ptrdiff_t>(modes));
    out.velocity.assign(state.begin() + static_cast<std::ptrdiff_t>(modes), state.end());
    out.acceleration = acceleration;
    sample(out);
  };
  const auto any_held = [&] {
    for (std::size_t k = 0; k < modes; ++k)
      if (motion.held(k)) return true;
    return false;
  };
  std::size_t next = 0, steps_taken = 0;
  double checked_time = from;
  const auto due = [&] { return first + static_cast<double>(next) * step; };
  while (next < count) {
    if (due() <= stepper.current_time()) {
      if (due() == stepper.current_time()) {
        at = stepper.current_state();
      } else {
        stepper.calc_state(due(), at);
      }
      emit(at, due());
      ++next;
      continue;
    }
    if (++steps_taken % most_steps_in_a_sample_interval == 0) {
      if (stepper.current_time() - checked_time < step)
        throw InputError(settings.label, fmt::format("t = {:.6g} s", stepper.current_time()),
                         "the integration makes no progress", "the equations may be stiff or discontinuous there");
      checked_time = stepper.current_time();
    }
    previous = stepper.current_state();
    const auto [begin, end] = stepper.do_step(std::ref(motion));
    if (!dry) continue;
    // Stop at the first velocity that comes to zero in this step: the friction changes sign there.
    const State now = stepper.current_state();
    double crossing = end;
    std::size_t stopped = modes;  // the mode whose velocity vanishes at the crossing
    for (std::size_t k = 0; k < modes; ++k) {
      if (motion.held(k) || previous[modes + k] == 0 || previous[modes + k] * now[modes + k] > 0) continue;
      double low = begin, high = end;
      for (int bisection = 0; bisection < 60; ++bisection) {
        const double middle = 0.5 * (low + high);
        stepper.calc_state(middle, at);
        (at[modes + k] * previous[modes + k] > 0 ? low : high) = middle;
      }
      if (high < crossing || stopped == modes) {
        crossing = std::min(crossing, high);
        stopped = k;
      }
    }
    if (stopped == modes && !any_held()) continue;
    if (stopped != modes) {
      while (next < count && due() <= crossing) {  // samples before the crossing still come from this step
        stepper.calc_state(due(), at);
        emit(at, due());
        ++next;
      }
      stepper.calc_state(crossing, at);
      time = crossing;
      x = at;
      x[modes + stopped] = 0;
    } else {
      time = end;
      x = now;
    }
    settle_friction();
    restart();
  }
  displacement = out.displacement;
  velocity = out.velocity;
}

}  // namespace secular
