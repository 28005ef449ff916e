#include "diagnose/evidence/jumping_motion.hpp"

#include <algorithm>
#include <cmath>

namespace secular {
namespace {

/// A velocity beside zero, and what is nothing beside numbers of order one.
constexpr double vanishing = 1e-300, rounding = 1e-12;

/// A step's end at a zero of a smooth function is found to rounding in three or four.
constexpr int most_secants = 20;

}  // namespace

JumpingMotion::JumpingMotion(MotionFlow<double>& flow, const State& start)
    : flow_(flow),
      modes_(flow.modes()),
      jumps_(modes_),
      velocity_(modes_),
      above_(modes_),
      below_(modes_),
      step_(start.size()) {
  find_jumps(0, start);
}

bool JumpingMotion::has_jumps() const {
  return std::any_of(jumps_.begin(), jumps_.end(), [](const Jump& jump) { return jump.there; });
}

// Accelerations of a coordinate that stands still, for a vanishing velocity from above and from below.
std::pair<double, double> JumpingMotion::beside_rest(std::size_t k, const State& state, State velocity,
                                                     const State& origin) {
  velocity[k] = vanishing;
  flow_.accelerate(state, velocity, origin, above_.data());
  velocity[k] = -vanishing;
  flow_.accelerate(state, velocity, origin, below_.data());
  return {above_[k], below_[k]};
}

void JumpingMotion::find_jumps(double at, State state) {
  flow_.drive(at);
  for (std::size_t k = 0; k < modes_; ++k)
    state[k] = std::abs(state[k]) + std::abs(state[modes_ + k] / flow_.parameter(k));
  const State velocity(state.begin() + static_cast<std::ptrdiff_t>(modes_),
                       state.begin() + static_cast<std::ptrdiff_t>(2 * modes_));
  for (std::size_t k = 0; k < modes_; ++k) {
    const auto [above, below] = beside_rest(k, state, velocity, state);
    jumps_[k].there = std::abs(above - below) > rounding * (std::abs(above) + std::abs(below));
  }
}

void JumpingMotion::take_sides(double at, const State& state) {
  for (std::size_t k = 0; k < modes_; ++k) {
    Jump& jump = jumps_[k];
    if (!jump.there) continue;
    const double v = state[modes_ + k];
    jump.held = false;
    jump.side = v > 0 ? 1 : v < 0 ? -1 : 0;
    if (v != 0) continue;
    flow_.drive(at);
    std::copy_n(state.begin() + static_cast<std::ptrdiff_t>(modes_), modes_, velocity_.begin());
    const auto [above, below] = beside_rest(k, state, velocity_, state);
    jump.held = above <= 0 && below >= 0;
    jump.side = jump.held ? 0 : above > 0 ? 1 : -1;
  }
}

void JumpingMotion::derive(double at, const State& state) {
  take_sides(at, state);
  derivative(at, state, state, step_.rate());
}

// On one side of every jump.
void JumpingMotion::derivative(double at, const State& state, const State& origin, State& rate) {
  flow_.drive(at);
  std::copy_n(state.begin() + static_cast<std::ptrdiff_t>(modes_), modes_, velocity_.begin());
  held_.clear();
  for (std::size_t k = 0; k < modes_; ++k) {
    const Jump& jump = jumps_[k];
    if (jump.side * velocity_[k] < 0 || (jump.side != 0 && velocity_[k] == 0)) velocity_[k] = jump.side * vanishing;
    if (!jump.held) continue;
    const auto [above, below] = beside_rest(k, state, velocity_, origin);
    if (above > 0 || below < 0)
      velocity_[k] = above > 0 ? std::max(velocity_[k], vanishing) : std::min(velocity_[k], -vanishing);
    else
      held_.push_back(k);
  }
  flow_.accelerate(state, velocity_, origin, rate.data() + modes_);
  flow_.complete(state, rate);
  for (const std::size_t k : held_) rate[modes_ + k] = 0;
}

// From `state` to step_.end(); the derivative there is known.
void JumpingMotion::runge_kutta(double at, double half_steps, double step, const State& state) {
  step_.take(at, half_steps, step, state, [&](double time, const State& stage, const State& origin, State& rate) {
    derivative(time, stage, origin, rate);
  });
}

// A coordinate whose velocity has left its side of a jump by the end of a step; none: as many as there are.
std::size_t JumpingMotion::crossing() const {
  std::size_t k = 0;
  while (k < modes_ && !(jumps_[k].side * step_.end()[modes_ + k] < 0)) ++k;
  return k;
}

// Share of a step, taken to its end already, after which this velocity is zero: regula falsi (Illinois), whose
// last step is left in step_.end().
double JumpingMotion::share_to_rest(std::size_t k, double at, double half_steps, double step, const State& state) {
  double& reached = step_.end()[modes_ + k];
  const double start = state[modes_ + k];
  double low = 0, v_low = start, high = 1, v_high = reached, share = 1;
  const double small = rounding * (std::abs(v_low) + std::abs(v_high));
  int side = 0;
  for (int i = 0; i < most_secants; ++i) {
    share = (low * v_high - high * v_low) / (v_high - v_low);
    runge_kutta(at, share * half_steps, share * step, state);
    const double v = reached;
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
  reached = 0;
  return share;
}

bool JumpingMotion::advance(double at, double half_steps, double step, State& state, bool begun) {
  bool jumped = false;
  for (double left = 1; left > 0;) {
    const double from = at + (1 - left) * half_steps;
    if (!begun) derive(from, state);
    begun = false;
    runge_kutta(from, left * half_steps, left * step, state);
    double share = 1;
    for (std::size_t k = crossing(); k < modes_ && share > 0; k = crossing()) {
      jumped = true;
      // From rest and back within a step: it has not moved.
      if (state[modes_ + k] == 0) {
        step_.end()[modes_ + k] = 0;
        continue;
      }
      share *= share_to_rest(k, from, share * left * half_steps, share * left * step, state);
    }
    flow_.slide(state, step_.end());
    state.swap(step_.end());
    left = share < 1 ? left * (1 - share) : 0;
  }
  return jumped;
}

}  // namespace secular
