#include "measure/data/relative_row.hpp"

#include <cmath>

namespace secular {

LineRow relative_to_base(const Campaign& campaign, LineRow row) {
  const auto base = base_channel(campaign);
  if (!base) return row;
  const LineRow measured = row;
  for (TableLine& line : row.lines) {
    if (campaign.channels[line.channel].frame != Frame::absolute) continue;
    const TableLine* of_base = measured.find(*base, line.number);
    if (!of_base) continue;
    line.amplitude -= of_base->amplitude;
    if (line.sd && of_base->sd) line.sd = std::hypot(*line.sd, *of_base->sd);
  }
  return row;
}

}  // namespace secular
