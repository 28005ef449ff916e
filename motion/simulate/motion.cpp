#include "motion/simulate/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "input/input_error.hpp"

namespace secular {
namespace {

using State = OdeState;  // displacements, velocities, then the armature's displacement and velocity if there is one

constexpr std::size_t most_steps_in_a_sample_interval = 100000;

// Phase of a slip element: sliding with a sign, or sticking with the displacement at which its spring is relaxed.
struct SlipPhase {
  int sliding = 0;
  double anchor = 0;
};

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
        side_(modes_, 0),
        phases_(settings.slip_elements.size()),
        samples_(std::max<std::size_t>(1, model.excitations.size())),
        reaction_(modes_) {
    if (settings.armature)
      feeds_back_ = std::any_of(settings.armature->feedback.begin(), settings.armature->feedback.end(),
                                [](double f) { return f != 0; });
  }

  void accelerations(const State& x, double time, double* result) const {
    supply_excitation(x, time);
    model_.acceleration(parameters_, samples_.data(), x.data(), one_side(x), result);
    for (std::size_t k = 0; k < modes_; ++k)
      if (held_[k]) result[k] = 0;
  }

  void operator()(const State& x, State& rate, double time) const {
    for (std::size_t k = 0; k < modes_; ++k) rate[k] = held_[k] ? 0.0 : x[modes_ + k];
    accelerations(x, time, rate.data() + modes_);
    if (settings_.armature) {
      rate[2 * modes_] = x[2 * modes_ + 1];
      rate[2 * modes_ + 1] = samples_[0].value;
    }
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
    const int side = side_[k];
    held_[k] = false;
    side_[k] = 0;
    x[modes_ + k] = 1e-300;
    accelerations(x, time, a.data());
    const double above = a[k];
    x[modes_ + k] = -1e-300;
    accelerations(x, time, a.data());
    held_[k] = was_held;
    side_[k] = side;
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

  // Where dry friction acts on mode k, from a state at the begin of a step: held, or on the side of zero velocity
  // that it moves on or leaves to.
  void take_side(const State& x, double time, std::size_t k) {
    held_[k] = false;
    side_[k] = 0;
    const double v = x[modes_ + k];
    if (v == 0) held_[k] = sticks(x, time, k);
    if (held_[k]) return;
    if (v != 0) {
      side_[k] = v > 0 ? 1 : -1;
    } else {
      const auto [above, below] = one_sided(x, time, k);
      side_[k] = above > 0 ? 1 : (below < 0 ? -1 : 0);
    }
  }

  std::size_t modes() const { return modes_; }
  bool held(std::size_t k) const { return held_[k]; }
  /// The sign of mode k's velocity in this step; 0: either.
  int side(std::size_t k) const { return side_[k]; }
  const std::vector<ExcitationSample>& excitation() const { return samples_; }

  std::size_t elements() const { return phases_.size(); }
  std::size_t element_mode(std::size_t e) const { return settings_.slip_elements[e].mode; }
  double elastic(const State& x, std::size_t e) const {
    const SlipElement& element = settings_.slip_elements[e];
    return phases_[e].sliding != 0 ? phases_[e].sliding * element.slip : x[element.mode] - phases_[e].anchor;
  }
  void place(const State& x, std::size_t e, double z) {
    const SlipElement& element = settings_.slip_elements[e];
    z = std::clamp(z, -element.slip, element.slip);
    const int side = z > 0 ? 1 : -1;
    phases_[e] = {0, x[element.mode] - z};
    if (std::abs(z) >= element.slip && x[modes_ + element.mode] * side > 0) phases_[e].sliding = side;
  }
  // Positive until the element's phase ends: by |z| = slip while it sticks, by a reversal while it slides.
  double margin(const State& x, std::size_t e) const {
    const SlipElement& element = settings_.slip_elements[e];
    if (phases_[e].sliding != 0) return phases_[e].sliding * x[modes_ + element.mode];
    return element.slip - std::abs(x[element.mode] - phases_[e].anchor);
  }
  void change_phase(const State& x, std::size_t e) {
    const SlipElement& element = settings_.slip_elements[e];
    SlipPhase& phase = phases_[e];
    if (phase.sliding != 0)
      phase = {0, x[element.mode] - phase.sliding * element.slip};
    else
      phase.sliding = x[element.mode] > phase.anchor ? 1 : -1;
  }
  bool sliding(std::size_t e) const { return phases_[e].sliding != 0; }

 private:
  // Velocities with those of one sign kept to it: within a step the equations are those of one side of a jump at
  // zero velocity, smooth across it, and the step ends where the velocity comes to zero. (A step control that meets
  // the jump itself makes its steps ever smaller in front of it where the mode is about to stick.)
  const double* one_side(const State& x) const {
    velocity_.assign(x.begin() + static_cast<std::ptrdiff_t>(modes_),
                     x.begin() + static_cast<std::ptrdiff_t>(2 * modes_));
    for (std::size_t k = 0; k < modes_; ++k)
      if (side_[k] != 0 && velocity_[k] * side_[k] <= 0) velocity_[k] = side_[k] * 1e-300;
    return velocity_.data();
  }

  void supply_excitation(const State& x, double time) const {
    // Methods ask more than once for a time: the last stage of a step, its end, the sample there.
    if (excitation_ && (settings_.armature || time != supplied_at_)) excitation_(time, samples_.data());
    supplied_at_ = time;
    for (std::size_t e = 0; e < phases_.size(); ++e)
      samples_[settings_.slip_elements[e].excitation] = {elastic(x, e), 0, 0};
    for (const std::size_t clock : settings_.clocks) samples_[clock] = {settings_.clock_origin + time, 1, 0};
    if (settings_.armature) move_base(x);
  }

  // From command to base acceleration. With feedback the structure's accelerations depend on the base's: affine in
  // it for most models, so that the first secant step hits; powers of the excitation take some more.
  void move_base(const State& x) const {
    const Armature& armature = *settings_.armature;
    const double w = armature.omega, loss = 2 * armature.damping * w;
    const ExcitationSample command = samples_[0];
    const double position = x[2 * modes_], speed = x[2 * modes_ + 1];
    const double undisturbed = command.value - loss * speed - w * w * position;
    const auto imbalance = [&](double base) {
      samples_[0].value = base;
      samples_[0].first_derivative = command.first_derivative - loss * base - w * w * speed;
      samples_[0].second_derivative =
          command.second_derivative - loss * samples_[0].first_derivative - w * w * base;
      if (!feeds_back_) return 0.0;
      model_.acceleration(parameters_, samples_.data(), x.data(), one_side(x), reaction_.data());
      double sum = base - undisturbed;
      for (std::size_t k = 0; k < modes_; ++k) sum += armature.feedback[k] * (held_[k] ? 0.0 : reaction_[k]);
      return sum;
    };
    double base = undisturbed, rest = imbalance(base);
    if (rest == 0) return;
    double next = base - rest;
    for (int step = 0; step < 20; ++step) {
      const double next_rest = imbalance(next), slope = (next_rest - rest) / (next - base);
      base = next;
      rest = next_rest;
      if (std::abs(rest) <= 1e-14 * (std::abs(base) + std::abs(undisturbed)) || slope == 0) return;
      next = base - rest / slope;
      if (next == base) return;
    }
  }

  const CompiledModel& model_;
  const double* parameters_;
  const ExcitationSignal& excitation_;
  const MotionSettings& settings_;
  std::size_t modes_;
  mutable std::vector<bool> held_;
  mutable std::vector<int> side_;
  mutable std::vector<double> velocity_;
  std::vector<SlipPhase> phases_;
  mutable std::vector<ExcitationSample> samples_;
  mutable std::vector<double> reaction_;
  mutable double supplied_at_ = std::numeric_limits<double>::quiet_NaN();
  bool feeds_back_ = false;
};

constexpr std::size_t none = static_cast<std::size_t>(-1);

// What ends a step early: a velocity that friction acts on comes to zero, or a slip element changes phase.
struct Event {
  double when = 0;
  std::size_t stopped = none, element = none;
  bool found() const { return stopped != none || element != none; }
};

class EventSearch {
 public:
  EventSearch(const Motion& motion, const Stepper& stepper, const State& before)
      : motion_(motion),
        stepper_(stepper),
        before_(before),
        begin_(stepper.previous_time()),
        end_(stepper.time()),
        at_(before.size()) {}

