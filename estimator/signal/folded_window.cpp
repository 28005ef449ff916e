#include "estimator/signal/folded_window.hpp"

#include <cmath>
#include <numbers>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd square_of(const MatrixXd& a) {
  MatrixXd result = MatrixXd::Zero(a.cols(), a.cols());
  if (a.cols() == 0) return result;
  result.selfadjointView<Eigen::Lower>().rankUpdate(a.transpose());
  return result.selfadjointView<Eigen::Lower>();
}

// Functions of one parity alone leave the other part without columns, which Eigen's products do not take.
MatrixXd product_of(const MatrixXd& a, const MatrixXd& b) {
  if (a.cols() == 0 || b.cols() == 0) return MatrixXd(a.cols(), b.cols());
  return a.transpose() * b;
}

/// Share of the samples.
constexpr double smallest_square = 1e-3;

// Sum of cos(x t) over the samples, symmetric about t = 0: sin(N y)/sin(y), y = x/(2 rate). Away from y = 0 both
// sines are taken from the nearest multiple k pi of pi, with the sign (-1)^(k (N - 1)).
double cosine_sum(double x, const FoldedWindow& window) {
  const double y = 0.5 * x / window.rate, k = std::nearbyint(y / std::numbers::pi), rest = y - k * std::numbers::pi;
  const auto n = static_cast<double>(window.samples);
  const double ratio = std::abs(rest) < 1e-300 ? n : std::sin(n * rest) / std::sin(rest);
  return std::fmod(k, 2) != 0 && window.samples % 2 == 0 ? -ratio : ratio;
}

void subtract_product(const MatrixXd& a, const MatrixXd& b, MatrixXd& from) {
  if (a.cols() > 0) from.noalias() -= a * b;
}

}  // namespace

FoldedWindow::FoldedWindow(Index count, double sample_rate_hz)
    : samples(count),
      rows((count + 1) / 2),
      first(count / 2),
      rate(sample_rate_hz),
      half(0.5 * static_cast<double>(count - 1) / sample_rate_hz),
      weight(VectorXd::Constant(rows, std::numbers::sqrt2)),
      time(rows) {
  const bool centred = count % 2 == 1;
  if (centred) weight(0) = 1;
  const double scale = 1 / (half * rate);
  for (Index i = 0; i < rows; ++i) time(i) = (static_cast<double>(i) + (centred ? 0 : 0.5)) * scale;
}

MatrixXd FoldedWindow::even(const Eigen::Ref<const MatrixXd>& channels) const {
  return (0.5 * weight).asDiagonal() * (channels.bottomRows(rows) + channels.topRows(rows).colwise().reverse());
}

MatrixXd FoldedWindow::odd(const Eigen::Ref<const MatrixXd>& channels) const {
  return (0.5 * weight).asDiagonal() * (channels.bottomRows(rows) - channels.topRows(rows).colwise().reverse());
}

MatrixXd FoldedWindow::unfold(const MatrixXd& even_part, const MatrixXd& odd_part) const {
  MatrixXd channels(samples, even_part.cols());
  const VectorXd inverse = weight.cwiseInverse();
  channels.topRows(rows) = (inverse.asDiagonal() * (even_part - odd_part)).colwise().reverse();
  channels.bottomRows(rows) = inverse.asDiagonal() * (even_part + odd_part);
  return channels;
}

