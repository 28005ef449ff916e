#include "motion/integrate/jumping_motion.hpp"

#include <algorithm>
#include <cmath>

namespace secular {
namespace {

/// A velocity beside zero, and what is nothing beside numbers of order one.
constexpr double vanishing = 1e-300, rounding = 1e-12;

/// A step's end at a zero of a smooth function is found to rounding in three or four.
constexpr int most_secants = 20;

/// A step that would have more parts goes on as if sliders neither held nor gave way within it: what swings so
/// often within one step, on the springs of sliders that are stuck, is far faster than any data.
constexpr int most_parts = 64;

}  // namespace

template <class Number>
JumpingMotion<Number>::JumpingMotion(MotionFlow<Number>& flow, const State& start, std::size_t motions)
    : flow_(flow),
      modes_(flow.modes()),
      jumps_(modes_),
      held_(modes_),
      velocity_(modes_, Number(0.0)),
      above_(modes_, Number(0.0)),
      below_(modes_, Number(0.0)),
      step_(start.size()) {
  find_jumps(start, motions);
}

template <class Number>
bool JumpingMotion<Number>::has_corners() const {
  return std::any_of(jumps_.begin(), jumps_.end(), [](const Jump& jump) { return jump.anywhere || jump.sliders; });
}

// Accelerations of a coordinate that stands still, for a vanishing velocity from above and from below.
template <class Number>
void JumpingMotion<Number>::beside_rest(std::size_t k, const State& state, State velocity, const State& origin) {
  velocity[k] = Number(vanishing);
  flow_.accelerate(state, velocity.data(), origin, above_.data());
  velocity[k] = Number(-vanishing);
  flow_.accelerate(state, velocity.data(), origin, below_.data());
}

template <class Number>
void JumpingMotion<Number>::find_jumps(State state, std::size_t motions) {
  flow_.drive(0.0);
  for (std::size_t k = 0; k < modes_; ++k)
    for (std::size_t m = 0; m < count; ++m)
      set(state[k], m, std::abs(of(state[k], m)) + std::abs(of(state[modes_ + k], m) / flow_.parameter(k, m)));
  const State velocity(state.begin() + static_cast<std::ptrdiff_t>(modes_),
                       state.begin() + static_cast<std::ptrdiff_t>(2 * modes_));
  for (std::size_t k = 0; k < modes_; ++k) {
    beside_rest(k, state, velocity, state);
    for (std::size_t m = 0; m < motions; ++m) {
      const double above = of(above_[k], m), below = of(below_[k], m);
      jumps_[k].there[m] = std::abs(above - below) > rounding * (std::abs(above) + std::abs(below));
      jumps_[k].anywhere = jumps_[k].anywhere || jumps_[k].there[m];
      jumps_[k].slides[m] = flow_.slides(k, m);
      jumps_[k].sliders = jumps_[k].sliders || jumps_[k].slides[m];
    }
  }
}

template <class Number>
void JumpingMotion<Number>::take_sides(const Number& at, const State& state) {
  for (std::size_t k = 0; k < modes_; ++k) {
    Jump& jump = jumps_[k];
    if (!jump.anywhere && !jump.sliders) continue;
    jump.held = {};
    jump.holds = false;
    bool rests = false;
    for (std::size_t m = 0; m < count; ++m) {
      const double v = of(state[modes_ + k], m);
      if (jump.there[m] || jump.slides[m]) jump.side[m] = v > 0 ? 1 : v < 0 ? -1 : 0;
      rests = rests || (jump.there[m] && v == 0);
    }
    if (!rests) continue;
    flow_.drive(at);
    std::copy_n(state.begin() + static_cast<std::ptrdiff_t>(modes_), modes_, velocity_.begin());
    take_rests(k, state);
  }
  load_sliders(at, state);
}

// Of a coordinate that stands where accelerations jump.
template <class Number>
void JumpingMotion<Number>::take_rests(std::size_t k, const State& state) {
  Jump& jump = jumps_[k];
  beside_rest(k, state, velocity_, state);
  for (std::size_t m = 0; m < count; ++m) {
    if (!jump.there[m] || of(state[modes_ + k], m) != 0) continue;
    const double above = of(above_[k], m);
    jump.held[m] = above <= 0 && of(below_[k], m) >= 0;
    jump.side[m] = jump.held[m] ? 0 : above > 0 ? 1 : -1;
    jump.holds = jump.holds || jump.held[m];
  }
}

// Where a coordinate turns, its acceleration says to which side; sliders hold there whichever it is.
template <class Number>
void JumpingMotion<Number>::load_sliders(const Number& at, const State& state) {
  bool known = false;
  for (std::size_t k = 0; k < modes_; ++k) {
    Jump& jump = jumps_[k];
    for (std::size_t m = 0; m < count && jump.sliders; ++m) {
      if (!jump.slides[m]) continue;
      if (!jump.there[m] && jump.side[m] == 0) {
        if (!known) {
          flow_.drive(at);
          flow_.accelerate(state, state.data() + modes_, state, above_.data());
        }
        known = true;
        const double a = of(above_[k], m);
        jump.side[m] = a > 0 ? 1 : a < 0 ? -1 : 0;
      }
      jump.turns[m] = flow_.load(k, m, jump.side[m]) && parts_[m] < most_parts;
    }
  }
}

template <class Number>
void JumpingMotion<Number>::derive(const Number& at, const State& state) {
  take_sides(at, state);
  derivative(at, state, state, step_.rate());
}

template <class Number>
void JumpingMotion<Number>::stay_on_sides(std::size_t k) {
  for (std::size_t m = 0; m < count; ++m) {
    const int side = jumps_[k].there[m] ? jumps_[k].side[m] : 0;
    if (side != 0 && side * of(velocity_[k], m) <= 0) set(velocity_[k], m, side * vanishing);
  }
}

// What is pushed off goes; what is pushed back either way stays.
template <class Number>
void JumpingMotion<Number>::hold(std::size_t k, const State& state, const State& origin) {
  beside_rest(k, state, velocity_, origin);
  for (std::size_t m = 0; m < count; ++m) {
    if (!jumps_[k].held[m]) continue;
    const double above = of(above_[k], m), v = of(velocity_[k], m);
    held_[k][m] = !(above > 0 || of(below_[k], m) < 0);
    if (!held_[k][m]) set(velocity_[k], m, above > 0 ? std::max(v, vanishing) : std::min(v, -vanishing));
  }
}

// On one side of every jump.
template <class Number>
void JumpingMotion<Number>::derivative(const Number& at, const State& state, const State& origin, State& rate) {
  flow_.drive(at);
  std::copy_n(state.begin() + static_cast<std::ptrdiff_t>(modes_), modes_, velocity_.begin());
  for (std::size_t k = 0; k < modes_; ++k) {
    if (jumps_[k].anywhere) stay_on_sides(k);
    if (!jumps_[k].holds) continue;
    held_[k] = {};
    hold(k, state, origin);
  }
  flow_.accelerate(state, velocity_.data(), origin, rate.data() + modes_);
  flow_.complete(state, rate);
  for (std::size_t k = 0; k < modes_; ++k)
    for (std::size_t m = 0; m < count && jumps_[k].holds; ++m)
      if (held_[k][m]) set(rate[modes_ + k], m, 0);
}

// From `state` to step_.end(); the derivative there is known.
template <class Number>
void JumpingMotion<Number>::runge_kutta(const Way& way, const State& state) {
  step_.take(way.from, way.half_steps, way.step, state,
             [&](const Number& time, const State& stage, const State& origin, State& rate) {
               derivative(time, stage, origin, rate);
             });
}

// A coordinate whose velocity has left its side by the end of a step; none: as many as there are. One that only
// sliders follow is not looked at again in a step that it begins at rest.
template <class Number>
std::size_t JumpingMotion<Number>::crossing(std::size_t motion, const State& state) const {
  const auto leaves = [&](std::size_t k) {
    return jumps_[k].side[motion] * of(step_.end()[modes_ + k], motion) < 0 &&
           (jumps_[k].there[motion] || (jumps_[k].turns[motion] && of(state[modes_ + k], motion) != 0));
  };
  std::size_t k = 0;
  while (k < modes_ && !leaves(k)) ++k;
  return k;
}

// Regula falsi (Illinois).
template <class Number>
void JumpingMotion<Number>::Secant::take(double v) {
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

// Zero where the search ends.
template <class Number>
double JumpingMotion<Number>::value_of(const Secant& secant, std::size_t motion, const State& state) const {
  return secant.coordinate < modes_ ? of(step_.end()[modes_ + secant.coordinate], motion)
                                    : flow_.left_of(secant.yield, motion, state, step_.end());
}

// To the end of every search; what is not searched stays as it is in step_.end().
template <class Number>
void JumpingMotion<Number>::run(OfMotions<Secant>& secants, const Way& way, const State& state) {
  State found = step_.end();
  Mask open{};
  for (std::size_t m = 0; m < count; ++m) open[m] = secants[m].wanted;
  for (int i = 0; i < most_secants && std::find(open.begin(), open.end(), true) != open.end(); ++i) {
    for (std::size_t m = 0; m < count; ++m) {
      if (open[m]) secants[m].next();
      set(part_, m, secants[m].share);
    }
    runge_kutta({way.from, part_ * way.half_steps, part_ * way.step}, state);
    for (std::size_t m = 0; m < count; ++m) {
      if (!open[m]) continue;
      const double v = value_of(secants[m], m, state);
      for (std::size_t j = 0; j < found.size(); ++j) set(found[j], m, of(step_.end()[j], m));
      open[m] = !(std::abs(v) <= secants[m].small);
      if (open[m]) secants[m].take(v);
    }
  }
  step_.end().swap(found);
  for (std::size_t m = 0; m < count; ++m) {
    if (!secants[m].wanted) continue;
    yields_[m] = secants[m].yield;
    if (secants[m].coordinate < modes_) set(step_.end()[modes_ + secants[m].coordinate], m, 0);
  }
}

template <class Number>
auto JumpingMotion<Number>::search_in(std::size_t motion, const State& state, Mask& jumped) -> Secant {
  Secant secant;
  std::size_t k = crossing(motion, state);
  // From rest and back within a step: it has not moved.
  for (; k < modes_ && of(state[modes_ + k], motion) == 0; k = crossing(motion, state)) {
    jumped[motion] = true;
    set(step_.end()[modes_ + k], motion, 0);
  }
  secant.coordinate = k;
  if (k < modes_) {
    jumped[motion] = jumped[motion] || jumps_[k].there[motion];
    secant.v_low = of(state[modes_ + k], motion);
  } else {
    if (parts_[motion] < most_parts) secant.yield = flow_.yielding(motion, state, step_.end());
    if (secant.yield.side == 0 || secant.yield == yields_[motion]) return secant;
    secant.v_low = flow_.left_of(secant.yield, motion, state, state);
  }
  secant.wanted = true;
  secant.start = secant.v_low;
  secant.v_high = value_of(secant, motion, state);
  secant.small = rounding * (std::abs(secant.v_low) + std::abs(secant.v_high));
  return secant;
}

template <class Number>
Number JumpingMotion<Number>::shares(const Number& left, const Way& whole, const State& state, Mask& jumped) {
  Number shares(1.0);
  yields_ = {};
  for (bool searched = true; searched;) {
    OfMotions<Secant> secants;
    searched = false;
    for (std::size_t m = 0; m < count; ++m) {
      if (of(shares, m) > 0 && of(left, m) > 0) secants[m] = search_in(m, state, jumped);
      searched = searched || secants[m].wanted;
    }
    if (!searched) break;
    run(secants, {whole.from, shares * left * whole.half_steps, shares * left * whole.step}, state);
    for (std::size_t m = 0; m < count; ++m)
      if (secants[m].wanted) set(shares, m, of(shares, m) * secants[m].share);
  }
  return shares;
}

template <class Number>
auto JumpingMotion<Number>::advance(double at, double half_steps, double step, State& state, bool begun) -> Mask {
  Mask jumped{};
  Number left(1.0);
  parts_ = {};
  for (bool going = true; going; begun = false) {
    const Way whole{Number(at) + (Number(1.0) - left) * Number(half_steps), Number(half_steps), Number(step)};
    if (!begun) derive(whole.from, state);
    runge_kutta({whole.from, left * whole.half_steps, left * whole.step}, state);
    const Number share = shares(left, whole, state, jumped);
    flow_.slide(state, step_.end(), left, yields_);
    state.swap(step_.end());
    going = false;
    for (std::size_t m = 0; m < count; ++m) {
      ++parts_[m];
      set(left, m, of(share, m) < 1 ? of(left, m) * (1 - of(share, m)) : 0);
      going = going || of(left, m) > 0;
    }
  }
  return jumped;
}

template class JumpingMotion<double>;
template class JumpingMotion<Lanes>;

}  // namespace secular
