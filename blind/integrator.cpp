#include "blind/integrator.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace secular::blind {
namespace {

// Guards of one mode: positive on the present branch, negative beyond its end.
enum Guard : std::size_t {
  friction_guard,
  slider_guard,
  contact_guard,
  band_guard,
  threshold_guard,
  guards_per_mode
};
constexpr double never = std::numeric_limits<double>::infinity();

bool is_finite(const State& state) {
  return std::all_of(state.begin(), state.end(), [](double x) { return std::isfinite(x); });
}

int sign_of(double x) {
  return x < 0 ? -1 : 1;
}

int band_of(double x, double gap) {
  return x > gap ? 1 : x < -gap ? -1 : 0;
}

// Of the branch `band` of a dead band: distance to its nearest end.
double band_distance(int band, double x, double gap) {
  return band == 0 ? gap - std::abs(x) : band * x - gap;
}

}  // namespace

Integrator::Integrator(const Structure& structure, const Drive& drive, double t, const State& state)
    : structure_(structure), drive_(drive), t_(t), excitation_(drive.at(t)), x_(state) {
  start();
}

void Integrator::start() {
  for (std::size_t k = 0; k < structure_.modes; ++k) {
    const ModeTerms& m = structure_.mode[k];
    const double q = displacement(x_, k), p = velocity(x_, k), s = slider_spring(x_, k);
    regime_.sliding[k] = sign_of(p);
    regime_.side[k] = sign_of(q);
    regime_.band[k] = band_of(q, m.gap);
    regime_.beyond[k] = band_of(q, m.threshold);
    regime_.slipping[k] = m.slider != 0 && std::abs(s) >= m.slip && s * p > 0 ? sign_of(p) : 0;
    nonsmooth_ = nonsmooth_ || m.friction != 0 || (m.slider != 0 && !m.smooth_slider) || m.bilinear != 0 ||
                 m.has_gap() || m.threshold_damping != 0;
  }
  for (std::size_t k = 0; k < structure_.modes; ++k)
    if (structure_.mode[k].friction != 0 && velocity(x_, k) == 0) cross(k * guards_per_mode + friction_guard);
}

Integrator::Stepped Integrator::stepped(double h) const {
  const double third = drive_.at(t_ + h / 3), two_thirds = drive_.at(t_ + 2 * h / 3),
               middle = drive_.at(t_ + h / 2), end = drive_.at(t_ + h);
  State k1{}, k2{}, k3{}, k4{}, k5{}, k6{}, k7{}, y{};
  const auto slope = [&](double share, double excitation, State& k) {
    derivative(structure_, drive_, {regime_, t_ + share * h, excitation, y}, k);
  };
  y = x_;
  slope(0, excitation_, k1);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = x_[i] + h / 3 * k1[i];
  slope(1.0 / 3, third, k2);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = x_[i] + h * 2 / 3 * k2[i];
  slope(2.0 / 3, two_thirds, k3);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = x_[i] + h / 12 * (k1[i] + 4 * k2[i] - k3[i]);
  slope(1.0 / 3, third, k4);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = x_[i] + h / 16 * (-k1[i] + 18 * k2[i] - 3 * k3[i] - 6 * k4[i]);
  slope(0.5, middle, k5);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = x_[i] + h / 8 * (9 * k2[i] - 3 * k3[i] - 6 * k4[i] + 4 * k5[i]);
  slope(0.5, middle, k6);
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] = x_[i] + h / 44 * (9 * k1[i] - 36 * k2[i] + 63 * k3[i] + 72 * k4[i] - 64 * k6[i]);
  slope(1, end, k7);
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] = x_[i] + h / 120 * (11 * (k1[i] + k7[i]) + 81 * (k3[i] + k4[i]) - 32 * (k5[i] + k6[i]));
  return {end, y};
}

void Integrator::move(double t, const Stepped& step) {
  t_ = t;
  excitation_ = step.excitation;
  x_ = step.state;
}

