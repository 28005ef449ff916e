#include "measure/disturbances/left_lines.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "measure/disturbances/lines.hpp"
#include "numerics/distribution.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The motion's strongest line, Hz, by the parabola through the logarithms of its powers; zero where it has none.
double line_of(std::span<const double> motion, double rate_hz) {
  const std::size_t length = motion.size() / 2 * 2;
  const std::vector<double> powers = windowed_powers(motion.first(length), lobe_window(length));
  const auto most = static_cast<std::size_t>(
      std::max_element(powers.begin() + static_cast<std::ptrdiff_t>(lobe_bins), powers.end() - 1) - powers.begin());
  const double before = std::log(powers[most - 1]), here = std::log(powers[most]),
               after = std::log(powers[most + 1]);
  const double bend = before - 2 * here + after, off = bend < 0 ? 0.5 * (before - after) / bend : 0;
  return (static_cast<double>(most) + off) * rate_hz / static_cast<double>(length);
}

// The motion's line in a part of a record, and by how much it changes there.
struct MovingLine {
  double frequency_hz, change_hz;
};

MovingLine moving_line_of(std::span<const double> motion, double rate_hz) {
  const double whole = line_of(motion, rate_hz), first = line_of(motion.first(motion.size() / 2), rate_hz);
  return {whole, std::abs(whole - first)};
}

// Products of a motion are no sharper than the motion is. Where no line of it stands out, as in a resonance that
// noise or a sweep drives, none of its products does.
bool holds_lines(std::span<const double> motion, double rate_hz, double false_alarm) {
  return !find_lines(motion, rate_hz, false_alarm).empty();
}

// Of which multiple of the motion's line it may be, 0: of none. Of a falling line the frequency is fitted, to less
// than a bin; a steady one is told from a multiple by the main lobe. A multiple changes by as many times as its
// order.
double order_among_multiples(const LeftLine& line, const MovingLine& of, double bin_hz) {
  if (!(of.frequency_hz > 0)) return 0;
  const double order = std::max(1.0, std::round(line.frequency_hz / of.frequency_hz));
  return std::abs(line.frequency_hz - order * of.frequency_hz) <
                 (line.rate > 0 ? 1 : lobe_bins) * bin_hz + order * of.change_hz
             ? order
             : 0;
}

// At the first multiple is what the motion itself is off by, whatever its course.
bool is_made_by(const Line& line, double order, std::span<const double> motion, double rate_hz,
                double false_alarm) {
  return holds_lines(motion, rate_hz, false_alarm) &&
         (order < 2 || !outlasts_products(line, change_between_halves(motion), false_alarm));
}

// A falling line as it fits best beside nothing else.
struct Fall {
  double frequency_hz, rate, amplitude, gain;
};

Fall fitted(const VectorXd& left, double frequency_hz, double rate, double rate_hz) {
  MatrixXd waves(left.size(), 2);
  for (Index i = 0; i < left.size(); ++i) {
    const double t = static_cast<double>(i) / rate_hz, falls = std::exp(-rate * t);
    waves.row(i) << falls * std::cos(two_pi * frequency_hz * t), falls * std::sin(two_pi * frequency_hz * t);
  }
  const Eigen::Matrix2d normal = waves.transpose() * waves;
  const Eigen::Vector2d along = waves.transpose() * left, size = normal.ldlt().solve(along);
  return {frequency_hz, rate, size.norm(), size.dot(along)};
}

// By the largest gain over a grid that closes in about a frequency: `reach_hz` on either side, rates from a tenth
// of one in the whole to sixteen in the part, or `sign` = -1: of a line that grows; 0: of one that is steady.
Fall best_fall(const VectorXd& left, double frequency_hz, double reach_hz, double part_s, double rate_hz,
               int sign) {
  const double whole_s = static_cast<double>(left.size()) / rate_hz;
  double rate = std::sqrt(1.6 / (part_s * whole_s)), ratio = std::sqrt(160 * whole_s / part_s);
  Fall best = fitted(left, frequency_hz, sign * rate, rate_hz);
  const int rates = sign == 0 ? 0 : 4;
  for (int round = 0; round < 4; ++round) {
    const double about_hz = best.frequency_hz;
    for (int f = -4; f <= 4; ++f)
      for (int r = -rates; r <= rates; ++r) {
        const Fall fall =
            fitted(left, about_hz + 0.25 * f * reach_hz, sign * rate * std::pow(ratio, 0.25 * r), rate_hz);
        if (fall.gain > best.gain) best = fall;
      }
    if (sign != 0) rate = std::abs(best.rate);
    reach_hz *= 0.25;
    ratio = std::pow(ratio, 0.25);
  }
  return best;
}

// Steady where neither falling nor growing takes more than chance; nothing where it grows.
std::optional<LeftLine> fitted_line(const VectorXd& left, double frequency_hz, double part_s, double rate_hz,
                                    double false_alarm) {
  const double whole_s = static_cast<double>(left.size()) / rate_hz;
  const Fall falls = best_fall(left, frequency_hz, 2 / part_s, part_s, rate_hz, 1),
             steady = best_fall(left, falls.frequency_hz, 1 / whole_s, part_s, rate_hz, 0);
  const double freedom = static_cast<double>(left.size()) - 4;
  const auto takes_more = [&](const Fall& fall) {
    const double variance = (left.squaredNorm() - fall.gain) / freedom;
    return fall.gain > steady.gain &&
           (!(variance > 0) || f_upper_tail((fall.gain - steady.gain) / variance, 1, freedom) < false_alarm);
  };
  if (takes_more(falls)) return LeftLine{falls.frequency_hz, falls.amplitude, falls.rate};
  if (takes_more(best_fall(left, steady.frequency_hz, 1 / whole_s, whole_s, rate_hz, -1))) return std::nullopt;
  return LeftLine{steady.frequency_hz, steady.amplitude, 0};
}

}  // namespace

std::vector<LeftLine> find_left_lines(std::span<const double> left, std::span<const double> motion, double rate_hz,
                                      double false_alarm) {
  std::vector<LeftLine> found;
  const auto add = [&](const Line& line, std::span<const double> moving, double part_s, bool steady) {
    const double bin_hz = 1 / part_s;
    for (const LeftLine& other : found)
      if (std::abs(other.frequency_hz - line.frequency_hz) < lobe_bins * bin_hz) return;
    const std::optional<LeftLine> fresh =
        steady ? LeftLine{line.frequency_hz, line.amplitude, 0}
               : fitted_line(Eigen::Map<const VectorXd>(left.data(), static_cast<Index>(left.size())),
                             line.frequency_hz, part_s, rate_hz, 0.5 * false_alarm);
    if (!fresh) return;
    const double order = order_among_multiples(*fresh, moving_line_of(moving, rate_hz), bin_hz);
    if (order > 0 && (!steady || is_made_by(line, order, moving, rate_hz, 0.5 * false_alarm))) return;
    found.push_back(*fresh);
  };
  for (const Line& line : find_lines(left, rate_hz, 0.5 * false_alarm))
    if (line.steady) add(line, motion, static_cast<double>(left.size()) / rate_hz, true);
  for (std::size_t length = left.size() / 2; length >= 8 * static_cast<std::size_t>(line_reach); length /= 2)
    for (const Line& line : find_lines(left.first(length), rate_hz, 0.5 * false_alarm))
      add(line, motion.first(length), static_cast<double>(length) / rate_hz, false);
  return found;
}

}  // namespace secular
