#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "blind/run_set.hpp"

namespace secular::blind {

/// case_NNNN/left_out: diagnosis/ without the effect that is the truth, and look_alikes.json, a list of the effects
/// of the rest of the catalogue that explain the campaign's data as well.
std::filesystem::path left_out_folder(const std::filesystem::path& place);
std::filesystem::path look_alikes_file(const std::filesystem::path& place);

struct LeaveOutSummary {
  std::size_t campaigns = 0, kept = 0;  ///< with one effect of the catalogue; of these, diagnosed before
  std::vector<FailedCampaign> failed;
};

/// Diagnoses every campaign with one effect of the catalogue as if the catalogue did not hold it. What is complete
/// is kept. Labels stay closed: the effect is what the set's seed draws.
LeaveOutSummary leave_out_of_set(const std::filesystem::path& folder, const RunOptions& options,
                                 const Progress& progress);

}  // namespace secular::blind
