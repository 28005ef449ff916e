#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace secular {

/// From one time of a record's own to another, both included, s.
struct TimeSpan {
  double from_s = -std::numeric_limits<double>::infinity(), to_s = std::numeric_limits<double>::infinity();

  bool all() const { return std::isinf(from_s) && std::isinf(to_s); }
};

struct SpanOfSamples {
  std::size_t first = 0, count = 0;
};

/// The samples in a span of a record whose sample i is at start_s + i / sample_rate_hz.
SpanOfSamples samples_within(const TimeSpan& span, double start_s, double sample_rate_hz, std::size_t samples);

}  // namespace secular
