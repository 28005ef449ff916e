#include "diagnose/evidence/unresolved_blows.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>

namespace secular {
namespace {

using Eigen::Index;

/// A blow lasts while it is more than this share of its peak, or than so many standard deviations of noise.
constexpr double begins_at = 0.01, above_noise = 5;

/// Of what a sum over every second sample is off, next to the sum over all: signals with corners, whose spectrum
/// falls with the square of the frequency.
constexpr double share_at_all_samples = 0.25;

// From the first to the last sample of the blow, and as many again on both sides. Empty: there is none.
struct Blow {
  Index first = 0, count = 0;
};

Blow blow_in(const Eigen::RowVectorXd& samples, double noise) {
  const double least = std::max(begins_at * samples.cwiseAbs().maxCoeff(), above_noise * noise);
  Index first = 0, end = samples.size();
  while (first < end && !(std::abs(samples(first)) > least)) ++first;
  while (end > first && !(std::abs(samples(end - 1)) > least)) --end;
  const Index length = end - first, begin = std::max<Index>(0, first - length);
  return {begin, length == 0 ? 0 : std::min<Index>(samples.size(), end + length) - begin};
}

}  // namespace

double unresolved_share(const std::vector<const Segment*>& segments, double frequency) {
  double squares = 0, blows = 0;
  for (const Segment* s : segments)
    for (Index j = 0; j < s->excitation.rows(); ++j) {
      const Eigen::RowVectorXd samples = s->excitation.row(j)(Eigen::seq(0, Eigen::last, 2));
      const Blow blow = blow_in(samples, s->excitation_noise_sd(j));
      // One that does not end within the segment is none.
      if (blow.count == 0 || blow.count == samples.size()) continue;
      std::complex<double> all = 0, alternating = 0;
      for (Index i = blow.first; i < blow.first + blow.count; ++i) {
        const std::complex<double> part =
            samples(i) * std::polar(1.0, -frequency * s->sample_s * static_cast<double>(i));
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
