#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "blind/run_set.hpp"

namespace secular::blind {

/// Dwells that a follow-up runs: the one that a diagnosis proposed, and one taken at random to compare with.
inline constexpr const char* follow_ups[] = {"proposed", "random"};

/// case_NNNN/next/proposed, case_NNNN/next/random: campaign/ and diagnosis/ of a follow-up.
std::filesystem::path follow_up_folder(const std::filesystem::path& place, const std::string& which);

struct FollowUpSummary {
  std::size_t sets = 0;      ///< campaigns whose verdict left a set
  std::size_t proposed = 0;  ///< of these, with a dwell proposed
  std::vector<FailedCampaign> failed;
};

/// Runs the dwell that each diagnosis with a set proposes on the campaign's structure, adds it to the records and
/// diagnoses again; the same with a dwell at the level of a random one of the campaign times 0.5 to 1.5 and at the
/// frequency of another. What is complete is kept. Labels stay closed: a structure is drawn anew from the set's
/// seed.
FollowUpSummary follow_up_set(const std::filesystem::path& folder, const RunOptions& options,
                              const Progress& progress);

}  // namespace secular::blind
