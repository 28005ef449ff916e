#include "diagnose/inference/in_step.hpp"

#include <algorithm>
#include <utility>

#include "diagnose/inference/screening.hpp"
#include "numerics/distribution.hpp"

namespace secular {

InStep in_step(Discrepancy& discrepancy, Refit fit, std::size_t modes, unsigned threads) {
  discrepancy.admit_scatter(0, modes);
  discrepancy.freeze(fit.unknowns);
  fit.rows = discrepancy(fit.unknowns);
  fit.jacobian = discrepancy.slopes(fit.unknowns, fit.free, fit.scale, threads);
  FrequencyScatter scatter =
      frequency_scatter(fit.rows, fit.jacobian, discrepancy.frequency_changes(fit.unknowns, modes),
                        discrepancy.labels(), static_cast<double>(discrepancy.freedom()));
  return {std::move(fit), std::move(scatter)};
}

// With S left along K changes and g of it explained by a candidate of m strengths, (g/m)/((S - g)/(K - m)) follows
// the F law if the candidate has nothing to do with it; so many are tried (Bonferroni).
bool is_a_law(const InStep& left, Discrepancy& discrepancy, const std::vector<Candidate>& candidates,
              unsigned threads) {
  KnownScales scales(left.fit.unknowns.size());
  const std::vector<Screening> screened = screen_all(discrepancy, left.fit, candidates, scales, threads);
  double least = 1;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto strengths = static_cast<double>(candidates[c].strengths.size());
    const double rest = left.scatter.squares - screened[c].gain, freedom = left.scatter.freedom - strengths;
    if (!(freedom >= 1)) continue;
    least = std::min(
        least, rest > 0 ? f_upper_tail(screened[c].gain / strengths / (rest / freedom), strengths, freedom) : 0.0);
  }
  return least * static_cast<double>(candidates.size()) < scatter_alarm;
}

}  // namespace secular
