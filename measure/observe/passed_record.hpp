#pragma once

#include "measure/data/campaign.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// A record as the window's band leaves it, every channel through the same filter (band_pass), shorter by its reach
/// at both ends; as it is without a band. Free decays and impacts begin where the structure swings freely (the
/// release is looked for within the window), since the filter would carry what was before into the decay.
Record passed_record(const Campaign& campaign, std::size_t record, Record samples, const Window& window);

}  // namespace secular
