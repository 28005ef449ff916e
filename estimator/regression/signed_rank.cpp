#include "estimator/regression/signed_rank.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "numerics/distribution.hpp"

namespace secular {
namespace {

constexpr std::size_t largest_exact = 60;

}  // namespace

double signed_rank_p_value(std::span<const double> differences) {
  std::vector<double> kept;
  for (const double d : differences) {
    if (std::isnan(d)) throw std::invalid_argument("a difference that is not a number");
    if (d != 0) kept.push_back(d);
  }
  const std::size_t n = kept.size();
  if (n == 0) return 1;
  std::sort(kept.begin(), kept.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  // Twice the ranks, so that shared ones are whole numbers.
  std::vector<std::size_t> rank(n);
  std::size_t positive = 0;
  double variance = 0;
  for (std::size_t begin = 0; begin < n;) {
    std::size_t end = begin + 1;
    while (end < n && std::abs(kept[end]) == std::abs(kept[begin])) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      rank[i] = begin + 1 + end;
      if (kept[i] > 0) positive += rank[i];
      variance += 0.25 * static_cast<double>(rank[i] * rank[i]);
    }
    begin = end;
  }
  if (n <= largest_exact) {
    // Distribution of the sum, every sign equally likely.
    std::vector<double> probability(n * (n + 1) + 1, 0.0);
    probability[0] = 1;
    std::size_t reach = 0;
    for (const std::size_t r : rank) {
      for (std::size_t sum = reach + 1; sum-- > 0;) {
        probability[sum] /= 2;
        probability[sum + r] += probability[sum];
      }
      reach += r;
    }
    double tail = 0;
    for (std::size_t sum = reach + 1; sum-- > positive;) tail += probability[sum];
    return std::min(1.0, tail);
  }
  const double mean = 0.5 * static_cast<double>(n * (n + 1));
  const double z = (static_cast<double>(positive) - mean - 1) / std::sqrt(variance);
  return normal_upper_tail(z);
}

}  // namespace secular
