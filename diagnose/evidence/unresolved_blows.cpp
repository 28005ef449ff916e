#include "diagnose/evidence/unresolved_blows.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <set>
#include <vector>

#include "diagnose/thresholds.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::RowVectorXd;

/// A blow lasts while it is more than this share of its peak and than so many standard deviations of the rest.
constexpr auto& drives_from = diagnose_thresholds().drives_from;
constexpr auto& above_rest = diagnose_thresholds().above_rest;

/// Of what a sum over every second sample is off, next to the sum over all: signals with corners, whose spectrum
/// falls with the square of the frequency.
constexpr double share_at_all_samples = 0.25;

// About the median, since a blow is short.
RowVectorXd about_rest(const Segment& segment, Index excitation) {
  RowVectorXd samples = segment.excitation.row(excitation)(Eigen::seq(0, Eigen::last, 2));
  samples.array() -= upper_median(std::vector<double>(samples.begin(), samples.end()));
  return samples;
}

// Nothing where it does not begin and end within the samples, or is no blow, that lasts as long as all else.
struct Blow {
  Index first = 0, count = 0;
};

// From the first to the last sample of the blow.
Blow blow_itself(const RowVectorXd& samples) {
  const RowVectorXd size = samples.cwiseAbs();
  const double rest = sd_of_median * upper_median(std::vector<double>(size.begin(), size.end()));
  const double least = std::max(drives_from * size.maxCoeff(), above_rest * rest);
  Index first = 0, end = samples.size();
  while (first < end && !(size(first) > least)) ++first;
  while (end > first && !(size(end - 1) > least)) --end;
  const Index length = end - first;
  if (length == 0 || first == 0 || end == samples.size() || 2 * length > samples.size()) return {};
  return {first, length};
}

// And as many samples again on both sides.
Blow blow_in(const RowVectorXd& samples) {
  const Blow blow = blow_itself(samples);
  const Index begin = std::max<Index>(0, blow.first - blow.count);
  return {begin, std::min<Index>(samples.size(), blow.first + 2 * blow.count) - begin};
}

// Of the segments of one record, that in which this excitation is largest.
const Segment& struck(const std::vector<const Segment*>& of_record, Index excitation) {
  const auto peak = [&](const Segment* s) { return s->excitation.row(excitation).cwiseAbs().maxCoeff(); };
  return **std::max_element(of_record.begin(), of_record.end(),
                            [&](const Segment* a, const Segment* b) { return peak(a) < peak(b); });
}

}  // namespace

std::vector<Index> samples_of_blow(const Segment& segment) {
  std::set<Index> samples;
  for (Index j = 0; j < segment.excitation.rows(); ++j) {
    const Blow blow = blow_itself(about_rest(segment, j));
    for (Index i = -1; blow.count > 0 && i <= blow.count; ++i) samples.insert(blow.first + i);
  }
  return {samples.begin(), samples.end()};
}

double unresolved_share(const std::vector<const Segment*>& segments, double frequency) {
  std::map<std::size_t, std::vector<const Segment*>> records;
  for (const Segment* s : segments) records[s->record].push_back(s);
  double squares = 0, blows = 0;
  for (const auto& [record, of_record] : records)
    for (Index j = 0; j < of_record.front()->excitation.rows(); ++j) {
      const Segment& s = struck(of_record, j);
      const RowVectorXd samples = about_rest(s, j);
      const Blow blow = blow_in(samples);
      if (blow.count == 0) continue;
      std::complex<double> all = 0, alternating = 0;
      for (Index i = blow.first; i < blow.first + blow.count; ++i) {
        const std::complex<double> part =
            samples(i) * std::polar(1.0, -frequency * s.sample_s * static_cast<double>(i));
        all += part;
        alternating += i % 2 == 0 ? part : -part;
      }
      const double share = share_at_all_samples * std::abs(alternating) / std::abs(all);
      squares += std::isfinite(share) ? std::min(1.0, share * share) : 1;
      blows += 1;
    }
  return blows > 0 ? std::sqrt(squares / blows) : 0;
}

}  // namespace secular
