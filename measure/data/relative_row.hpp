#pragma once

#include "measure/data/campaign.hpp"
#include "measure/data/line_row.hpp"

namespace secular {

/// The row with the base's acceleration taken out of the responses that are absolute (Channel::frame).
LineRow relative_to_base(const Campaign& campaign, LineRow row);

}  // namespace secular
