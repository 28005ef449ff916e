#pragma once

#include <cstddef>
#include <vector>

#include "motion/integrate/motion_flow.hpp"

namespace secular {

/// Steps of the classical fourth-order method, of one motion or of several side by side.
template <class Number>
class RungeKutta {
 public:
  using State = std::vector<Number>;

  explicit RungeKutta(std::size_t size) : k1_(size), k2_(size), k3_(size), k4_(size), stage_(size), end_(size) {}

  /// Derivative where the step begins, to be set before it is taken.
  State& rate() { return k1_; }
  const State& rate() const { return k1_; }
  /// Where the step ends.
  State& end() { return end_; }
  const State& end() const { return end_; }

  /// derivative(time in half steps of the samples, state, where the step begins, derivative)
  template <class Time, class Derivative>
  void take(const Time& at, const Time& half_steps, const Number& step, const State& state,
            const Derivative& derivative) {
    const Number half_step = Number(0.5) * step;
    const Time middle = at + Time(0.5) * half_steps;
    go(state, half_step, k1_);
    derivative(middle, stage_, state, k2_);
    go(state, half_step, k2_);
    derivative(middle, stage_, state, k3_);
    go(state, step, k3_);
    derivative(at + half_steps, stage_, state, k4_);
    const Number sixth = step / Number(6.0), two(2.0);
    for (std::size_t i = 0; i < end_.size(); ++i)
      end_[i] = state[i] + sixth * (k1_[i] + two * k2_[i] + two * k3_[i] + k4_[i]);
  }

 private:
  void go(const State& state, const Number& way, const State& rate) {
    for (std::size_t i = 0; i < stage_.size(); ++i) stage_[i] = state[i] + way * rate[i];
  }

  State k1_, k2_, k3_, k4_, stage_, end_;
};

}  // namespace secular
