#include "measure/data/false_alarm.hpp"

#include "measure/thresholds.hpp"

namespace secular {

double false_alarm_of_channel(const Campaign& campaign) {
  return measure_thresholds().disturbance_false_alarm /
         static_cast<double>(campaign.records.size() * campaign.channels.size());
}

}  // namespace secular
