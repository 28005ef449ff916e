#include "measure/data/time_span.hpp"

#include <algorithm>
#include <cmath>

namespace secular {
namespace {

// Of a sample: what rounding does to a time that is meant to be one's own.
constexpr double rounding = 1e-6;

}  // namespace

SpanOfSamples samples_within(const TimeSpan& span, double start_s, double sample_rate_hz, std::size_t samples) {
  const auto place = [&](double time) {
    return std::clamp((time - start_s) * sample_rate_hz, -1.0, static_cast<double>(samples));
  };
  const double first = std::max(0.0, std::ceil(place(span.from_s) - rounding));
  const double end = std::min(static_cast<double>(samples), std::floor(place(span.to_s) + rounding) + 1);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(std::max(0.0, end - first))};
}

}  // namespace secular
