#include "diagnose/evidence/noise_beside_motion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>

#include "numerics/median.hpp"
#include "numerics/third_differences.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Where noise is read on either side of a mode, in shares of its frequency: beyond the line of a decay, short of
/// its neighbours' harmonics.
constexpr double inner_reach = 0.15, outer_reach = 0.5;

/// Lines that are read on either side, of one record.
constexpr Index most_lines = 64;

/// Of one exponential law, over the median of many; the relative variance of that median is one over their number.
constexpr double exponential_mean_of_median = 1 / std::numbers::ln2, relative_variance_of_median = 2.08;

/// Of a normal law: 95 % lie above its lower end.
constexpr double one_sided_95 = 1.645;

// By a Hann window of the mean square 1, beside which a line of the motion falls off with the sixth power of the
// distance.
std::vector<double> windowed(std::vector<double> values) {
  const auto count = static_cast<double>(values.size());
  const double mean_square = 0.375;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] *=
        std::pow(std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / count), 2) / std::sqrt(mean_square);
  return values;
}

double power_at(const std::vector<double>& values, double radians_a_sample) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    sum += values[i] * std::polar(1.0, -radians_a_sample * static_cast<double>(i));
  return std::norm(sum) / static_cast<double>(values.size());
}

double white_power(const std::vector<double>& values) {
  const std::vector<double> differences = third_differences(values);
  const double squares = std::inner_product(differences.begin(), differences.end(), differences.begin(), 0.0);
  return squares / third_difference_variance / std::max<double>(1, static_cast<double>(differences.size()));
}

// Powers of lines from `low` to `high`, radians a sample, over that of white noise: every second one at most, next
// to each other they are correlated.
void add_powers(const std::vector<double>& values, double low, double high, double white,
                std::vector<double>& powers) {
  const double line = 2 * std::numbers::pi / static_cast<double>(values.size());
  const auto first = static_cast<Index>(std::ceil(low / line)),
             last = static_cast<Index>(std::floor(std::min(high, 0.9 * std::numbers::pi) / line));
  const Index step = std::max<Index>(2, (last - first + most_lines) / most_lines);
  for (Index k = first; k <= last; k += step)
    powers.push_back(power_at(values, static_cast<double>(k) * line) / white);
}

}  // namespace

double noise_beside_motion(std::span<const SampledRest> left, const VectorXd& natural_frequency) {
  std::vector<double> powers;
  for (const SampledRest& channel : left) {
    const double white = white_power(channel.rest);
    if (!(white > 0)) continue;
    const std::vector<double> rest = windowed(channel.rest);
    for (const double w : natural_frequency) {
      const double at = w * channel.sample_s;
      add_powers(rest, (1 - outer_reach) * at, (1 - inner_reach) * at, white, powers);
      add_powers(rest, (1 + inner_reach) * at, (1 + outer_reach) * at, white, powers);
    }
  }
  if (powers.empty()) return 1;
  const double error = std::sqrt(relative_variance_of_median / static_cast<double>(powers.size()));
  return std::max(1.0, exponential_mean_of_median * upper_median(std::move(powers)) * (1 - one_sided_95 * error));
}

}  // namespace secular
