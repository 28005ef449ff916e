#pragma once

#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/line_row.hpp"

namespace secular {

/// A table as a campaign keeps it: names and columns, f in Hz, every line c.re, c.im and c.sd (where one row has
/// it).
struct WrittenTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
};
WrittenTable written_table(const std::vector<LineRow>& rows, const std::vector<Channel>& channels);

}  // namespace secular
