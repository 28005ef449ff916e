#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "motion/integrate/motion_integrator.hpp"

namespace secular {

/// One motion, or several side by side, by the number that stands for a coordinate.
template <class Number>
struct Motions;

template <>
struct Motions<double> {
  using Parameter = double;
  using Sample = ExcitationSample;
  static constexpr std::size_t count = 1;
  static double each(const auto& value) { return value(0); }
  static double of(double number, std::size_t /*motion*/) { return number; }
  static void set(double& number, std::size_t /*motion*/, double value) { number = value; }
  static void set_parameter(double& parameter, std::size_t /*motion*/, double value) { parameter = value; }
  static const auto& acceleration(const CompiledModel& model) { return model.acceleration; }
};

template <>
struct Motions<Lanes> {
  using Parameter = LaneParameter;
  using Sample = LaneSample;
  static constexpr std::size_t count = Lanes::count;
  static Lanes each(const auto& value) { return Lanes::each(value); }
  static double of(const Lanes& number, std::size_t motion) { return number[motion]; }
  static void set(Lanes& number, std::size_t motion, double value) { number.set(motion, value); }
  static void set_parameter(LaneParameter& parameter, std::size_t motion, double value) {
    parameter.set(motion, value);
    parameter.is_nonzero = parameter.is_nonzero || value != 0;
  }
  static const auto& acceleration(const CompiledModel& model) { return model.acceleration_of_lanes; }
};

/// A signal and its derivatives `x` steps behind the middle one of five neighbouring values, `per_s` steps a
/// second: those of the polynomial through the five.
template <class Number>
typename Motions<Number>::Sample through_five(const std::array<Number, 5>& value, const Number& x, double per_s) {
  const Number two(2.0), half(0.5), sixth(1.0 / 6), twelfth(1.0 / 12), here = value[2];
  const Number one = value[3] - value[1], wide = value[4] - value[0], bend = value[3] - two * here + value[1],
               wide_bend = value[4] - two * here + value[0];
  // Derivatives where the middle is.
  const Number first = (Number(8.0) * one - wide) * twelfth, second = (Number(16.0) * bend - wide_bend) * twelfth,
               third = half * wide - one, fourth = wide_bend - Number(4.0) * bend;
  return {here + x * (first + x * (half * second + x * (sixth * third + Number(1.0 / 24) * x * fourth))),
          (first + x * (second + x * (half * third + sixth * x * fourth))) * Number(per_s),
          (second + x * (third + half * x * fourth)) * Number(per_s * per_s)};
}

/// Right-hand sides of the full equations of motion, with what drives them and what stands beside them. A state is
/// displacements, velocities, displacement and velocity of the side oscillator, and what relaxes.
template <class Number>
class MotionFlow {
 public:
  using State = std::vector<Number>;

  /// One motion for each start; where fewer are given than go side by side, the first one's parameters and no
  /// forces fill the rest.
  MotionFlow(const CompiledModel& model, const std::vector<StateForce>& forces, std::span<const MotionStart> starts)
      : model_(model),
        modes_(model.modes()),
        size_(2 * modes_),
        parameters_(model.symbols.size()),
        excitation_(model.excitations.size()),
        driven_(std::min(static_cast<std::size_t>(starts.front().signal->half_steps.rows()), excitation_.size())) {
    driven_at_.fill(-1);
    for (std::size_t m = 0; m < Motions<Number>::count; ++m) {
      const MotionStart& start = starts[m < starts.size() ? m : 0];
      signals_[m] = start.signal.get();
      for (std::size_t p = 0; p < parameters_.size(); ++p)
        Motions<Number>::set_parameter(parameters_[p], m, start.parameters[p]);
      take_beside(m, start);
    }
    if (has_side_) size_ += 2;
    for (const StateForce& force : forces) take_force(force, starts);
  }

  std::size_t modes() const { return modes_; }

