#pragma once

#include <array>
#include <utility>
#include <vector>

#include "motion/integrate/runge_kutta.hpp"

namespace secular {

/// Steps of motions side by side whose accelerations may jump where a velocity changes its sign, or have a corner
/// where a slider begins to slide or to hold; each goes as it would alone.
template <class Number>
class JumpingMotion {
 public:
  using State = std::vector<Number>;
  /// Of some motions.
  using Mask = std::array<bool, Motions<Number>::count>;

  /// `motions`: so many of those that go side by side count.
  JumpingMotion(MotionFlow<Number>& flow, const State& start, std::size_t motions);

  /// Whether any acceleration jumps at displacements as large as those of the motions, or a slider acts.
  bool has_corners() const;
  /// The derivative at a sample, from which the first step goes on.
  void begin(double at, const State& state) { derive(Number(at), state); }
  const State& rate() const { return step_.rate(); }
  /// One step, in as many parts as there are jumps and corners within it; in which motions there was a jump.
  /// `begun`: the derivative is known.
  Mask advance(double at, double half_steps, double step, State& state, bool begun);

 private:
  static constexpr std::size_t count = Motions<Number>::count;
  template <class Value>
  using OfMotions = std::array<Value, count>;

  using Yield = typename MotionFlow<Number>::Yield;

  // To which side a coordinate moves where that counts: accelerations jump with it, or sliders follow it. 0: none,
  // or it is held by the jump. turns: where it turns sliders change.
  struct Jump {
    Mask there{}, slides{}, held{}, turns{};
    OfMotions<int> side{};
    bool anywhere = false, holds = false, sliders = false;  // in any motion
  };
  // Part of a step that motions go, time in half steps of the samples.
  struct Way {
    Number from, half_steps, step;
  };
  // A search for the share of its way after which a velocity is zero, or a slider gives way.
  struct Secant {
    std::size_t coordinate = 0;  // as many as there are: no velocity
    Yield yield = {};
    bool wanted = false;
    double low = 0, v_low = 0, high = 1, v_high = 0, start = 0, small = 0, share = 1;
    int side = 0;

    void next() { share = (low * v_high - high * v_low) / (v_high - v_low); }
    void take(double v);
  };

  static double of(const Number& number, std::size_t motion) { return Motions<Number>::of(number, motion); }
  static void set(Number& number, std::size_t motion, double value) { Motions<Number>::set(number, motion, value); }

  void beside_rest(std::size_t k, const State& state, State velocity, const State& origin);
  void find_jumps(State state, std::size_t motions);
  void take_sides(const Number& at, const State& state);
  void take_rests(std::size_t k, const State& state);
  void load_sliders(const Number& at, const State& state);
  void derive(const Number& at, const State& state);
  void derivative(const Number& at, const State& state, const State& origin, State& rate);
  void stay_on_sides(std::size_t k);
  void hold(std::size_t k, const State& state, const State& origin);
  void runge_kutta(const Way& way, const State& state);
  std::size_t crossing(std::size_t motion, const State& state) const;
  double value_of(const Secant& secant, std::size_t motion, const State& state) const;
  /// What ends the way of a motion first, as far as it is known.
  Secant search_in(std::size_t motion, const State& state, Mask& jumped);
  /// Shares of what is left of a whole step after which motions come to rest, 1 where they do not; in step_.end()
  /// where they are then.
  Number shares(const Number& left, const Way& whole, const State& state, Mask& jumped);
  void run(OfMotions<Secant>& secants, const Way& way, const State& state);

  MotionFlow<Number>& flow_;
  std::size_t modes_;
  std::vector<Jump> jumps_;  // by coordinate
  std::vector<Mask> held_;   // in the derivative
  OfMotions<Yield> yields_;  // where the step ends
  OfMotions<int> parts_{};   // of a whole step so far
  State velocity_, above_, below_;
  Number part_ = Number(0.0);  // of a way
  RungeKutta<Number> step_;
};

extern template class JumpingMotion<double>;
extern template class JumpingMotion<Lanes>;

}  // namespace secular
