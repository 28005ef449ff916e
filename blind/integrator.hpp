#pragma once

#include "blind/structure.hpp"

namespace secular::blind {

/// Runge-Kutta of sixth order (seven stages; J. C. Butcher, J. Austral. Math. Soc. 4 (1964) 179) with a fixed step,
/// which is cut where a nonsmooth term changes its branch (friction that reverses or comes to rest, a slider that
/// starts or stops, a contact, a dead band), so that no step crosses a kink.
class Integrator {
 public:
  /// `state` at time t (seconds since the record began; negative while it settles).
  Integrator(const Structure& structure, const Drive& drive, double t, const State& state);

  /// By `step` seconds, in parts where nonsmooth terms change their branch.
  void advance(double step);

  double time() const { return t_; }
  const State& state() const { return x_; }
  const Regime& regime() const { return regime_; }
  Accelerations acceleration() const { return accelerations(structure_, drive_, {regime_, t_, excitation_, x_}); }

 private:
  struct Stepped {
    double excitation;  // at its end
    State state;
  };
  Stepped stepped(double step) const;
  void move(double t, const Stepped& step);
  double guard(std::size_t number, double t, const Stepped& at) const;
  void cross(std::size_t number);
  void start();

  Structure structure_;
  Drive drive_;
  double t_, excitation_;
  State x_;
  Regime regime_;
  bool nonsmooth_ = false;
};

}  // namespace secular::blind
