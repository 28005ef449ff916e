#include "diagnose/evidence/segment_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Parabola through three neighbouring half steps: value and first two derivatives at `at` (in half steps).
ExcitationSample interpolated(const Eigen::MatrixXd& half_steps, Index row, double at, double half_step_s) {
  const Index last = half_steps.cols() - 1;
  const auto middle = std::clamp<Index>(static_cast<Index>(std::lround(at)), 1, std::max<Index>(1, last - 1));
  if (last < 2) return {half_steps(row, 0), 0, 0};
  const double before = half_steps(row, middle - 1), here = half_steps(row, middle),
               after = half_steps(row, middle + 1);
  const double x = at - static_cast<double>(middle);
  const double slope = 0.5 * (after - before), bend = after - 2 * here + before;
  return {here + slope * x + 0.5 * bend * x * x, (slope + bend * x) / half_step_s,
          bend / (half_step_s * half_step_s)};
}

/// A velocity beside zero, and what is nothing beside numbers of order one.
constexpr double vanishing = 1e-300, rounding = 1e-12;

/// A step's end at a zero of a smooth function is found to rounding in three or four.
constexpr int most_secants = 20;

// A force that is not switched off, with the state of its sliders.
struct ActiveForce {
  const StateForce* force;
  double shape;
  std::vector<Slider> sliders;
  std::vector<double> stretch;
  Index relaxing = -1;  // place in the state of what relaxes
};

class Stretch {
 public:
  Stretch(const CompiledModel& model, const std::vector<StateForce>& forces, std::span<const double> parameters,
          const DrivingSignal& signal, const std::vector<LinearChange>& change, const SideOscillator* side)
      : model_(model),
        parameters_(parameters),
        signal_(signal),
        change_(change),
        side_(side),
        modes_(static_cast<Index>(model.modes())),
        excitation_(model.excitations.size()),
        jumps_(model.modes()),
        size_(2 * modes_ + (side ? 2 : 0)),
        driven_(std::min(signal.half_steps.rows(), static_cast<Index>(excitation_.size()))) {
    for (const StateForce& force : forces) {
      if (parameters[force.strength_symbol] == 0) continue;
      const double shape = force.shape(parameters);
      std::vector<Slider> sliders = sliders_of(force, shape);
      std::vector<double> stretch(sliders.size(), 0.0);
      const bool relaxes = force.law.kind == ForceLaw::Kind::relaxation;
      active_.push_back({&force, shape, std::move(sliders), std::move(stretch), relaxes ? size_++ : -1});
    }
    if (signal.half_steps.rows() > 0) level_ = squared_amplitude(signal.half_steps.row(0));
  }

  StretchOfMotion run(const VectorXd& start, Index samples, int substeps) {
    VectorXd state = VectorXd::Zero(size_);
    state.head(2 * modes_) = start;
    for (const ActiveForce& active : active_)
      if (active.relaxing >= 0) state(active.relaxing) = swung_in(active, start);
    StretchOfMotion motion;
    motion.displacement = Eigen::MatrixXd::Zero(modes_, samples);
    motion.velocity = motion.displacement;
    motion.acceleration = motion.displacement;
    if (side_) motion.side = Eigen::RowVectorXd::Zero(samples);
    const double bound = 1e6 * (start.cwiseAbs().maxCoeff() + 1e-3);
    const double step = signal_.sample_s / substeps, half_steps = 2.0 / substeps;
    for (VectorXd* v : {&k1_, &k2_, &k3_, &k4_, &stage_, &moved_}) v->resize(size_);
    find_jumps(state);
    for (Index i = 0; i < samples; ++i) {
      const auto begin = static_cast<double>(2 * i);
      take_sides(begin, state);
      derivative(begin, state, state, k1_);
      motion.displacement.col(i) = state.head(modes_);
      motion.velocity.col(i) = state.segment(modes_, modes_);
      motion.acceleration.col(i) = k1_.segment(modes_, modes_);
      if (side_) motion.side(i) = k1_(2 * modes_ + 1);
      if (i + 1 == samples) break;
      bool jumped = false;
      for (int s = 0; s < substeps; ++s)
        jumped = advance(begin + half_steps * s, half_steps, step, state, s == 0) || jumped;
      if (jumped) motion.jumps.push_back(i);
      if (!(state.head(2 * modes_).cwiseAbs().maxCoeff() < bound)) break;
    }
    return motion;
  }

 private:
  // On which side of a jump at zero velocity a coordinate moves; 0: there is none, or it is held by it.
  struct Jump {
    bool there = false, held = false;
    int side = 0;
  };

