#include "measure/data/campaign_clock.hpp"

#include <numeric>

namespace secular {

std::vector<double> record_times(const Campaign& campaign) {
  std::vector<double> times;
  double clock = 0;
  for (const RecordEntry& entry : campaign.records) {
    times.push_back(entry.started_s.value_or(clock));
    clock = times.back() + 1;
  }
  const double mean = std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
  for (double& time : times) time -= mean;
  return times;
}

}  // namespace secular
