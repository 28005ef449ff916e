#pragma once

#include <vector>

#include "measure/data/campaign.hpp"

namespace secular {

/// By record: when it began, s, from the mean of all beginnings. A record without started_s begins a second after
/// the one before it.
std::vector<double> record_times(const Campaign& campaign);

}  // namespace secular