  Event first(bool dry) {
    const State& now = stepper_.state();
    const std::size_t modes = motion_.modes();
    for (std::size_t k = 0; dry && k < modes; ++k) {
      const int side = motion_.side(k);
      if (motion_.held(k) || side == 0 || side * now[modes + k] > 0) continue;
      double when = root(end_, [&](const State& x) { return side * x[modes + k] > 0; });
      // From rest and back within a step, by less than can be told: the step counts.
      if (before_[modes + k] == 0 && when - begin_ < 1e-9 * (end_ - begin_)) when = end_;
      if (!event_.found() || when < event_.when) event_ = {when, k, none};
    }
    for (std::size_t e = 0; e < motion_.elements(); ++e) {
      const auto inside = [&](const State& x) { return motion_.margin(x, e) >= 0; };
      double end = end_;
      if (inside(now)) {
        if (motion_.sliding(e)) continue;
        // The displacement may have turned back within the step, beyond the slip.
        const std::size_t v = modes + motion_.element_mode(e);
        if (before_[v] * now[v] >= 0) continue;
        end = root(end_, [&](const State& x) { return x[v] * before_[v] > 0; });
        stepper_.state_at(end, at_);
        if (inside(at_)) continue;
      }
      const double when = root(end, inside);
      if (!event_.found() || when < event_.when) event_ = {when, none, e};
    }
    return event_;
  }

