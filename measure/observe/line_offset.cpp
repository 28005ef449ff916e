#include "measure/observe/line_offset.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Lines compared in a bin (1 over the window's length): a Hann window's peak is two bins wide to either side.
constexpr int lines_in_a_bin = 4;

/// More do not belong to a motion that is nearly at its frequency, and would cost time in long windows.
constexpr double most_bins = 64;

// Summed power of lines at a frequency, of windows that are tapered already.
double power_at(const MatrixXd& tapered, double step) {
  double sum = 0;
  for (Index c = 0; c < tapered.cols(); ++c) {
    std::complex<double> line = 0;
    const std::complex<double> turn = std::polar(1.0, -step);
    std::complex<double> phase = 1;
    for (Index i = 0; i < tapered.rows(); ++i) {
      line += tapered(i, c) * phase;
      phase *= turn;
    }
    sum += std::norm(line);
  }
  return sum;
}

// Of lines about the one in the middle: the strongest within a bin of it where it is a line by itself (of a Hann
// window it has a quarter of its power left a bin away; beside another tone's it falls on one side alone), else the
// strongest of all.
Index own_or_strongest(const VectorXd& power, Index middle) {
  Index strongest = middle;
  power.maxCoeff(&strongest);
  if (middle < 2 * lines_in_a_bin) return strongest;
  Index own = middle;
  power.segment(middle - lines_in_a_bin, 2 * lines_in_a_bin + 1).maxCoeff(&own);
  own += middle - lines_in_a_bin;
  const double beside = std::max(power(own - lines_in_a_bin), power(own + lines_in_a_bin));
  return beside < 0.5 * power(own) ? own : strongest;
}

}  // namespace

LineOffset line_offset(const Eigen::Ref<const MatrixXd>& windows, double sample_rate_hz, double frequency,
                       double reach) {
  const Index count = windows.rows();
  MatrixXd tapered = windows.rowwise() - windows.colwise().mean();
  for (Index i = 0; i < count; ++i)
    tapered.row(i) *= 0.5 - 0.5 * std::cos(two_pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
  const double here = frequency / sample_rate_hz, bin = two_pi / static_cast<double>(count);
  const auto most = static_cast<int>(lines_in_a_bin * std::min(most_bins, reach * here / bin));
  const double line = bin / lines_in_a_bin;
  VectorXd power(2 * most + 1);
  for (int n = -most; n <= most; ++n) power(n + most) = power_at(tapered, here + n * line);
  const Index strongest = own_or_strongest(power, most);
  double at = static_cast<double>(strongest);
  if (strongest > 0 && strongest < 2 * most) {  // the vertex of a parabola through logarithms
    const double before = std::log(power(strongest - 1)), peak = std::log(power(strongest)),
                 after = std::log(power(strongest + 1));
    if (const double bend = before - 2 * peak + after; bend < 0) at += 0.5 * (before - after) / bend;
  }
  const double step = (at - most) * line;
  return {step * static_cast<double>(count),
          power(most) > 0 ? std::max(0.0, power_at(tapered, here + step) / power(most) - 1) : INFINITY,
          std::max(1.0, 2.0 * most / lines_in_a_bin)};
}

double lost_by_turn(double turn) {
  const double half = 0.5 * std::abs(turn);
  return half > 0 ? 1 - std::abs(std::sin(half) / half) : 0.0;
}

}  // namespace secular
