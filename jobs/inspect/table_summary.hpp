#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"

namespace secular {

/// What a table of lines holds.
struct TableSummary {
  std::string file;
  std::size_t rows = 0, repeats = 0;  ///< repeats: rows beyond the first with one label
  double lowest_hz = 0, highest_hz = 0, lowest_level = 0, highest_level = 0;
  std::vector<std::string> lines, without_sd;  ///< "tip", "tip@3"
  std::vector<std::string> faults;
};

/// By table, in the order of the campaign.
std::vector<TableSummary> tables_of(const Campaign& campaign);

}  // namespace secular
