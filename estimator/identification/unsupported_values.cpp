#include "estimator/identification/unsupported_values.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "estimator/identification/short_list.hpp"

namespace secular {

void take_out_unsupported(Estimate& estimate, const std::string& what) {
  std::set<std::string> with_scatter;
  for (const BlockQuality& block : estimate.blocks)
    if (block.clustered) with_scatter.insert(block.resonance);
  std::vector<std::string> names;
  const auto take_out = [&](EstimatedValue& value) {
    if (!value.value || value.fixed) return;
    const std::string label = label_of(value, estimate);
    if (std::find(names.begin(), names.end(), label) == names.end()) names.push_back(label);
    value.value.reset();
    value.identifiable = value.significant = value.doubtful = false;
    value.from = "not determined: of too few conditions, and " + what;
  };
  if (with_scatter.empty())
    for (EstimatedValue& value : estimate.parameters) take_out(value);
  for (EstimatedValue& value : estimate.lumps)
    if (with_scatter.count(value.resonance) == 0) take_out(value);
  if (!names.empty())
    estimate.warnings.push_back("of too few conditions, and " + what + ": no numbers are given for " +
                                short_list(names));
}

}  // namespace secular
