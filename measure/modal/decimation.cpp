#include "measure/modal/decimation.hpp"

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

Index decimation_factor(double sample_rate_hz, double highest_hz) {
  return highest_hz > 0 ? std::max<Index>(1, static_cast<Index>(0.4 * sample_rate_hz / highest_hz)) : 1;
}

namespace {

/// Kaiser: 80 dB; the transition takes 20 % of the new half rate, centred at 90 % of it.
constexpr double decimation_attenuation = 80;

Index half_length_of(Index factor) {
  const double transition = 0.2 * std::numbers::pi / static_cast<double>(factor);
  return static_cast<Index>(std::ceil((decimation_attenuation - 8) / (2.285 * transition) / 2));
}

}  // namespace

Index fewest_to_decimate(Index factor) {
  return factor > 1 ? 2 * half_length_of(factor) + 1 : 0;
}

Decimated decimate(const Eigen::Ref<const Eigen::MatrixXd>& samples, double sample_rate_hz, Index factor) {
  if (factor < 1) throw std::invalid_argument("decimate: the factor is less than one");
  Decimated result{samples, sample_rate_hz, factor, 0, 0};
  if (factor == 1) return result;
  constexpr double beta = 0.1102 * (decimation_attenuation - 8.7);
  const Index half = half_length_of(factor);
  const double cutoff = 0.9 * std::numbers::pi / static_cast<double>(factor);
  if (samples.rows() < 2 * half + 1) throw std::invalid_argument("decimate: the record is shorter than the filter");
  VectorXd filter(2 * half + 1);
  for (Index i = -half; i <= half; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(half), x = cutoff * static_cast<double>(i);
    const double ideal =
        i == 0 ? cutoff / std::numbers::pi : std::sin(x) / (std::numbers::pi * static_cast<double>(i));
    filter(i + half) = ideal * boost::math::cyl_bessel_i(0, beta * std::sqrt(std::max(0.0, 1 - share * share)));
  }
  filter /= filter.sum();
  const Index rows = (samples.rows() - filter.size()) / factor + 1;
  result.first = half;
  result.half_length = half;
  result.sample_rate_hz = sample_rate_hz / static_cast<double>(factor);
  result.samples.resize(rows, samples.cols());
  for (Index i = 0; i < rows; ++i)
    result.samples.row(i) = filter.transpose() * samples.middleRows(i * factor, filter.size());
  return result;
}

}  // namespace secular
