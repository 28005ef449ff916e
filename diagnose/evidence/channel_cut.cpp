#include "diagnose/evidence/channel_cut.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/evidence/saturation.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// No step of undoing a cut is longer than this share of the line; the reading of a line grows with it by at least
/// this factor, or nothing can be said of it.
constexpr double longest_undoing = 0.3, least_slope = 1e-3;

}  // namespace

void ChannelCut::apply(const Torus& torus, MatrixXcd& lines, Index row) const {
  MatrixXd samples = torus.samples(lines.row(row));
  const double peak = samples.cwiseAbs().maxCoeff();
  if (saturated(peak, level, noise_sd) == peak) return;
  samples = samples.unaryExpr([&](double x) { return saturated(x, level, noise_sd); });
  lines.row(row) = torus.coefficients(samples);
}

Complex ChannelCut::uncut_share(const Torus& torus, const MatrixXcd& lines, Index line, Complex shown) const {
  if (shown == 0.0) return 1;
  const auto fundamental = [&](double half) { return saturated_fundamental(half, level, noise_sd); };
  const double alone = unsaturated_amplitude(std::abs(shown), level, noise_sd);
  Complex uncut = shown * (alone / std::abs(shown));
  for (int i = 0; i < most_undoings; ++i) {
    MatrixXcd cut = lines;
    cut(0, line) = uncut;
    apply(torus, cut, 0);
    const double half = std::abs(uncut), step = 1e-4 * half;
    const Complex direction = uncut / half;
    const Complex lacking = (shown - cut(0, line)) / direction;
    const double along = (fundamental(half + step) - fundamental(half - step)) / (2 * step);
    Complex change(lacking.real() / std::max(along, least_slope), lacking.imag() * half / fundamental(half));
    if (std::abs(change) > longest_undoing * half) change *= longest_undoing * half / std::abs(change);
    uncut += change * direction;
    if (std::abs(change) <= undone_cut * half) break;
  }
  return uncut / shown;
}

}  // namespace secular
