#pragma once

#include <cstddef>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/disturbances/disturbance.hpp"
#include "report/figure.hpp"

namespace secular {

/// What a record looks like: every channel against time, disturbances marked, and its spectrum, tones named.
struct RecordPictures {
  std::size_t record = 0;
  report::Figure history, spectrum;
};

/// Of the first `most_pictured_channels` channels. `found`: the disturbances of this record.
RecordPictures record_pictures(const Campaign& campaign, std::size_t index, const Record& record,
                               const std::vector<Disturbance>& found);

inline constexpr std::size_t most_pictured_channels = 8;

}  // namespace secular
