#include "diagnose/verdict/scattered_inference.hpp"

#include <cmath>

#include "diagnose/thresholds.hpp"
#include "diagnose/verdict/gap_detection.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

/// Searches beside a scatter that is half as large each: the third differs by little.
constexpr int most_rounds = 3;

RowsLeft left_by(const Refit& fit, const Discrepancy& discrepancy) {
  return rows_left(fit.chi_squared, static_cast<double>(discrepancy.freedom() - fit.rank), discrepancy);
}

// Whether an explanation closes as much as a cause has to of what the model as it is leaves beyond noise.
bool leaves_little(const RowsLeft& best, const RowsLeft& null) {
  const auto beyond_noise = [](const RowsLeft& left) { return std::sqrt(left.chi_squared / left.freedom) - 1; };
  const double open = 1 - diagnose_thresholds().most_of_the_gap;
  return beyond_noise(best) < open * beyond_noise(null);
}

}  // namespace

ScatteredInference infer_beside_scatter(Discrepancy& discrepancy, RecordNuisances& of_records,
                                        const InferenceTask& task, bool knows_without) {
  ScatteredInference found;
  for (int round = 1;; ++round) {
    found.inference = infer(discrepancy, task.candidates, task.start, task.own, task.options);
    const auto modes = static_cast<std::size_t>(of_records.frequency_sd.size());
    if (modes == 0) return found;
    const Explanation& null = found.inference.null;
    const RowsLeft of_null = left_by(null.fit, discrepancy);
    const bool explained = !found.inference.explanations.empty() && is_more_than_noise(of_null) &&
                           found.inference.explanations.front().log_evidence > null.log_evidence;
    const Refit& best = explained ? found.inference.explanations.front().fit : null.fit;
    const RowsLeft of_best = left_by(best, discrepancy);
    found.scatter = scatter_about(discrepancy, best.unknowns, modes);
    found.scatter.suffices = !is_more_than_noise(of_best) || (explained && leaves_little(of_best, of_null));
    const VectorXd sd = admitted(found.scatter);
    const bool grows = (sd.array() > of_records.frequency_sd.array()).any();
    if ((!found.scatter.suffices && !grows) || round == most_rounds || is_as_large(sd, of_records.frequency_sd))
      return found;
    if (knows_without && !is_scatter(sd)) {
      found.scatter.suffices = false;
      return found;
    }
    of_records.frequency_sd = sd;
    discrepancy.admit(of_records);
  }
}

}  // namespace secular