  // What relaxes, in the middle of a free vibration at the natural frequency: z = i w tau/(1 + i w tau) x.
  double swung_in(const ActiveForce& active, const VectorXd& start) const {
    const auto mode = static_cast<Index>(active.force->mode);
    const double tau = active.shape, turns = parameters_[active.force->mode] * tau;
    return (turns * turns * start(mode) + tau * start(modes_ + mode)) / (1 + turns * turns);
  }

  // Values of the driving signal; time in half steps of the samples.
  void drive(double at) {
    for (Index j = 0; j < driven_; ++j)
      excitation_[static_cast<std::size_t>(j)] = interpolated(signal_.half_steps, j, at, 0.5 * signal_.sample_s);
  }

  // Accelerations with these velocities in place of the state's. Sliders as they are at `origin`, moved on to here.
  void accelerate(const VectorXd& state, const VectorXd& velocity, const VectorXd& origin, double* acceleration) {
    for (const ActiveForce& active : active_) {
      const StateForce& force = *active.force;
      const auto mode = static_cast<Index>(force.mode);
      double value = 0;
      if (force.law.kind == ForceLaw::Kind::state)
        value = force.law.value(state(mode), velocity(mode), active.shape, force.scale);
      else if (force.law.kind == ForceLaw::Kind::level)
        value = level_;
      else if (active.relaxing >= 0)
        value = state(active.relaxing);
      for (std::size_t i = 0; i < active.sliders.size(); ++i)
        value += active.sliders[i].advanced(active.stretch[i], state(mode) - origin(mode)) /
                 static_cast<double>(active.sliders.size());
      excitation_[force.excitation] = {value, 0, 0};
    }
    model_.acceleration(parameters_.data(), excitation_.data(), state.data(), velocity.data(), acceleration);
  }

  // Accelerations of a coordinate that stands still, for a vanishing velocity from above and from below.
  std::pair<double, double> beside_rest(Index k, const VectorXd& state, VectorXd velocity, const VectorXd& origin) {
    VectorXd above(modes_), below(modes_);
    velocity(k) = vanishing;
    accelerate(state, velocity, origin, above.data());
    velocity(k) = -vanishing;
    accelerate(state, velocity, origin, below.data());
    return {above(k), below(k)};
  }

  // Whether there are jumps at all, at displacements as large as those of the motion.
  void find_jumps(VectorXd state) {
    drive(0);
    for (Index k = 0; k < modes_; ++k)
      state(k) = std::abs(state(k)) + std::abs(state(modes_ + k) / parameters_[static_cast<std::size_t>(k)]);
    for (Index k = 0; k < modes_; ++k) {
      const auto [above, below] = beside_rest(k, state, state.segment(modes_, modes_), state);
      jumps_[static_cast<std::size_t>(k)].there =
          std::abs(above - below) > rounding * (std::abs(above) + std::abs(below));
    }
  }

  void take_sides(double at, const VectorXd& state) {
    for (Index k = 0; k < modes_; ++k) {
      Jump& jump = jumps_[static_cast<std::size_t>(k)];
      if (!jump.there) continue;
      const double v = state(modes_ + k);
      jump.held = false;
      jump.side = v > 0 ? 1 : v < 0 ? -1 : 0;
      if (v != 0) continue;
      drive(at);
      const auto [above, below] = beside_rest(k, state, state.segment(modes_, modes_), state);
      jump.held = above <= 0 && below >= 0;
      jump.side = jump.held ? 0 : above > 0 ? 1 : -1;
    }
  }

  // Derivative of (displacements, velocities, side displacement, side velocity), on one side of every jump.
  void derivative(double at, const VectorXd& state, const VectorXd& origin, VectorXd& rate) {
    drive(at);
    velocity_ = state.segment(modes_, modes_);
    held_.clear();
    for (Index k = 0; k < modes_; ++k) {
      const Jump& jump = jumps_[static_cast<std::size_t>(k)];
      if (jump.side * velocity_(k) < 0 || (jump.side != 0 && velocity_(k) == 0))
        velocity_(k) = jump.side * vanishing;
      if (!jump.held) continue;
      const auto [above, below] = beside_rest(k, state, velocity_, origin);
      if (above > 0 || below < 0)
        velocity_(k) = above > 0 ? std::max(velocity_(k), vanishing) : std::min(velocity_(k), -vanishing);
      else
        held_.push_back(k);
    }
    accelerate(state, velocity_, origin, rate.data() + modes_);
    rate.head(modes_) = state.segment(modes_, modes_);
    for (std::size_t k = 0; k < change_.size(); ++k) {
      const auto i = static_cast<Index>(k);
      rate(modes_ + i) -= change_[k].stiffness * state(i) + change_[k].damping * state(modes_ + i);
    }
    for (const Index k : held_) rate(modes_ + k) = 0;
    for (const ActiveForce& active : active_)
      if (active.relaxing >= 0)
        rate(active.relaxing) =
            rate(static_cast<Index>(active.force->mode)) - state(active.relaxing) / active.shape;
    if (side_) {
      const double x = state(2 * modes_), v = state(2 * modes_ + 1);
      const double force = excitation_.empty() ? 0 : excitation_[0].value;
      rate(2 * modes_) = v;
      rate(2 * modes_ + 1) =
          force - 2 * side_->damping * side_->frequency * v - side_->frequency * side_->frequency * x;
    }
  }