  State state_of(std::span<const MotionStart> starts) const {
    State state(size_, Number(0.0));
    for (std::size_t m = 0; m < starts.size(); ++m) {
      for (std::size_t i = 0; i < 2 * modes_; ++i)
        Motions<Number>::set(state[i], m, starts[m].state(static_cast<Eigen::Index>(i)));
      for (const ActiveForce& active : active_)
        if (active.relaxes) Motions<Number>::set(state[active.place], m, swung_in(active, m, starts[m]));
    }
    return state;
  }

  /// Sets what drives; time >= 0 in half steps of the samples, that of all motions or of each. Stages of a step are
  /// often where the one before was.
  template <class Time>
  void drive(const Time& at) {
    if (driven_ == 0) return;
    bool is_driven = true;
    for (std::size_t m = 0; m < Motions<Number>::count; ++m) {
      is_driven = is_driven && driven_at_[m] == Motions<Time>::of(at, m);
      driven_at_[m] = Motions<Time>::of(at, m);
    }
    if (is_driven) return;
    std::array<const double*, Motions<Number>::count> middle;  // of the five values nearest to it
    Number behind(0.0);
    for (std::size_t m = 0; m < middle.size(); ++m) {
      const Eigen::MatrixXd& values = signals_[m]->half_steps;
      const auto nearest =
          std::clamp<Eigen::Index>(static_cast<Eigen::Index>(driven_at_[m] + 0.5), 2, values.cols() - 3);
      middle[m] = values.data() + nearest * values.rows();
      Motions<Number>::set(behind, m, driven_at_[m] - static_cast<double>(nearest));
    }
    const std::ptrdiff_t next = signals_[0]->half_steps.rows();
    for (std::size_t j = 0; j < driven_; ++j) {
      const auto value = [&](std::ptrdiff_t i) {
        return Motions<Number>::each(
            [&](std::size_t m) { return middle[m][i * next + static_cast<std::ptrdiff_t>(j)]; });
      };
      excitation_[j] = through_five<Number>({value(-2), value(-1), value(0), value(1), value(2)}, behind,
                                            2 / signals_[0]->sample_s);
    }
  }

  /// Accelerations with these velocities in place of the state's. Sliders as they are at `origin`, moved on to
  /// here; each holds or slides as it did last (load).
  void accelerate(const State& state, const Number* velocity, const State& origin, Number* acceleration) {
    for (const ActiveForce& active : active_)
      excitation_[active.force->excitation] = {signal_of(active, state, velocity, origin), Number(0.0),
                                               Number(0.0)};
    Motions<Number>::acceleration(model_)(parameters_.data(), excitation_.data(), state.data(), velocity,
                                          acceleration);
  }

  /// The rest of the derivative of the state, its accelerations being those of accelerate().
  void complete(const State& state, State& rate) const {
    for (std::size_t k = 0; k < modes_; ++k) rate[k] = state[modes_ + k];
    for (std::size_t k = 0; k < stiffness_.size(); ++k)
      rate[modes_ + k] = rate[modes_ + k] - (stiffness_[k] * state[k] + damping_[k] * state[modes_ + k]);
    for (const ActiveForce& active : active_)
      if (active.relaxes) rate[active.place] = rate[active.force->mode] - state[active.place] / active.time;
    if (!has_side_) return;
    const Number &x = state[2 * modes_], &v = state[2 * modes_ + 1];
    const Number force = excitation_.empty() ? Number(0.0) : Number(excitation_[0].value);
    rate[2 * modes_] = v;
    rate[2 * modes_ + 1] =
        force - Number(2.0) * side_damping_ * side_frequency_ * v - side_frequency_ * side_frequency_ * x;
  }

  /// Whether sliders follow a coordinate of a motion.
  bool slides(std::size_t mode, std::size_t motion) const {
    return std::any_of(active_.begin(), active_.end(), [&](const ActiveForce& active) {
      return active.force->mode == mode && !active.sliders[motion].empty();
    });
  }

