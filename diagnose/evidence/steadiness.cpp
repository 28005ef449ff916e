#include "diagnose/evidence/steadiness.hpp"

#include <algorithm>
#include <set>

#include "diagnose/thresholds.hpp"

namespace secular {

Unsteadiness judge_steadiness(const std::vector<Nonstationarity>& nonstationarity, const Campaign& campaign) {
  const NonstationarityTest test = test_nonstationarity(nonstationarity);
  Unsteadiness unsteady{test.p_value < diagnose_thresholds().unsteady_alarm, test.p_value, test.ratio, ""};
  if (unsteady.detected) unsteady.record = campaign.records[test.record].file;
  return unsteady;
}

std::vector<std::string> leave_out_unsteady(std::vector<Condition>& conditions,
                                            std::vector<Nonstationarity>& nonstationarity,
                                            const Campaign& campaign) {
  std::set<std::size_t> records;
  for (const Nonstationarity& w : nonstationarity)
    if (is_unsteady(w)) records.insert(w.record);
  const auto unsteady = [&](const Condition& c) { return records.contains(c.record); };
  const auto count = std::count_if(conditions.begin(), conditions.end(), unsteady);
  if (count == 0 || 2 * static_cast<std::size_t>(count) > conditions.size()) return {};
  std::erase_if(conditions, unsteady);
  std::erase_if(nonstationarity, [&](const Nonstationarity& w) { return records.contains(w.record); });
  std::vector<std::string> files;
  for (const std::size_t record : records) files.push_back(campaign.records[record].file);
  return files;
}

}  // namespace secular
