#pragma once

#include <string>

#include "measure/data/campaign.hpp"

namespace secular {

/// campaign.toml of a campaign, one key a line; the same campaign gives the same bytes, and reading restores every
/// number bit by bit.
std::string campaign_text(const Campaign& campaign);

}  // namespace secular
