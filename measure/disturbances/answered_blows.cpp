#include "measure/disturbances/answered_blows.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Samples before that predict one: of eight modes and an offset.
constexpr Index coefficients = 17;
/// A motion that begins at a sample shows at it (an acceleration) or behind it (a displacement).
constexpr std::size_t answer = 3;

// Whether samples that predict number i, or it, lie at a place or within the answer behind it.
std::vector<bool> beside(std::size_t samples, const std::vector<std::size_t>& places) {
  std::vector<bool> result(samples, false);
  for (const std::size_t place : places) {
    const std::size_t last = std::min(samples, place + answer + static_cast<std::size_t>(coefficients));
    std::fill(result.begin() + static_cast<std::ptrdiff_t>(std::min(place, last)),
              result.begin() + static_cast<std::ptrdiff_t>(last), true);
  }
  return result;
}

}  // namespace

std::vector<std::size_t> answered_blows(std::span<const double> response, const std::vector<std::size_t>& places) {
  const auto samples = static_cast<Index>(response.size());
  std::vector<std::size_t> answered;
  if (samples < 8 * coefficients) return answered;
  const Eigen::Map<const VectorXd> x(response.data(), samples);
  const VectorXd motion = x.array() - x.mean();
  const std::vector<bool> excluded = beside(response.size(), places);
  MatrixXd gram = MatrixXd::Zero(coefficients, coefficients);
  VectorXd product = VectorXd::Zero(coefficients);
  for (Index i = coefficients; i < samples; ++i) {
    if (excluded[static_cast<std::size_t>(i)]) continue;
    const auto before = motion.segment(i - coefficients, coefficients);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(before);
    product += motion(i) * before;
  }
  const MatrixXd whole = gram.selfadjointView<Eigen::Lower>();
  const VectorXd weights = whole.completeOrthogonalDecomposition().solve(product);
  double largest = 0;
  VectorXd error = VectorXd::Zero(samples);
  for (Index i = coefficients; i < samples; ++i) {
    error(i) = std::abs(motion(i) - weights.dot(motion.segment(i - coefficients, coefficients)));
    if (!excluded[static_cast<std::size_t>(i)]) largest = std::max(largest, error(i));
  }
  for (const std::size_t place : places) {
    const auto first = static_cast<Index>(place);
    const Index count = std::min(static_cast<Index>(answer), samples - first);
    if (count > 0 && error.segment(first, count).maxCoeff() > largest) answered.push_back(place);
  }
  return answered;
}

}  // namespace secular