  // From `state` to moved_; k1_ is known.
  void runge_kutta(double at, double half_steps, double step, const VectorXd& state) {
    stage_ = state + 0.5 * step * k1_;
    derivative(at + 0.5 * half_steps, stage_, state, k2_);
    stage_ = state + 0.5 * step * k2_;
    derivative(at + 0.5 * half_steps, stage_, state, k3_);
    stage_ = state + step * k3_;
    derivative(at + half_steps, stage_, state, k4_);
    moved_ = state + step / 6 * (k1_ + 2 * k2_ + 2 * k3_ + k4_);
  }

  // A coordinate whose velocity has left its side of a jump by the end of a step; none: -1.
  Index crossing() const {
    for (Index k = 0; k < modes_; ++k)
      if (jumps_[static_cast<std::size_t>(k)].side * moved_(modes_ + k) < 0) return k;
    return -1;
  }

  // Share of a step, taken to its end already, after which this velocity is zero: regula falsi (Illinois), whose
  // last step is left in moved_.
  double share_to_rest(Index k, double at, double half_steps, double step, const VectorXd& state) {
    const double start = state(modes_ + k);
    double low = 0, v_low = start, high = 1, v_high = moved_(modes_ + k), share = 1;
    const double small = rounding * (std::abs(v_low) + std::abs(v_high));
    int side = 0;
    for (int i = 0; i < most_secants; ++i) {
      share = (low * v_high - high * v_low) / (v_high - v_low);
      runge_kutta(at, share * half_steps, share * step, state);
      const double v = moved_(modes_ + k);
      if (std::abs(v) <= small) break;
      const bool before = v * start > 0;
      if (before) {
        low = share;
        v_low = v;
        if (side == -1) v_high /= 2;
      } else {
        high = share;
        v_high = v;
        if (side == 1) v_low /= 2;
      }
      side = before ? -1 : 1;
    }
    moved_(modes_ + k) = 0;
    return share;
  }

  // One step, in as many parts as velocities come to zero within it; whether one did. `begun`: k1_ is known.
  bool advance(double at, double half_steps, double step, VectorXd& state, bool begun) {
    bool jumped = false;
    for (double left = 1; left > 0;) {
      const double from = at + (1 - left) * half_steps;
      if (!begun) {
        take_sides(from, state);
        derivative(from, state, state, k1_);
      }
      begun = false;
      runge_kutta(from, left * half_steps, left * step, state);
      double share = 1;
      for (Index k = crossing(); k >= 0 && share > 0; k = crossing()) {
        jumped = true;
        // From rest and back within a step: it has not moved.
        if (state(modes_ + k) == 0) {
          moved_(modes_ + k) = 0;
          continue;
        }
        share *= share_to_rest(k, from, share * left * half_steps, share * left * step, state);
      }
      for (ActiveForce& active : active_) {
        const auto mode = static_cast<Index>(active.force->mode);
        for (std::size_t e = 0; e < active.sliders.size(); ++e)
          active.stretch[e] = active.sliders[e].advanced(active.stretch[e], moved_(mode) - state(mode));
      }
      state.swap(moved_);
      left = share < 1 ? left * (1 - share) : 0;
    }
    return jumped;
  }

  const CompiledModel& model_;
  std::span<const double> parameters_;
  const DrivingSignal& signal_;
  const std::vector<LinearChange>& change_;
  const SideOscillator* side_;
  Index modes_;
  std::vector<ExcitationSample> excitation_;  // zero where neither the signal nor a force drives
  std::vector<Jump> jumps_;                   // by coordinate
  Index size_;        // of the state: displacements, velocities, the side oscillator, what relaxes
  double level_ = 0;  // squared amplitude of the first excitation
  Index driven_;
  std::vector<ActiveForce> active_;
  std::vector<Index> held_;
  VectorXd velocity_, k1_, k2_, k3_, k4_, stage_, moved_;
};

}  // namespace

StretchOfMotion integrate_stretch(const CompiledModel& model, const std::vector<StateForce>& forces,
                                  std::span<const double> parameters, const DrivingSignal& signal,
                                  const VectorXd& state, Index samples, int substeps,
                                  const std::vector<LinearChange>& change, const SideOscillator* side) {
  return Stretch(model, forces, parameters, signal, change, side).run(state, samples, substeps);
}

}  // namespace secular