 private:
  // Where `holds` ends between the step's begin and `high`.
  template <class Condition>
  double root(double high, const Condition& holds) {
    double low = begin_;
    for (int bisection = 0; bisection < 60; ++bisection) {
      const double middle = 0.5 * (low + high);
      stepper_.state_at(middle, at_);
      (holds(at_) ? low : high) = middle;
    }
    return high;
  }

  const Motion& motion_;
  const Stepper& stepper_;
  const State& before_;
  double begin_, end_;
  State at_;
  Event event_;
};

}  // namespace

void integrate_motion(const CompiledModel& model, const double* parameters, const ExcitationSignal& excitation,
                      double from, std::vector<double>& displacement, std::vector<double>& velocity, double first,
                      double step, std::size_t count, const MotionSettings& settings,
                      const std::function<void(const MotionSample&)>& sample, MotionMemory* memory) {
  Motion motion(model, parameters, excitation, settings);
  const OdeRate rate = std::ref(motion);
  const std::size_t modes = motion.modes();
  State x = displacement;
  x.insert(x.end(), velocity.begin(), velocity.end());
  if (settings.armature) {
    x.push_back(memory ? memory->base : 0.0);
    x.push_back(memory ? memory->base_rate : 0.0);
  }
  for (std::size_t e = 0; e < motion.elements(); ++e) {
    const bool loaded = memory && e < memory->elastic_displacement.size();
    motion.place(x, e, loaded ? memory->elastic_displacement[e] : x[motion.element_mode(e)]);
  }
  const bool fixed = settings.method == Integrator::runge_kutta_4;
  const double longest =
      fixed ? (settings.fixed_step > 0 ? settings.fixed_step : step / 16) : settings.largest_step;
  const std::unique_ptr<Stepper> stepper =
      make_stepper({settings.method, settings.relative_tolerance, settings.absolute_tolerance,
                    settings.largest_step > 0 ? std::min(settings.largest_step, 0.1 * step) : 0.1 * step,
                    fixed && settings.largest_step > 0 ? std::min(longest, settings.largest_step) : longest});
  std::vector<bool> jumps(modes);
  for (std::size_t k = 0; k < modes; ++k) jumps[k] = motion.has_dry_friction(x, from, k);
  const bool dry = std::find(jumps.begin(), jumps.end(), true) != jumps.end();
  const auto settle_friction = [&] {
    for (std::size_t k = 0; dry && k < modes; ++k)
      if (jumps[k]) motion.take_side(x, stepper->time(), k);
  };
  stepper->start(x, from);
  if (dry) settle_friction();
  State at(x.size()), previous(x.size());
  MotionSample out;
  MotionMemory remembered;
  remembered.elastic_displacement.resize(motion.elements());
  std::vector<double> acceleration(modes);
  const auto emit = [&](const State& state, double when) {
    motion.accelerations(state, when, acceleration.data());
    out.time = when;
    out.displacement.assign(state.begin(), state.begin() + static_cast<std::ptrdiff_t>(modes));
    out.velocity.assign(state.begin() + static_cast<std::ptrdiff_t>(modes),
                        state.begin() + static_cast<std::ptrdiff_t>(2 * modes));
    out.acceleration = acceleration;
    out.excitation = motion.excitation();
    for (std::size_t e = 0; e < motion.elements(); ++e)
      remembered.elastic_displacement[e] = motion.elastic(state, e);
    if (settings.armature) {
      remembered.base = state[2 * modes];
      remembered.base_rate = state[2 * modes + 1];
    }
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
    if (due() <= stepper->time()) {
      if (due() == stepper->time()) {
        at = stepper->state();
      } else {
        stepper->state_at(due(), at);
      }
      emit(at, due());
      ++next;
      continue;
    }
    if (++steps_taken % most_steps_in_a_sample_interval == 0) {
      if (stepper->time() - checked_time < step)
        throw InputError(settings.label, fmt::format("t = {:.6g} s", stepper->time()),
                         "the integration makes no progress", "the equations may be stiff or discontinuous there");
      checked_time = stepper->time();
    }
    previous = stepper->state();
    stepper->advance(rate, due());
    if (!dry && motion.elements() == 0) continue;
    const Event event = EventSearch(motion, *stepper, previous).first(dry);
    if (!event.found() && !any_held()) continue;
    const double time = event.found() ? event.when : stepper->time();
    while (next < count && due() <= time) {  // these samples still come from this step
      stepper->state_at(due(), at);
      emit(at, due());
      ++next;
    }
    stepper->state_at(time, x);
    if (event.stopped != none) x[modes + event.stopped] = 0;
    if (event.element != none) motion.change_phase(x, event.element);
    stepper->start(x, time);
    settle_friction();
  }
  displacement = out.displacement;
  velocity = out.velocity;
  if (memory) *memory = remembered;
}

}  // namespace secular
