#include "diagnose/evidence/virtual_dwell.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// Balance over inertia at which a motion counts as steady.
constexpr double steady = 1e-9;

constexpr int most_iterations = 15;

/// An amplitude changes by no more than this share in one step along the branch.
constexpr double longest_step = 0.25;

/// Steps along the branch are not cut finer than this share of the way.
constexpr double finest_step = 1.0 / 64;

struct BranchPoint {
  VectorXcd amplitudes;
  Motion motion;
  double determinant = 0;  ///< of the balance by the amplitudes; no fold lies between points of the same sign
};

Condition driven(const Condition& measured, double level, double frequency) {
  Condition c = measured;
  c.amplitude_drift_rate.clear();
  c.amplitude_drift_rate_sd.clear();
  for (Complex& rate : c.rate) rate = Complex(0, frequency * rate.imag());
  c.excitation *= level;
  return c;
}

class Branch {
 public:
  Branch(const ConditionModel& model, const Condition& measured, const VectorXd& unknowns)
      : model_(model), measured_(measured), unknowns_(unknowns) {}

  std::optional<Condition> follow(double level, double frequency) const {
    ConditionRows rows = model_.rows(measured_, unknowns_, nullptr);
    const BranchPoint start{std::move(rows.amplitudes), std::move(rows.motion), 0};
    if (!start.amplitudes.allFinite()) return std::nullopt;
    std::optional<BranchPoint> here = steady_at(driven(measured_, 1, 1), start);
    if (!here) return std::nullopt;
    double way = 0, step = 1;
    while (way < 1) {
      const double next = std::min(1.0, way + step);
      const Condition c = driven(measured_, std::pow(level, next), std::pow(frequency, next));
      std::optional<BranchPoint> there = steady_at(c, *here);
      const bool near =
          there && ((there->amplitudes - here->amplitudes).array().abs() <
                    longest_step * here->amplitudes.array().abs().max(there->amplitudes.array().abs()))
                       .all();
      if (!near) {
        step /= 2;
        if (step < finest_step) return std::nullopt;
        continue;
      }
      if (there->determinant * here->determinant <= 0) return std::nullopt;
      here = std::move(there);
      way = next;
    }
    Condition c = driven(measured_, level, frequency);
    ConditionForecast forecast = model_.forecast(c, here->amplitudes, unknowns_, &here->motion);
    if (!forecast.response.allFinite()) return std::nullopt;
    c.response = std::move(forecast.response);
    for (std::size_t l = 0; l < c.excitation_lines.size(); ++l)
      for (Index j = 0; j < c.excitation.rows(); ++j)
        if (c.excitation_lines[l] != c.tone_of(j))
          c.excitation(j, static_cast<Index>(l)) = forecast.excitation(j, static_cast<Index>(l));
    return c;
  }

 private:
  VectorXd balance(const Condition& c, const VectorXcd& amplitudes, Motion& motion) const {
    ConditionForecast forecast = model_.forecast(c, amplitudes, unknowns_, motion.converged() ? &motion : nullptr);
    motion = std::move(forecast.motion);
    VectorXd parts(2 * amplitudes.size());
    for (Index m = 0; m < amplitudes.size(); ++m) {
      const double inertia = std::norm(c.line_rate(c.masters[static_cast<std::size_t>(m)].line));
      parts(2 * m) = forecast.balance(m).real() / inertia;
      parts(2 * m + 1) = forecast.balance(m).imag() / inertia;
    }
    return parts;
  }

  // Newton's method in ln(amplitude): its real part is the change of size, its imaginary part that of phase.
  std::optional<BranchPoint> steady_at(const Condition& c, const BranchPoint& start) const {
    BranchPoint point = start;
    const Index size = 2 * point.amplitudes.size();
    for (int i = 0; i < most_iterations; ++i) {
      const VectorXd value = balance(c, point.amplitudes, point.motion);
      if (!point.motion.converged() || !value.allFinite()) return std::nullopt;
      MatrixXd jacobian(size, size);
      constexpr double h = 1e-6;
      for (Index k = 0; k < size; ++k) {
        VectorXcd moved = point.amplitudes;
        moved(k / 2) *= std::exp(k % 2 == 0 ? Complex(h) : Complex(0, h));
        Motion motion = point.motion;
        jacobian.col(k) = (balance(c, moved, motion) - value) / h;
      }
      const Eigen::PartialPivLU<MatrixXd> solver(jacobian);
      point.determinant = solver.determinant();
      if (value.cwiseAbs().maxCoeff() < steady) return point;
      VectorXd step = -solver.solve(value);
      if (!step.allFinite()) return std::nullopt;
      const double length = step.cwiseAbs().maxCoeff();
      if (length > 0.5) step *= 0.5 / length;
      for (Index m = 0; m < point.amplitudes.size(); ++m)
        point.amplitudes(m) *= std::exp(Complex(step(2 * m), step(2 * m + 1)));
    }
    return std::nullopt;
  }

  const ConditionModel& model_;
  const Condition& measured_;
  const VectorXd& unknowns_;
};

}  // namespace

std::optional<Condition> virtual_dwell(const ConditionModel& model, const Condition& measured,
                                       const VectorXd& unknowns, double level, double frequency) {
  if (measured.torus->dimensions() != 1 || measured.masters.empty() || measured.fundamental == 0)
    return std::nullopt;
  return Branch(model, measured, unknowns).follow(level, frequency);
}

}  // namespace secular
