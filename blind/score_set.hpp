#pragma once

#include <filesystem>

#include "blind/score.hpp"

namespace secular::blind {

/// Opens the labels of a set and compares them with case_NNNN/diagnosis/diagnosis.json of every campaign. Throws
/// InputError where the labels are not the sealed ones.
Score score_set(const std::filesystem::path& folder);

/// Writes PAGE/score.md, PAGE/score.json and PAGE/calibration.svg.
void write_score(const Score& score, const std::string& set_name, const std::filesystem::path& page);

/// "short set of 60 campaigns, seed 1"
std::string name_of_set(const std::filesystem::path& folder);

}  // namespace secular::blind
