#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "measure/data/campaign.hpp"
#include "motion/simulate/virtual_test.hpp"

namespace secular {

/// A simulated campaign in memory: `samples` by Campaign::records.
struct SimulatedCampaign {
  Campaign campaign;
  std::vector<Record> samples;
};

inline SimulatedCampaign run_virtual_test(const Experiment& experiment, const CompiledModel& model,
                                          std::uint64_t seed, unsigned threads) {
  std::mutex guard;
  std::map<std::string, Record> finished;
  SimulatedCampaign result;
  result.campaign = run_virtual_test(experiment, model, seed, threads,
                                     [&](const Campaign&, const RecordEntry& entry, Record&& record) {
                                       const std::lock_guard lock(guard);
                                       finished[entry.file] = std::move(record);
                                     },
                                     {});
  for (const RecordEntry& entry : result.campaign.records)
    result.samples.push_back(std::move(finished.at(entry.file)));
  return result;
}

}  // namespace secular
