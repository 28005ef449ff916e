#pragma once

#include "measure/data/campaign.hpp"

namespace secular {

/// False alarm of one search on one channel of a record, of that of a campaign (disturbance_false_alarm).
double false_alarm_of_channel(const Campaign& campaign);

}  // namespace secular
