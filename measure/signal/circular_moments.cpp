#include "measure/signal/circular_moments.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "measure/signal/folded_window.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Share of the samples: smaller squares of a function are differences of large sums.
constexpr double smallest_square = 1e-3;
/// Of N y: below, the derivatives cancel in their leading terms.
constexpr double smallest_argument = 0.5;

struct Tone {
  double y = 0, sine = 0, cosine = 1;  // y = frequency / (2 rate), sin(N y), cos(N y)
  Index row = 0;
  bool constant = false;
};

// Sums over the window of cos(x t), tau sin(x t), tau^2 cos(x t).
struct Sums {
  double cosine = 0, timed_sine = 0, squared_cosine = 0;
};

// With x t = 2 y m at samples m from the centre, D(y) = sum of cos(2 y m) = sin(N y)/sin(y), and sum of m sin =
// -D'/2, of m^2 cos = -D''/4. The derivatives follow from D sin(y) = sin(N y) by differentiating both sides.
bool sum_up(const Tone& a, const Tone& b, double sign, double n, Sums& sums) {
  const double y = a.y + sign * b.y, k = std::nearbyint(y / std::numbers::pi), rest = y - k * std::numbers::pi;
  if (y == 0) {
    sums = {n, 0, n * (n + 1) / (3 * (n - 1))};
    return true;
  }
  if (std::abs(n * rest) < smallest_argument) return false;
  const double turned = std::fmod(k, 2) != 0 ? -1 : 1, s = turned * std::sin(rest), c = turned * std::cos(rest);
  const double sine = a.sine * b.cosine + sign * a.cosine * b.sine;
  const double cosine = a.cosine * b.cosine - sign * a.sine * b.sine;
  const double d = sine / s, d1 = (n * cosine - d * c) / s, d2 = (d * s - 2 * d1 * c - n * n * sine) / s;
  sums = {d, -d1 / (n - 1), -d2 / ((n - 1) * (n - 1))};
  return true;
}

}  // namespace

std::optional<TimedMoments> circular_moments(std::span<const Pole> poles, const FoldedWindow& window) {
  const auto n = static_cast<double>(window.samples);
  std::vector<Tone> tones;
  Index rows = 0;
  for (const Pole& pole : poles) {
    if (pole.family != PoleFamily::circular && pole.family != PoleFamily::constant) return std::nullopt;
    Tone tone;
    tone.row = rows;
    tone.constant = pole.family == PoleFamily::constant;
    if (!tone.constant) {
      tone.y = 0.5 * pole.frequency / window.rate;
      tone.sine = std::sin(n * tone.y);
      tone.cosine = std::cos(n * tone.y);
    }
    tones.push_back(tone);
    rows += function_count(pole);
  }
  if (tones.empty()) return std::nullopt;
  TimedMoments m{MatrixXd::Zero(rows, rows), MatrixXd::Zero(rows, rows), MatrixXd::Zero(rows, rows)};
  const auto put = [](MatrixXd& matrix, Index i, Index j, double value) { matrix(i, j) = matrix(j, i) = value; };
  for (std::size_t i = 0; i < tones.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const Tone &a = tones[i], &b = tones[j];
      Sums minus, plus;
      if (!sum_up(a, b, -1, n, minus) || !sum_up(a, b, 1, n, plus)) return std::nullopt;
      put(m.zeroth, a.row, b.row, 0.5 * (minus.cosine + plus.cosine));
      put(m.second, a.row, b.row, 0.5 * (minus.squared_cosine + plus.squared_cosine));
      if (!b.constant) put(m.first, a.row, b.row + 1, 0.5 * (plus.timed_sine - minus.timed_sine));
      if (!a.constant) put(m.first, a.row + 1, b.row, 0.5 * (plus.timed_sine + minus.timed_sine));
      if (a.constant || b.constant) continue;
      put(m.zeroth, a.row + 1, b.row + 1, 0.5 * (minus.cosine - plus.cosine));
      put(m.second, a.row + 1, b.row + 1, 0.5 * (minus.squared_cosine - plus.squared_cosine));
    }
  if (m.zeroth.diagonal().minCoeff() < smallest_square * n) return std::nullopt;
  return m;
}

}  // namespace secular
