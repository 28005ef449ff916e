#pragma once

#include <complex>
#include <numbers>
#include <vector>

#include "motion/simulate/anti_alias_filter.hpp"

namespace secular::testing_support {

/// Steady response of a filter, from what it makes of one sample of 1 after zeros: sum over n of h[n] z^n,
/// z = exp(-i 2 pi f/fs). `length` samples must be long enough for h to die out.
class FilterResponse {
 public:
  FilterResponse(FilterCascade filter, double sample_rate_hz, int length = 16384) : rate_(sample_rate_hz) {
    for (int n = 0; n < length; ++n) impulse_response_.push_back(filter(n == 0 ? 1 : 0));
  }
  std::complex<double> operator()(double hz) const {
    const std::complex<double> z = std::polar(1.0, -2 * std::numbers::pi * hz / rate_);
    std::complex<double> sum = 0;
    for (auto h = impulse_response_.rbegin(); h != impulse_response_.rend(); ++h) sum = *h + z * sum;
    return sum;
  }

 private:
  double rate_;
  std::vector<double> impulse_response_;
};

}  // namespace secular::testing_support
