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

// That delays drawn between none and the largest one leave as much room at none.
double probability_of_gap(const std::vector<double>& late) {
  const auto [least, most] = std::minmax_element(late.begin(), late.end());
  if (*least <= 0 && *most >= 0) return 1;
  const double near = std::min(std::abs(*least), std::abs(*most)),
               far = std::max(std::abs(*least), std::abs(*most));
  return std::pow(1 - near / far, static_cast<double>(late.size()) - 1);
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
  return result;
}

std::optional<std::size_t> told_by_own_lateness(const std::vector<LatenessOfRecords>& minima) {
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
