#include "measure/data/all_pass_delay.hpp"

#include <algorithm>
#include <cmath>

namespace secular {
namespace {

/// Of an impulse, this is as nothing; it comes to less within so many samples.
constexpr double as_nothing = 1e-8;
constexpr std::size_t longest_response = 512;

}  // namespace

// a_k = (-1)^k binomial(N, k) prod_(n = 0..N) (d + n)/(d + k + n), N: the order, d: the share.
AllPassDelay::AllPassDelay(double share) {
  double binomial = 1;
  for (std::size_t k = 0; k <= order; ++k) {
    double a = binomial;
    for (std::size_t n = 0; n <= order && k > 0; ++n)
      a *= (share + static_cast<double>(n)) / (share + static_cast<double>(k + n));
    coefficients_[k] = a;
    binomial *= -static_cast<double>(order - k) / static_cast<double>(k + 1);
  }
  std::vector<double> impulse(longest_response, 0.0);
  impulse.front() = 1;
  const std::vector<double> response = (*this)(impulse);
  settled_ = response.size();
  double left = 0;
  while (settled_ > 0 && left < as_nothing) left += std::abs(response[--settled_]);
}

std::vector<double> AllPassDelay::operator()(const std::vector<double>& samples) const {
  std::vector<double> result(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t last = std::min(order, i);
    double y = 0;
    for (std::size_t k = 0; k <= last; ++k) y += coefficients_[order - k] * samples[i - k];
    for (std::size_t k = 1; k <= last; ++k) y -= coefficients_[k] * result[i - k];
    result[i] = y;
  }
  return result;
}

}  // namespace secular
