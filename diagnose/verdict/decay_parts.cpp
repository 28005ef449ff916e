#include "diagnose/verdict/decay_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <numeric>

#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"
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

// Powers of lines from `low` to `high`, radians a sample, over that of white noise.
void add_powers(const std::vector<double>& values, double low, double high, double white,
                std::vector<double>& powers) {
  const double line = 2 * std::numbers::pi / static_cast<double>(values.size());
  const auto first = static_cast<Index>(std::ceil(low / line)),
             last = static_cast<Index>(std::floor(std::min(high, 0.9 * std::numbers::pi) / line));
  const Index step = std::max<Index>(1, (last - first + most_lines) / most_lines);
  for (Index k = first; k <= last; k += step)
    powers.push_back(power_at(values, static_cast<double>(k) * line) / white);
}

}  // namespace

double noise_beside_motion(std::span<const LeftInChannel> left, const VectorXd& natural_frequency) {
  std::vector<double> powers;
  for (const LeftInChannel& channel : left) {
    const double white = white_power(channel.rest);
    if (!(white > 0)) continue;
    for (const double w : natural_frequency) {
      const double at = w * channel.sample_s;
      add_powers(channel.rest, (1 - outer_reach) * at, (1 - inner_reach) * at, white, powers);
      add_powers(channel.rest, (1 + inner_reach) * at, (1 + outer_reach) * at, white, powers);
    }
  }
  if (powers.empty()) return 1;
  const double error = std::sqrt(relative_variance_of_median / static_cast<double>(powers.size()));
  return std::max(1.0, exponential_mean_of_median * upper_median(std::move(powers)) * (1 - one_sided_95 * error));
}

double PartsOfDecays::p_value() const {
  double least = 1;
  for (const PartsAgreement* parts : {&folds, &large})
    if (parts->freedom > 0)
      least = std::min(least, chi_squared_upper_tail(parts->chi_squared / noise_beside, parts->freedom));
  return std::min({1.0, 3 * least, 3 * laws.p_value});
}

bool PartsOfDecays::differ() const {
  return p_value() < diagnose_thresholds().gap_alarm;
}

bool PartsOfDecays::only_records_differ() const {
  const double freedom = folds.freedom - large.freedom;
  return of_records && differ() && freedom > 0 &&
         !(chi_squared_upper_tail((folds.chi_squared - large.chi_squared) / noise_beside, freedom) <
           diagnose_thresholds().gap_alarm);
}

std::optional<PartsOfDecays> parts_of_decays(const Comparison& comparison, const Refit& fit,
                                             const Campaign& campaign, std::size_t modes) {
  const std::vector<RowLabel> labels = comparison.discrepancy.labels();
  const bool only_decays = std::all_of(labels.begin(), labels.end(), [&](const RowLabel& label) {
    return campaign.records[label.record].kind == RecordKind::free_decay;
  });
  if (!only_decays || !comparison.segment_evidence) return {};
  PartsOfDecays parts{agreement_of_parts(fit, parts_by_fold(labels)),
                      agreement_of_parts(fit, large_parts(fit, labels))};
  if (!(parts.folds.freedom > 0)) return {};
  parts.noise_beside = noise_beside_motion(comparison.segment_evidence->left(fit.unknowns),
                                           fit.unknowns.head(static_cast<Index>(modes)));
  parts.of_records = labels.front().record != labels.back().record;
  if (modes == 1) parts.laws = unseen_laws(comparison, fit, parts.noise_beside);
  return parts;
}

LackOfFit lack_of_parts(const PartsOfDecays& parts, std::size_t decays) {
  const PartsAgreement& worse = parts.worse();
  LackOfFit test;
  test.name = "numbers of parts of the decays";
  test.conditions = decays;
  test.f = worse.chi_squared / parts.noise_beside / worse.freedom;
  test.misfit_ratio = std::sqrt(test.f);
  test.scatter_ratio = 1;
  test.beyond = worse.chi_squared - worse.freedom;
  test.numerator_df = worse.freedom;
  test.denominator_df = std::numeric_limits<double>::infinity();
  if (parts.only_records_differ()) {
    test.name = "numbers from decay to decay";
  } else if (parts.laws.is_seen()) {
    test.name = "laws of the amplitude";
    test.f = parts.laws.deviations * parts.laws.deviations;
    test.misfit_ratio = parts.laws.deviations;
    test.beyond = test.f - 1;
    test.numerator_df = 1;
  }
  test.p_value = parts.p_value();
  test.significant = parts.differ();
  return test;
}

std::string warning_of(const PartsOfDecays& parts) {
  if (parts.laws.is_seen() && !parts.only_records_differ())
    return fmt::format(
        "a law of the amplitude that the model lacks shows along the decays ({:.2g} standard deviations, p = "
        "{:.2g}); "
        "error bars allow for as much that the numbers have taken up, and `secular diagnose` tells which law it is",
        parts.laws.deviations, parts.p_value());
  return fmt::format(
      "parts of the decays tell numbers that differ by {:.3g} times what noise explains (p = {:.2g}): a law that "
      "the "
      "model lacks, a structure that changes along a decay or from one to the next, or noise at the motion's own "
      "frequencies; error bars allow for as much that the numbers have taken up",
      lack_of_parts(parts, 0).misfit_ratio, parts.p_value());
}

}  // namespace secular
