#pragma once

#include "measure/observe/mode_lines.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// Where modes ring in the free decays of a campaign; no further line is a combination of the modes' own.
/// `nominal`: rad/s, by mode; NaN: none.
ModeLines decay_lines(const Campaign& campaign, const RecordReader& read, const std::vector<double>& nominal,
                      const Window& window);

}  // namespace secular
