#include "jobs/predict/largest_response.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "jobs/predict/uncertain_text.hpp"

namespace secular {
namespace {

/// Share of an amplitude within which others are the same: points of a curve are found to some 1e-10.
constexpr double equal_to_rounding = 1e-9;
/// Of eigenvalues over the largest one: real parts that rounding leaves of zero at a special point.
constexpr double neutral = 1e-6;

double amplitude_of(const ResponsePoint& point, std::size_t mode) {
  return 2 * std::abs(point.modes.amplitude[mode]);
}

// Whether stable responses end at a special point: nothing grows there.
bool borders_stable_ones(const ResponsePoint& special) {
  double largest = 0, growth = 0;
  for (const std::complex<double>& value : special.eigenvalues) {
    largest = std::max(largest, std::abs(value));
    growth = std::max(growth, value.real());
  }
  return growth <= neutral * largest;
}

LargestResponse at_point(const ResponseBranch& branch, std::size_t i, std::size_t mode) {
  const ResponsePoint& point = branch.points[i];
  LargestResponse result{mode, LargestAt::search_end, point.parameter, amplitude_of(point, mode), {}, {}};
  const bool ends_range = (i == 0 && branch.first_end.status == TraceStatus::parameter_bound) ||
                          (i + 1 == branch.points.size() && branch.last_end.status == TraceStatus::parameter_bound);
  const auto peak = std::find_if(point.peaks.begin(), point.peaks.end(),
                                 [&](const ResponsePeak& one) { return one.mode == mode; });
  if (peak != point.peaks.end()) {
    result.kind = LargestAt::peak;
    result.parameter_sd = peak->place_sd;
  } else if (ends_range) {
    result.kind = LargestAt::range_end;
  }
  if (result.kind != LargestAt::search_end) result.amplitude_sd = amplitude_sd(point, mode);
  // (R9) moves the place by way of the amplitude: where first order says nothing of that, it says nothing of it.
  if (!first_order_holds(point, mode)) result.parameter_sd.reset();
  return result;
}

// Beyond rounding; of two that are the same, one of which a reason is known why nothing is larger there: on a flat
// curve, and beside a peak, points of no meaning are as large.
bool is_larger(const LargestResponse& one, const LargestResponse& other) {
  if (one.amplitude > (1 + equal_to_rounding) * other.amplitude) return true;
  return one.amplitude >= (1 - equal_to_rounding) * other.amplitude && one.kind != LargestAt::search_end &&
         other.kind == LargestAt::search_end;
}

}  // namespace

std::vector<LargestResponse> largest_responses(const Prediction& prediction) {
  std::vector<LargestResponse> all;
  for (std::size_t mode = 0; mode < prediction.model->modes(); ++mode) {
    if (prediction.resonance->mode_at_rest[mode]) continue;
    LargestResponse largest;
    for (const ResponseBranch& branch : prediction.diagram.branches) {
      for (std::size_t i = 0; i < branch.points.size(); ++i) {
        const ResponsePoint& point = branch.points[i];
        if (point.unstable > 0 || point.at_rest || point.outside) continue;
        if (amplitude_of(point, mode) < (1 - equal_to_rounding) * largest.amplitude) continue;
        if (const LargestResponse here = at_point(branch, i, mode); is_larger(here, largest)) largest = here;
      }
      for (const ResponseSpecial& special : branch.special) {
        const ResponsePoint& point = special.at;
        if (point.at_rest || point.outside || !borders_stable_ones(point)) continue;
        const LargestResponse here{mode, LargestAt::stability_end, point.parameter, amplitude_of(point, mode), {},
                                   {}};
        if (is_larger(here, largest)) largest = here;
      }
    }
    if (largest.amplitude > 0) all.push_back(largest);
  }
  return all;
}

}  // namespace secular