double Integrator::guard(std::size_t number, double t, const Stepped& at) const {
  const State& x = at.state;
  const std::size_t k = number / guards_per_mode;
  const ModeTerms& m = structure_.mode[k];
  switch (number % guards_per_mode) {
    case friction_guard:
      if (m.friction == 0) return never;
      if (regime_.sliding[k] != 0) return velocity(x, k) * regime_.sliding[k];
      return m.friction_at(0) - std::abs(force(structure_, drive_, {regime_, t, at.excitation, x}, k));
    case slider_guard:
      if (m.slider == 0 || m.smooth_slider) return never;
      if (regime_.slipping[k] != 0) return velocity(x, k) * regime_.slipping[k];
      return m.slip - std::abs(slider_spring(x, k));
    case contact_guard:
      return m.bilinear == 0 ? never : displacement(x, k) * regime_.side[k];
    case band_guard:
      return !m.has_gap() ? never : band_distance(regime_.band[k], displacement(x, k), m.gap);
    default:
      return m.threshold_damping == 0 ? never : band_distance(regime_.beyond[k], displacement(x, k), m.threshold);
  }
}

// The branch behind the guard that the present state has just passed.
void Integrator::cross(std::size_t number) {
  const std::size_t k = number / guards_per_mode;
  const ModeTerms& m = structure_.mode[k];
  const double q = displacement(x_, k);
  switch (number % guards_per_mode) {
    case friction_guard: {
      const double f = force(structure_, drive_, {regime_, t_, excitation_, x_}, k);
      const bool was_at_rest = regime_.sliding[k] == 0;
      if (!was_at_rest && std::abs(f) <= m.friction_at(0)) {
        regime_.sliding[k] = 0;
        velocity(x_, k) = 0;
      } else {
        regime_.sliding[k] = sign_of(f);
        velocity(x_, k) = 0;
      }
      break;
    }
    case slider_guard:
      if (regime_.slipping[k] != 0) {
        regime_.slipping[k] = 0;
      } else {
        regime_.slipping[k] = sign_of(slider_spring(x_, k));
      }
      slider_spring(x_, k) = std::clamp(slider_spring(x_, k), -m.slip, m.slip);
      break;
    case contact_guard:
      regime_.side[k] = -regime_.side[k];
      break;
    case band_guard:
      regime_.band[k] = regime_.band[k] == 0 ? sign_of(q) : 0;
      break;
    default:
      regime_.beyond[k] = regime_.beyond[k] == 0 ? sign_of(q) : 0;
  }
}

void Integrator::advance(double step) {
  if (!nonsmooth_) {
    move(t_ + step, stepped(step));
    return;
  }
  const double end = t_ + step;
  const std::size_t guards = structure_.modes * guards_per_mode;
  // A slider or a contact that chatters would cut the step without end: after so many cuts the rest is taken whole.
  for (int cuts = 0; cuts < 20; ++cuts) {
    const double left = end - t_;
    const Stepped whole = stepped(left);
    // A motion that has left for infinity has no branches to find.
    if (!is_finite(whole.state)) {
      move(end, whole);
      return;
    }
    double first = left;
    std::size_t which = guards;
    for (std::size_t g = 0; g < guards; ++g) {
      if (guard(g, end, whole) >= 0) continue;
      const double before = guard(g, t_, {excitation_, x_});
      double at = 0;
      if (before > 0) {
        std::uintmax_t evaluations = 30;
        const auto bracket = boost::math::tools::toms748_solve(
            [&](double h) { return guard(g, t_ + h, stepped(h)); }, 0.0, left, before, guard(g, end, whole),
            [step](double a, double b) { return std::abs(b - a) < 1e-12 * step; }, evaluations);
        at = bracket.second;
      }
      if (which == guards || at < first) {
        first = at;
        which = g;
      }
    }
    if (which == guards) {
      move(end, whole);
      return;
    }
    move(t_ + first, stepped(first));
    cross(which);
  }
  move(end, stepped(end - t_));
}

}  // namespace secular::blind
