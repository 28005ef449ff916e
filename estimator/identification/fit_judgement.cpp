// Whether the model holds as well as the measurement repeats.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "estimator/identification/estimation.hpp"
#include "estimator/identification/lack_of_fit.hpp"
#include "estimator/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {

using Eigen::Index;

namespace {

/// Probability that lumps of a model that holds contradict one another.
constexpr auto& contradiction_alarm = estimator_thresholds().contradiction_alarm;

// What a lack of fit is judged by, in words.
const char* measure_of_fit(const CaseFit& fit, const std::vector<LackOfFit>& tests) {
  if (fit.set->resonance->excited) return "as well as repeats of one condition agree";
  const bool too_short =
      std::all_of(tests.begin(), tests.end(), [](const LackOfFit& t) { return !std::isfinite(t.denominator_df); });
  return too_short ? "to three times the measured noise (decays are too short to determine their scatter)"
                   : "as well as windows of a decay that follow one another agree";
}

}  // namespace

void test_fit(Estimation& e) {
  for (std::size_t s = 0; s < e.fits.size(); ++s) {
    const CaseFit& fit = e.fits[s];
    CaseLackOfFit tests{std::string(fit.set->resonance->name), lack_of_fit(fit, e.truncation_unknown)};
    e.hidden[s] = hidden_misfit(fit, tests.equations);
    std::string worst;
    double largest = 0;
    for (const LackOfFit& test : tests.equations) {
      if (!test.significant) continue;
      largest = std::max(largest, test.misfit_ratio);
      worst += fmt::format("{}{} ({:.1f} times)", worst.empty() ? "" : "; ", test.name, test.misfit_ratio);
    }
    if (!worst.empty())
      e.result.warnings.push_back(
          fmt::format("case {}: the model does not fit {}: {}. It lacks something there, and its "
                      "parameters have absorbed part of it: error bars are widened by as much again as is seen to "
                      "be wrong",
                      tests.resonance, measure_of_fit(fit, tests.equations), worst));
    if (!tests.equations.empty()) e.result.lack_of_fit.push_back(std::move(tests));
  }
}

double misfit_of_parameter(const Estimation& e, Index p) {
  double square = 0;
  for (std::size_t s = 0; s < e.fits.size(); ++s)
    if (e.hidden[s].cols() > 0 && e.shared.slope[s].rows() > p)
      square += (e.shared.slope[s].row(p) * e.lump_estimates[s].combination * e.hidden[s](e.used[s], Eigen::all))
                    .squaredNorm();
  if (e.result.consistency.significant)
    square += e.shared.plain_covariance(p, p) *
              std::max(0.0, e.result.consistency.chi_squared - e.result.consistency.degrees_of_freedom);
  return std::sqrt(square);
}

void test_consistency(Estimation& e) {
  LumpConsistency& c = e.result.consistency;
  c.chi_squared = e.shared.chi_squared;
  c.degrees_of_freedom = static_cast<double>(e.shared.surplus);
  if (c.degrees_of_freedom < 1 || !std::isfinite(c.chi_squared)) return;
  c.p_value = chi_squared_upper_tail(c.chi_squared, c.degrees_of_freedom);
  c.significant = c.p_value < contradiction_alarm;
  if (c.significant)
    e.result.warnings.push_back(fmt::format(
        "the lumps contradict one another: no values of the parameters give all of them (chi-squared {:.0f} on "
        "{:.0f} degrees of freedom); the parameters' error bars are widened by as much",
        c.chi_squared, c.degrees_of_freedom));
}

}  // namespace secular
