#include "motion/simulate/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "input/numerical_failure.hpp"
#include "input/stop_request.hpp"

namespace secular {
namespace {

// Displacements, velocities, then the armature's displacement and velocity if there is one, then what relaxes.
using State = OdeState;

constexpr std::size_t most_steps_in_a_sample_interval = 100000;

/// Peak over rms of the motion before: below 5 for one that builds up, and without bound for one that escapes.
constexpr double escape_factor = 10;

// Of a message: which motion, and when.
std::string heading(const MotionSettings& settings, double time) {
  return fmt::format("{}{}t = {:.6g} s: ", settings.label, settings.label.empty() ? "" : ", ", time);
}

// Phase of a slip element: sliding with a sign, or sticking with the displacement at which its spring is relaxed.
struct SlipPhase {
  int sliding = 0;
  double anchor = 0;
};

class Motion {
 public:
  Motion(const MotionEquations& equations, const MotionSettings& settings)
      : model_(equations.model),
        parameters_(equations.parameters),
        excitation_(equations.excitation),
        settings_(settings),
        modes_(model_.modes()),
        held_(modes_, false),
        side_(modes_, 0),
        phases_(settings.slip_elements.size()),
        samples_(std::max<std::size_t>(1, model_.excitations.size())),
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
    for (std::size_t e = 0; e < settings_.relaxing_elements.size(); ++e) {
      const RelaxingElement& element = settings_.relaxing_elements[e];
      rate[relaxing_at() + e] = rate[element.mode] - x[relaxing_at() + e] / element.time_constant;
    }
    const double largest = std::abs(
        *std::max_element(x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    if (!std::isfinite(largest) || largest > 1e12)
      throw NumericalFailure(
          Ending::ran_away,
          heading(settings_, time) +
              "the simulated motion grows beyond bounds; check the signs of stiffness and damping, "
              "or lower the excitation");
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
  /// Place in the state of the first element that relaxes.
  std::size_t relaxing_at() const { return 2 * modes_ + (settings_.armature ? 2 : 0); }
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
    for (std::size_t e = 0; e < settings_.relaxing_elements.size(); ++e)
      samples_[settings_.relaxing_elements[e].excitation] = {x[relaxing_at() + e], 0, 0};
    for (const std::size_t level : settings_.levels) samples_[level] = {settings_.level * settings_.level, 0, 0};
    for (const LawElement& e : settings_.law_elements)
      samples_[e.excitation] = {e.law(x[e.mode], one_side(x)[e.mode], e.shape, 1), 0, 0};
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

StepperSettings stepper_settings(const MotionSettings& settings, double sample_step) {
  const bool fixed = settings.method == Integrator::runge_kutta_4;
  const double longest =
      fixed ? (settings.fixed_step > 0 ? settings.fixed_step : sample_step / 16) : settings.largest_step;
  return {settings.method, settings.relative_tolerance, settings.absolute_tolerance,
          settings.largest_step > 0 ? std::min(settings.largest_step, 0.1 * sample_step) : 0.1 * sample_step,
          fixed && settings.largest_step > 0 ? std::min(longest, settings.largest_step) : longest};
}

// One integration: steps of a stepper, samples as they fall due, and the events at which a step is cut short.
class Integration {
 public:
  Integration(const MotionEquations& equations, const SampleTimes& times, const MotionSettings& settings,
              const std::function<void(const MotionSample&)>& sample)
      : times_(times),
        settings_(settings),
        sample_(sample),
        motion_(equations, settings),
        rate_(std::ref(motion_)),
        stepper_(make_stepper(stepper_settings(settings, times.step))),
        acceleration_(motion_.modes()),
        squares_(motion_.modes(), 0.0) {}

  void run(MotionState& state) {
    start(state);
    std::size_t steps_taken = 0;
    double checked_time = times_.from;
    State at(x_.size());
    while (next_ < times_.count) {
      end_if_stopped();
      if (due() <= stepper_->time()) {
        if (due() == stepper_->time())
          at = stepper_->state();
        else
          stepper_->state_at(due(), at);
        emit(at);
        continue;
      }
      if (++steps_taken % most_steps_in_a_sample_interval == 0) {
        if (stepper_->time() - checked_time < times_.step) stop_without_progress();
        checked_time = stepper_->time();
      }
      previous_ = stepper_->state();
      stepper_->advance(rate_, due());
      if (dry_ || motion_.elements() > 0) pass_event();
    }
    state = last_;
  }

 private:
  double due() const { return times_.first + static_cast<double>(next_) * times_.step; }

  void start(const MotionState& begin) {
    x_ = begin.displacement;
    x_.insert(x_.end(), begin.velocity.begin(), begin.velocity.end());
    if (settings_.armature) {
      x_.push_back(begin.base);
      x_.push_back(begin.base_rate);
    }
    x_.resize(motion_.relaxing_at());
    x_.insert(x_.end(), begin.relaxing_displacement.begin(), begin.relaxing_displacement.end());
    x_.resize(motion_.relaxing_at() + settings_.relaxing_elements.size(), 0.0);
    for (std::size_t e = 0; e < motion_.elements(); ++e) {
      const bool loaded = e < begin.elastic_displacement.size();
      motion_.place(x_, e, loaded ? begin.elastic_displacement[e] : x_[motion_.element_mode(e)]);
    }
    for (std::size_t k = 0; k < motion_.modes(); ++k)
      jumps_.push_back(motion_.has_dry_friction(x_, times_.from, k));
    dry_ = std::find(jumps_.begin(), jumps_.end(), true) != jumps_.end();
    stepper_->start(x_, times_.from);
    settle_friction();
  }

  // A motion that leaves its potential well, or comes to where the inertia vanishes, makes the steps ever smaller
  // on its way.
  [[noreturn]] void stop_without_progress() const {
    const State& now = stepper_->state();
    for (std::size_t k = 0; k < motion_.modes() && next_ > 0; ++k) {
      const double rms = std::sqrt(squares_[k] / static_cast<double>(next_));
      if (!(std::abs(now[k]) > escape_factor * rms)) continue;
      throw NumericalFailure(
          Ending::ran_away,
          heading(settings_, stepper_->time()) +
              fmt::format(
                  "the simulated motion escapes: coordinate {} is at {:.3g}, its rms so far is {:.3g}; stiffness "
                  "or inertia vanish out there: lower the excitation, or check the signs of the model",
                  k + 1, now[k], rms));
    }
    throw NumericalFailure(Ending::stalled, heading(settings_, stepper_->time()) +
                                                "the integration makes no progress; the equations may be stiff or "
                                                "discontinuous there");
  }

  void settle_friction() {
    for (std::size_t k = 0; dry_ && k < motion_.modes(); ++k)
      if (jumps_[k]) motion_.take_side(x_, stepper_->time(), k);
  }

  // The sample that is due, of the state then.
  void emit(const State& state) {
    const auto part = [&](std::size_t n) {
      return state.begin() + static_cast<std::ptrdiff_t>(n * motion_.modes());
    };
    out_.time = due();
    motion_.accelerations(state, out_.time, acceleration_.data());
    out_.displacement.assign(part(0), part(1));
    out_.velocity.assign(part(1), part(2));
    out_.acceleration = acceleration_;
    for (std::size_t k = 0; k < motion_.modes(); ++k) squares_[k] += out_.displacement[k] * out_.displacement[k];
    out_.excitation = motion_.excitation();
    last_.displacement = out_.displacement;
    last_.velocity = out_.velocity;
    last_.elastic_displacement.resize(motion_.elements());
    for (std::size_t e = 0; e < motion_.elements(); ++e) last_.elastic_displacement[e] = motion_.elastic(state, e);
    last_.relaxing_displacement.assign(state.begin() + static_cast<std::ptrdiff_t>(motion_.relaxing_at()),
                                       state.end());
    if (settings_.armature) {
      last_.base = state[2 * motion_.modes()];
      last_.base_rate = state[2 * motion_.modes() + 1];
    }
    sample_(out_);
    ++next_;
  }

  bool any_held() const {
    for (std::size_t k = 0; k < motion_.modes(); ++k)
      if (motion_.held(k)) return true;
    return false;
  }

  // Goes on from the first event within the last step, if there is one; a mode that is held is looked at anew after
  // every step.
  void pass_event() {
    const Event event = EventSearch(motion_, *stepper_, previous_).first(dry_);
    if (!event.found() && !any_held()) return;
    const double time = event.found() ? event.when : stepper_->time();
    State at(x_.size());
    while (next_ < times_.count && due() <= time) {  // these samples still come from this step
      stepper_->state_at(due(), at);
      emit(at);
    }
    stepper_->state_at(time, x_);
    if (event.stopped != none) x_[motion_.modes() + event.stopped] = 0;
    if (event.element != none) motion_.change_phase(x_, event.element);
    stepper_->start(x_, time);
    settle_friction();
  }

  const SampleTimes times_;
  const MotionSettings& settings_;
  const std::function<void(const MotionSample&)>& sample_;
  Motion motion_;
  OdeRate rate_;
  std::unique_ptr<Stepper> stepper_;
  std::vector<bool> jumps_;  // by mode: whether dry friction acts on it
  bool dry_ = false;
  State x_, previous_;
  std::size_t next_ = 0;  // sample
  std::vector<double> acceleration_;
  std::vector<double> squares_;  // sum over samples of displacements squared, by mode
  MotionSample out_;
  MotionState last_;
};

}  // namespace

void integrate_motion(const MotionEquations& equations, const SampleTimes& times, const MotionSettings& settings,
                      MotionState& state, const std::function<void(const MotionSample&)>& sample) {
  Integration(equations, times, settings, sample).run(state);
}

}  // namespace secular
