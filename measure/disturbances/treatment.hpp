#pragma once

#include <cstddef>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/watched_reader.hpp"

namespace secular {

/// What mends a record without missing samples: samples that its file holds wrongly, held ones and spikes, are
/// masked; what a converter's steps add to the lines of a dwell is taken out. For WatchedReader.
Treatment treatment_of(const Campaign& campaign, std::size_t index, const Record& record,
                       const std::vector<ChannelValues>& values);

/// The same for each record of a campaign, which must live as long.
WatchedReader::Treat treatments_of(const Campaign& campaign);

}  // namespace secular
