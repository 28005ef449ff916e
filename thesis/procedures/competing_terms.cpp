#include "thesis/procedures/competing_terms.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "estimator/identification/estimate.hpp"

namespace secular {

std::vector<CompetingTerm> compare_terms(const ObservationSet& set, const std::string& coordinate_unit,
                                         const std::vector<std::string>& excitation_units,
                                         const std::vector<std::string>& names) {
  if (names.size() < 2) throw std::invalid_argument("a comparison needs two or more terms");
  std::vector<CompetingTerm> result;
  for (const std::string& name : names) {
    EstimateOptions options;
    for (const std::string& other : names)
      if (other != name) options.fixed[other] = 0;
    const Estimate fit = estimate(set, coordinate_unit, excitation_units, options);
    double squares = 0, rows = 0;
    for (std::size_t b = 0; b < fit.blocks.size(); ++b) {
      const BlockQuality& block = fit.blocks[b];
      if (block.name.rfind("modulation", 0) != 0) continue;
      squares += block.normalised_residual * block.normalised_residual * static_cast<double>(block.equations);
      rows += static_cast<double>(block.equations);
    }
    result.push_back({name, std::sqrt(squares / std::max(1.0, rows))});
  }
  std::stable_sort(result.begin(), result.end(), [](const CompetingTerm& a, const CompetingTerm& b) {
    return a.normalised_residual < b.normalised_residual;
  });
  return result;
}

}  // namespace secular
