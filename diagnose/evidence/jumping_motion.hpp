#pragma once

#include <utility>
#include <vector>

#include "diagnose/evidence/runge_kutta.hpp"

namespace secular {

/// Steps of one motion whose accelerations may jump where a velocity changes its sign.
class JumpingMotion {
 public:
  using State = std::vector<double>;

  JumpingMotion(MotionFlow<double>& flow, const State& start);

  /// Whether any acceleration jumps at displacements as large as those of the motion.
  bool has_jumps() const;
  /// The derivative at a sample, from which the first step goes on.
  void begin(double at, const State& state) { derive(at, state); }
  const State& rate() const { return step_.rate(); }
  /// One step, in as many parts as velocities come to zero within it; whether one did. `begun`: the derivative is
  /// known.
  bool advance(double at, double half_steps, double step, State& state, bool begun);

 private:
  // On which side of a jump at zero velocity a coordinate moves; 0: there is none, or it is held by it.
  struct Jump {
    bool there = false, held = false;
    int side = 0;
  };

  std::pair<double, double> beside_rest(std::size_t k, const State& state, State velocity, const State& origin);
  void find_jumps(double at, State state);
  void take_sides(double at, const State& state);
  void derive(double at, const State& state);
  void derivative(double at, const State& state, const State& origin, State& rate);
  void runge_kutta(double at, double half_steps, double step, const State& state);
  std::size_t crossing() const;
  double share_to_rest(std::size_t k, double at, double half_steps, double step, const State& state);

  MotionFlow<double>& flow_;
  std::size_t modes_;
  std::vector<Jump> jumps_;  // by coordinate
  std::vector<std::size_t> held_;
  State velocity_, above_, below_;
  RungeKutta<double> step_;
};

}  // namespace secular
