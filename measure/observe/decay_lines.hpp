#pragma once

#include <optional>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// Where modes ring in the free decays of a campaign.
struct DecayLines {
  std::size_t records = 0;  ///< decays that were looked at
  /// By mode, rad/s: the strongest line within the search range of the nominal frequency, if one is seen there.
  std::vector<std::optional<double>> at_nominal;
  /// Further lines, the strongest first, that no mode's own line and no combination of those explains.
  std::vector<double> further;
};

/// `nominal`: rad/s, by mode; NaN: none.
DecayLines decay_lines(const Campaign& campaign, const RecordReader& read, const std::vector<double>& nominal,
                       const Window& window);

}  // namespace secular
