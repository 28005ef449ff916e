#include "diagnose/inference/in_step.hpp"

#include <algorithm>
#include <utility>

#include "diagnose/inference/screening.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

/// That chance is taken for a law: in doubt it is one.
constexpr double law_alarm = 0.05;

}  // namespace

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

// With S left along K changes and g of it explained by a candidate of m unknowns, (g/m)/((S - g)/(K - m)) follows
// the F law if the candidate has nothing to do with it; so many are tried (Bonferroni). Saturation, which has no
// slope where it begins, is not among them.
bool is_a_law(const InStep& left, Discrepancy& discrepancy, const std::vector<Candidate>& candidates,
              unsigned threads) {
  Refit along = left.fit;
  along.rows = left.scatter.along;
  const double squares = along.rows.squaredNorm();
  KnownScales scales(along.unknowns.size());
  const std::vector<Screening> screened = screen_all(discrepancy, along, candidates, scales, threads);
  double least = 1;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (candidates[c].least_strength > 0) continue;
    const auto unknowns = static_cast<double>(candidates[c].strengths.size() + candidates[c].shapes.size());
    const double rest = squares - screened[c].gain, freedom = left.scatter.freedom - unknowns;
    if (!(freedom >= 1)) continue;
    least = std::min(
        least, rest > 0 ? f_upper_tail(screened[c].gain / unknowns / (rest / freedom), unknowns, freedom) : 0.0);
  }
  return least * static_cast<double>(candidates.size()) < law_alarm;
}

}  // namespace secular
