#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace secular {

/// Where modes are seen in records of one kind.
struct ModeLines {
  std::size_t records = 0;  ///< that were looked at
  /// By mode, rad/s: the strongest line within the search range of the nominal frequency, if one is seen there.
  std::vector<std::optional<double>> at_nominal;
  /// By mode: one that is not seen at its nominal frequency may be one of the further lines.
  std::vector<bool> may_be_further;
  /// Further lines, the strongest first, that no mode's own line explains.
  std::vector<double> further;
};

}  // namespace secular