FoldedFunctions::FoldedFunctions(std::span<const Pole> poles, const FoldedWindow& of_window) : window(&of_window) {
  const MatrixXd functions = pole_functions(poles, window->rows, window->rate, window->time(0) * window->half);
  // The sign (-1)^l counts from the first sample of the whole window; over an even number of samples it is odd.
  const double sign = window->first % 2 == 0 ? 1 : -1;
  std::vector<double> scale;
  Index at = 0;
  for (const Pole& pole : poles) {
    const Index size = function_count(pole);
    const bool nyquist = pole.family == PoleFamily::nyquist_hyperbolic;
    if (pole.family != PoleFamily::circular && pole.family != PoleFamily::constant) only_circular = false;
    for (Index i = 0; i < size; ++i, ++at) {
      const bool sine = i == 1 || i == 2;
      const bool is_odd = nyquist && window->samples % 2 == 0 ? !sine : sine;
      (is_odd ? odd_at : even_at).push_back(at);
      scale.push_back(nyquist ? sign : 1);
      frequency.push_back(pole.family == PoleFamily::constant ? 0 : pole.frequency);
    }
  }
  const auto gather = [&](const std::vector<Index>& places, MatrixXd& part) {
    part.resize(window->rows, static_cast<Index>(places.size()));
    for (std::size_t k = 0; k < places.size(); ++k)
      part.col(static_cast<Index>(k)) =
          scale[static_cast<std::size_t>(places[k])] * window->weight.cwiseProduct(functions.col(places[k]));
  };
  gather(even_at, even);
  gather(odd_at, odd);
}

// Of cosines and sines: sums of cos(x t) over the window, at sums and differences of the frequencies.
MatrixXd FoldedFunctions::circular_gram() const {
  MatrixXd result = MatrixXd::Zero(even.cols() + odd.cols(), even.cols() + odd.cols());
  const auto fill = [&](const std::vector<Index>& places, double sign) {
    for (const Index i : places)
      for (const Index j : places) {
        if (j > i) break;
        const double a = frequency[static_cast<std::size_t>(i)], b = frequency[static_cast<std::size_t>(j)];
        result(i, j) = result(j, i) = 0.5 * (cosine_sum(a - b, *window) + sign * cosine_sum(a + b, *window));
      }
  };
  fill(even_at, 1);
  fill(odd_at, -1);
  return result;
}

MatrixXd FoldedFunctions::gram() const {
  if (only_circular && !frequency.empty()) {
    MatrixXd closed = circular_gram();
    // Where a sine or cosine nearly vanishes, its square is the difference of large sums.
    if (closed.diagonal().minCoeff() > smallest_square * static_cast<double>(window->samples)) return closed;
  }
  MatrixXd result = MatrixXd::Zero(even.cols() + odd.cols(), even.cols() + odd.cols());
  result(even_at, even_at) = square_of(even);
  result(odd_at, odd_at) = square_of(odd);
  return result;
}

std::pair<MatrixXd, MatrixXd> FoldedFunctions::timed_moments() const {
  // Time times an even function is odd, and the other way round.
  const MatrixXd timed_even = window->time.asDiagonal() * even, timed_odd = window->time.asDiagonal() * odd;
  MatrixXd first = MatrixXd::Zero(even.cols() + odd.cols(), even.cols() + odd.cols()), second = first;
  const MatrixXd across = product_of(even, timed_odd);  // and its transpose: time stands on either side
  first(even_at, odd_at) = across;
  first(odd_at, even_at) = across.transpose();
  second(even_at, even_at) = square_of(timed_even);
  second(odd_at, odd_at) = square_of(timed_odd);
  return {std::move(first), std::move(second)};
}

MatrixXd FoldedFunctions::project(const MatrixXd& even_part, const MatrixXd& odd_part) const {
  MatrixXd result(even.cols() + odd.cols(), even_part.cols());
  result(even_at, Eigen::all) = product_of(even, even_part);
  result(odd_at, Eigen::all) = product_of(odd, odd_part);
  return result;
}

MatrixXd FoldedFunctions::project_timed(const MatrixXd& even_part, const MatrixXd& odd_part) const {
  return project(window->time.asDiagonal() * odd_part, window->time.asDiagonal() * even_part);
}

void FoldedFunctions::subtract(const MatrixXd& amplitudes, MatrixXd& even_part, MatrixXd& odd_part) const {
  const MatrixXd even_amplitudes = amplitudes(even_at, Eigen::all), odd_amplitudes = amplitudes(odd_at, Eigen::all);
  subtract_product(even, even_amplitudes, even_part);
  subtract_product(odd, odd_amplitudes, odd_part);
}

}  // namespace secular
