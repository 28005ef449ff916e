#include "diagnose/verdict/decay_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {

double PartsOfDecays::p_value() const {
  return std::min({1.0, 3 * folds.p_value, 3 * large.p_value, 3 * laws.p_value});
}

bool PartsOfDecays::differ() const {
  return p_value() < diagnose_thresholds().gap_alarm;
}

bool PartsOfDecays::only_records_differ() const {
  const double freedom = folds.freedom - large.freedom;
  return of_records && differ() && freedom > 0 &&
         !(chi_squared_upper_tail(folds.chi_squared - large.chi_squared, freedom) <
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
  parts.of_records = labels.front().record != labels.back().record;
  if (modes == 1) parts.laws = unseen_laws(comparison, fit);
  return parts;
}

LackOfFit lack_of_parts(const PartsOfDecays& parts, std::size_t decays) {
  const PartsAgreement& worse = parts.worse();
  LackOfFit test;
  test.name = "numbers of parts of the decays";
  test.conditions = decays;
  test.f = worse.chi_squared / worse.freedom;
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
