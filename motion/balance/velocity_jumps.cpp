#include "motion/balance/velocity_jumps.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "numerics/hertz.hpp"

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

/// Newton's method doubles its digits from the one or two that a straight line between two samples has.
constexpr int newton_steps = 4;

/// A resonance this close (in units of the base frequency) is moved off: it is no line beyond the torus, and its
/// terms only have to cancel.
constexpr double beside_resonance = 1e-4;

// Value and slope of a row of lines at a phase.
std::pair<double, double> at_phase(const MatrixXcd& lines, Index row, double phase) {
  double value = lines(row, 0).real(), slope = 0;
  const Complex turn = std::polar(1.0, phase);
  Complex factor = 1;
  for (Index n = 1; n < lines.cols(); ++n) {
    factor *= turn;
    const Complex term = 2.0 * lines(row, n) * factor;
    value += term.real();
    slope -= static_cast<double>(n) * term.imag();
  }
  return {value, slope};
}

}  // namespace

std::vector<Turning> turnings(const Torus& torus, const MatrixXcd& velocity_lines, const MatrixXd& velocity) {
  std::vector<Turning> all;
  if (torus.dimensions() != 1) return all;
  const Index points = velocity.cols();
  for (Index k = 0; k < velocity.rows(); ++k)
    for (Index p = 0; p < points; ++p) {
      const double here = velocity(k, p), next = velocity(k, p + 1 == points ? 0 : p + 1);
      if ((here < 0) == (next < 0)) continue;
      const double step = two_pi / static_cast<double>(points), begin = torus.angle(p);
      Turning turning{k, begin + step * here / (here - next), 0, 0};
      for (int i = 0; i < newton_steps; ++i) {
        const auto [value, slope] = at_phase(velocity_lines, k, turning.seen);
        turning.slope = slope;
        const double moved = turning.seen - value / slope;
        if (!(moved >= begin && moved <= begin + step)) break;
        turning.seen = moved;
      }
      turning.phase = turning.seen;
      // Beside a maximum that hardly is one the straight line's slope holds.
      if (turning.slope * (next - here) <= 0) turning.slope = (next - here) / step;
      all.push_back(turning);
    }
  return all;
}

// The whole sum is that of a mode driven by a sawtooth: sum over n of cos(n x)/(n^2 - a^2) =
// 1/(2 a^2) - pi cos(a (pi - x))/(2 a sin(pi a)) for 0 <= x <= 2 pi.
double velocity_beyond(double phase, int highest, double base, double natural) {
  const double pi = std::numbers::pi, x = phase - two_pi * std::floor(phase / two_pi);
  double a = natural / base;
  if (std::abs(a - std::round(a)) < beside_resonance) a = std::round(a) + beside_resonance;
  double sum = 1 / (2 * a * a) - pi * std::cos(a * (pi - x)) / (2 * a * std::sin(pi * a));
  for (int n = 1; n <= highest; ++n) sum -= std::cos(n * x) / (n * n - a * a);
  return -sum / (pi * base);
}

MatrixXcd lines_with_jumps(const Torus& torus, MatrixXd samples, const std::vector<Turning>& turnings,
                           const MatrixXd& sizes) {
  const auto jumps = static_cast<Index>(turnings.size());
  for (Index j = 0; j < jumps; ++j) {
    if (sizes.col(j).isZero(0)) continue;
    for (Index p = 0; p < samples.cols(); ++p) {
      const double turns = (torus.angle(p) - turnings[static_cast<std::size_t>(j)].seen) / two_pi;
      samples.col(p) -= sizes.col(j) * (0.5 - (turns - std::floor(turns)));
    }
  }
  MatrixXcd lines = torus.coefficients(samples);
  for (Index j = 0; j < jumps; ++j) {
    if (sizes.col(j).isZero(0)) continue;
    const Turning& turning = turnings[static_cast<std::size_t>(j)];
    lines.col(0) -= sizes.col(j) * ((turning.phase - turning.seen) / two_pi);
    for (Index n = 1; n < lines.cols(); ++n) {
      const auto order = static_cast<double>(n);
      lines.col(n) += sizes.col(j) * (std::polar(1.0, -order * turning.phase) / Complex(0, two_pi * order));
    }
  }
  return lines;
}

Eigen::RowVectorXcd slope_by_phase(const Torus& torus, double phase) {
  Eigen::RowVectorXcd lines(torus.lines());
  for (Index n = 0; n < lines.size(); ++n) lines(n) = -std::polar(1 / two_pi, -static_cast<double>(n) * phase);
  return lines;
}

}  // namespace secular
