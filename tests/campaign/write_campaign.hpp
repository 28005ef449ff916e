#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "measure/data/campaign_writer.hpp"

namespace secular {

/// Writes a whole campaign: samples[r] belongs to campaign.records[r].
inline void write_campaign(const Campaign& campaign, const std::vector<Record>& samples,
                           const std::filesystem::path& folder) {
  if (samples.size() != campaign.records.size())
    throw std::invalid_argument("write_campaign: as many sample sets as records were expected");
  CampaignWriter writer(folder);
  for (std::size_t r = 0; r < samples.size(); ++r) writer.write(campaign, campaign.records[r], samples[r]);
  writer.finish(campaign);
}

}  // namespace secular
