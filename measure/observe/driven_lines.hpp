#pragma once

#include "measure/observe/mode_lines.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// Where modes answer what drives sweeps and broadband records: peaks of the power of the responses over that of
/// the excitations (docs/inference.md (51)). `nominal`: rad/s, by mode; NaN: none. A mode whose nominal frequency
/// no record drives is not looked for elsewhere, unless it is the only one.
ModeLines driven_lines(const Campaign& campaign, const RecordReader& read, const std::vector<double>& nominal,
                       const Window& window);

}  // namespace secular
