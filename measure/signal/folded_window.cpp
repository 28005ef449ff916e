#include "measure/signal/folded_window.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "measure/signal/narrow_products.hpp"

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

FoldedFunctions::FoldedFunctions(std::span<const Pole> poles, const FoldedWindow& of_window)
    : closed(circular_moments(poles, of_window)), window(&of_window) {
  const MatrixXd functions = pole_functions(poles, window->rows, window->rate, window->time(0) * window->half);
  // The sign (-1)^l counts from the first sample of the whole window; over an even number of samples it is odd.
  const double sign = window->first % 2 == 0 ? 1 : -1;
  std::vector<double> scale;
  Index at = 0;
  for (const Pole& pole : poles) {
    const Index size = function_count(pole);
    const bool nyquist = pole.family == PoleFamily::nyquist_hyperbolic;
    for (Index i = 0; i < size; ++i, ++at) {
      const bool sine = i == 1 || i == 2;
      const bool is_odd = nyquist && window->samples % 2 == 0 ? !sine : sine;
      (is_odd ? odd_at : even_at).push_back(at);
      scale.push_back(nyquist ? sign : 1);
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

MatrixXd FoldedFunctions::gram() const {
  if (closed) return closed->zeroth;
  MatrixXd result = MatrixXd::Zero(even.cols() + odd.cols(), even.cols() + odd.cols());
  result(even_at, even_at) = square_of(even);
  result(odd_at, odd_at) = square_of(odd);
  return result;
}

TimedMoments FoldedFunctions::timed_moments() const {
  if (closed) return {MatrixXd(), closed->first, closed->second};
  // Time times an even function is odd, and the other way round.
  const MatrixXd timed_even = window->time.asDiagonal() * even, timed_odd = window->time.asDiagonal() * odd;
  MatrixXd first = MatrixXd::Zero(even.cols() + odd.cols(), even.cols() + odd.cols()), second = first;
  const MatrixXd across = transposed_product(even, timed_odd);  // and its transpose: time stands on either side
  first(even_at, odd_at) = across;
  first(odd_at, even_at) = across.transpose();
  second(even_at, even_at) = square_of(timed_even);
  second(odd_at, odd_at) = square_of(timed_odd);
  return {MatrixXd(), std::move(first), std::move(second)};
}

MatrixXd FoldedFunctions::project(const MatrixXd& even_part, const MatrixXd& odd_part) const {
  MatrixXd result(even.cols() + odd.cols(), even_part.cols());
  result(even_at, Eigen::all) = transposed_product(even, even_part);
  result(odd_at, Eigen::all) = transposed_product(odd, odd_part);
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