  /// A coordinate goes on to one side (1, -1; 0: it rests): sliders that are stretched to that side slide from now
  /// on, the others hold. Whether it counts where the coordinate turns.
  bool load(std::size_t mode, std::size_t motion, int side) {
    bool counts = false;
    for (ActiveForce& active : active_) {
      if (active.force->mode != mode) continue;
      for (LoadedSlider& s : active.sliders[motion]) {
        s.sliding = side != 0 && !s.slider.smooth && side * s.stretch >= s.slider.slip ? side : 0;
        counts = counts || s.slider.smooth || s.sliding != 0;
      }
    }
    return counts;
  }

  /// A slider of one motion and the side to which it gives way; no force: none.
  struct Yield {
    std::size_t force = static_cast<std::size_t>(-1), slider = 0;
    int side = 0;

    bool operator==(const Yield&) const = default;
  };

  /// One of those that held at `from` and would be stretched beyond their slip at `to`.
  Yield yielding(std::size_t motion, const State& from, const State& to) const {
    for (std::size_t f = 0; f < active_.size(); ++f) {
      const double way = way_of(*active_[f].force, motion, from, to);
      const int side = way > 0 ? 1 : -1;
      const std::vector<LoadedSlider>& sliders = active_[f].sliders[motion];
      for (std::size_t s = 0; s < sliders.size(); ++s)
        if (!sliders[s].slider.smooth && sliders[s].sliding == 0 && sliders[s].left(side, 0) > 0 &&
            sliders[s].left(side, way) < 0)
          return {f, s, side};
    }
    return {};
  }

  /// How far it is from giving way at `to`.
  double left_of(const Yield& yield, std::size_t motion, const State& from, const State& to) const {
    const ActiveForce& active = active_[yield.force];
    return active.sliders[motion][yield.slider].left(yield.side, way_of(*active.force, motion, from, to));
  }

  /// Sliders go from one state to another, in motions of which there is something `left` to go. `yields`: what
  /// gives way there, by motion.
  void slide(const State& from, const State& to, const Number& left,
             const std::array<Yield, Motions<Number>::count>& yields) {
    for (std::size_t m = 0; m < Motions<Number>::count; ++m) {
      if (!(Motions<Number>::of(left, m) > 0)) continue;
      for (std::size_t f = 0; f < active_.size(); ++f)
        for (std::size_t s = 0; s < active_[f].sliders[m].size(); ++s) {
          LoadedSlider& loaded = active_[f].sliders[m][s];
          const double slip = loaded.slider.slip;
          const bool gives_way = yields[m].force == f && yields[m].slider == s;
          loaded.stretch = gives_way ? yields[m].side * slip
                                     : std::clamp(loaded.at(way_of(*active_[f].force, m, from, to)), -slip, slip);
        }
    }
  }

  double parameter(std::size_t symbol, std::size_t motion) const {
    return Motions<Number>::of(parameters_[symbol], motion);
  }

 private:
  struct LoadedSlider {
    Slider slider;
    double stretch = 0;
    int sliding = 0;  // to which side; 0: it holds, or it is smooth

    double at(double way) const {
      if (slider.smooth) return slider.advanced(stretch, way);
      return sliding == 0 ? stretch + way : sliding * slider.slip;
    }
    double left(int side, double way) const { return slider.slip - side * (stretch + way); }
  };
  // A force that is not switched off in every motion.
  struct ActiveForce {
    const StateForce* force = nullptr;
    std::array<bool, Motions<Number>::count> acts{};
    std::array<double, Motions<Number>::count> shape{},
        level{};  // level: squared amplitude of the first excitation
    std::array<std::vector<LoadedSlider>, Motions<Number>::count> sliders;
    bool relaxes = false;
    std::size_t place = 0;  // in the state, of what relaxes
    Number time = Number(1.0);
  };

