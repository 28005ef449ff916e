#include "estimator/identification/lateness_sign.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

/// Probability that the lateness of the right minimum looks impossible.
constexpr auto& sign_alarm = estimator_thresholds().sign_alarm;

/// The same for a delay that all records share, of which no order of magnitude is likelier than another.
constexpr auto& common_delay_alarm = estimator_thresholds().common_delay_alarm;

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Square of the standard error of the mean.
double variance_of_mean(const std::vector<double>& values) {
  const double centre = mean(values), count = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += (value - centre) * (value - centre);
  return sum / (count - 1) / count;
}

/// Of a delay that is looked for: beyond, recorders are not late but apart.
constexpr int most_periods = 8;

// Whether records of that variance scatter less than those of another one, by more than chance. The variance is the
// least of those for so many whole periods: one degree of freedom less, and an alarm for each (Bonferroni).
bool scatter_less(double variance, double than, std::size_t records) {
  constexpr std::size_t fewest = 4;
  if (records < fewest || !(than > 0)) return false;
  const double degrees = static_cast<double>(records) - 1;
  return f_upper_tail(than / std::max(variance, 1e-12 * than), degrees, degrees - 1) <
         sign_alarm / (2 * most_periods + 1);
}

// That delays drawn between none and the largest one leave as much room at none.
double probability_of_gap(const std::vector<double>& late) {
  const auto [least, most] = std::minmax_element(late.begin(), late.end());
  if (*least <= 0 && *most >= 0) return 1;
  const double near = std::min(std::abs(*least), std::abs(*most)),
               far = std::max(std::abs(*least), std::abs(*most));
  return std::pow(1 - near / far, static_cast<double>(late.size()) - 1);
}

// The one whose records scatter so much less about one delay than those of all others that they share it (variance
// ratio). Half a period, which the minima differ by, is not the same in records of different frequencies.
std::optional<std::size_t> least_scattered(const std::vector<LatenessOfRecords>& minima) {
  std::vector<double> variance;
  for (const LatenessOfRecords& minimum : minima) variance.push_back(variance_of_mean(minimum.late_s));
  const std::size_t least =
      static_cast<std::size_t>(std::min_element(variance.begin(), variance.end()) - variance.begin());
  for (std::size_t m = 0; m < variance.size(); ++m)
    if (m != least && !scatter_less(variance[least], variance[m], minima.front().late_s.size()))
      return std::nullopt;
  return least;
}

// Welch's test that two samples have one mean.
double probability_of_one_mean(const std::vector<double>& a, const std::vector<double>& b) {
  const double of_a = variance_of_mean(a), of_b = variance_of_mean(b), both = of_a + of_b;
  if (!(both > 0)) return mean(a) == mean(b) ? 1 : 0;
  const double degrees =
      both * both /
      (of_a * of_a / (static_cast<double>(a.size()) - 1) + of_b * of_b / (static_cast<double>(b.size()) - 1));
  return f_upper_tail(std::pow(mean(a) - mean(b), 2) / both, 1, degrees);
}

// The one that is possible while no other is.
std::optional<std::size_t> only_possible(const std::vector<double>& probability) {
  std::optional<std::size_t> only;
  for (std::size_t m = 0; m < probability.size(); ++m) {
    if (probability[m] < sign_alarm) continue;
    if (only) return std::nullopt;
    only = m;
  }
  return only;
}

}  // namespace

LatenessOfRecords lateness_of_records(const std::vector<double>& ahead, const std::vector<double>& frequency) {
  std::complex<double> sum = 0;
  for (const double angle : ahead) sum += std::polar(1.0, -angle);
  const double centre = std::arg(sum);
  LatenessOfRecords result;
  for (std::size_t r = 0; r < ahead.size(); ++r)
    result.late_s.push_back((centre + std::remainder(-ahead[r] - centre, 2 * std::numbers::pi)) / frequency[r]);
  result.period_s = 2 * std::numbers::pi / mean(frequency);
  if (ahead.size() < 2) return result;
  const double as_it_is = variance_of_mean(result.late_s);
  std::vector<double> best = result.late_s;
  for (int periods = -most_periods; periods <= most_periods; ++periods) {
    std::vector<double> late = result.late_s;
    for (std::size_t r = 0; r < late.size(); ++r) late[r] += periods * 2 * std::numbers::pi / frequency[r];
    if (variance_of_mean(late) < variance_of_mean(best)) best = std::move(late);
  }
  if (scatter_less(variance_of_mean(best), as_it_is, ahead.size())) result.late_s = std::move(best);
  return result;
}

std::optional<std::size_t> told_by_own_lateness(const std::vector<LatenessOfRecords>& minima) {
  if (minima.empty() || minima.front().late_s.size() < 2) return std::nullopt;
  if (const std::optional<std::size_t> shared = least_scattered(minima)) return shared;
  std::vector<double> probability;
  for (const LatenessOfRecords& minimum : minima) probability.push_back(probability_of_gap(minimum.late_s));
  if (std::any_of(probability.begin(), probability.end(), [](double p) { return p >= sign_alarm; }))
    return only_possible(probability);
  // A density of 1/delay.
  double all = 0;
  std::vector<double> density;
  for (const LatenessOfRecords& minimum : minima) all += density.emplace_back(1 / std::abs(mean(minimum.late_s)));
  const auto likeliest = std::max_element(density.begin(), density.end());
  if (*likeliest < (1 - common_delay_alarm) * all) return std::nullopt;
  return static_cast<std::size_t>(likeliest - density.begin());
}

std::optional<std::size_t> told_by_other_lateness(const std::vector<LatenessOfRecords>& minima,
                                                  const std::vector<double>& others_s) {
  if (others_s.size() < 2 || minima.empty() || minima.front().late_s.size() < 2) return std::nullopt;
  const double centre = mean(others_s);
  std::vector<double> probability;
  for (const LatenessOfRecords& minimum : minima) {
    std::vector<double> late = minimum.late_s;
    const double periods = std::round((centre - mean(late)) / minimum.period_s) * minimum.period_s;
    for (double& value : late) value += periods;
    probability.push_back(probability_of_one_mean(late, others_s));
  }
  return only_possible(probability);
}

}  // namespace secular