  void take_beside(std::size_t motion, const MotionStart& start) {
    stiffness_.resize(std::max(stiffness_.size(), start.change.size()), Number(0.0));
    damping_.resize(stiffness_.size(), Number(0.0));
    for (std::size_t k = 0; k < start.change.size(); ++k) {
      Motions<Number>::set(stiffness_[k], motion, start.change[k].stiffness);
      Motions<Number>::set(damping_[k], motion, start.change[k].damping);
    }
    if (!start.side) return;
    has_side_ = true;
    Motions<Number>::set(side_frequency_, motion, start.side->frequency);
    Motions<Number>::set(side_damping_, motion, start.side->damping);
  }

  void take_force(const StateForce& force, std::span<const MotionStart> starts) {
    ActiveForce active;
    active.force = &force;
    bool acts = false;
    for (std::size_t m = 0; m < starts.size(); ++m) {
      const std::vector<double>& parameters = starts[m].parameters;
      if (parameters[force.strength_symbol] == 0) continue;
      acts = active.acts[m] = true;
      active.shape[m] = force.shape(parameters);
      if (force.law.kind == ForceLaw::Kind::level && driven_ > 0)
        active.level[m] = squared_amplitude(signals_[m]->half_steps.row(0));
      for (const Slider& slider : sliders_of(force, active.shape[m])) active.sliders[m].push_back({slider});
      Motions<Number>::set(active.time, m, active.shape[m]);
    }
    if (!acts) return;
    active.relaxes = force.law.kind == ForceLaw::Kind::relaxation;
    if (active.relaxes) active.place = size_++;
    active_.push_back(std::move(active));
  }

  // What relaxes, in the middle of a free vibration at the natural frequency: z = i w tau/(1 + i w tau) x.
  double swung_in(const ActiveForce& active, std::size_t motion, const MotionStart& start) const {
    const auto k = static_cast<Eigen::Index>(active.force->mode), modes = static_cast<Eigen::Index>(modes_);
    const double tau = active.shape[motion], turns = start.parameters[active.force->mode] * tau;
    return (turns * turns * start.state(k) + tau * start.state(modes + k)) / (1 + turns * turns);
  }

  static double way_of(const StateForce& force, std::size_t motion, const State& from, const State& to) {
    return Motions<Number>::of(to[force.mode], motion) - Motions<Number>::of(from[force.mode], motion);
  }

  Number signal_of(const ActiveForce& active, const State& state, const Number* velocity,
                   const State& origin) const {
    const StateForce& force = *active.force;
    Number signal(0.0);
    for (std::size_t m = 0; m < Motions<Number>::count; ++m) {
      if (!active.acts[m]) continue;
      const double here = Motions<Number>::of(state[force.mode], m);
      double value = 0;
      if (force.law.kind == ForceLaw::Kind::state)
        value = force.law.value(here, Motions<Number>::of(velocity[force.mode], m), active.shape[m], force.scale);
      else if (force.law.kind == ForceLaw::Kind::level)
        value = active.level[m];
      else if (active.relaxes)
        value = Motions<Number>::of(state[active.place], m);
      const double way = way_of(force, m, origin, state);
      double stretches = 0;
      for (const LoadedSlider& slider : active.sliders[m]) stretches += slider.at(way);
      if (!active.sliders[m].empty())
        value = force.per_stretch(active.shape[m]) * stretches / static_cast<double>(active.sliders[m].size());
      Motions<Number>::set(signal, m, value);
    }
    return signal;
  }

  const CompiledModel& model_;
  std::array<const DrivingSignal*, Motions<Number>::count> signals_{};
  std::size_t modes_, size_;  // of the state
  std::vector<typename Motions<Number>::Parameter> parameters_;
  std::vector<typename Motions<Number>::Sample> excitation_;  // zero where neither the signal nor a force drives
  std::size_t driven_;
  std::array<double, Motions<Number>::count> driven_at_{};  // times; before 0: not yet
  std::vector<Number> stiffness_, damping_;                 // of LinearChange
  bool has_side_ = false;
  Number side_frequency_ = Number(1.0), side_damping_ = Number(0.0);
  std::vector<ActiveForce> active_;
};

}  // namespace secular
