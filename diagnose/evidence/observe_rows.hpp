#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/evidence/observe_dwell.hpp"

namespace secular {

/// A row of a table of lines, by its record.
using IndexedRow = std::pair<std::size_t, const LineRow*>;

/// What a dwell's ensembles are: rows that bear one label of a table, or one row alone. Errors are those that the
/// table says; where it does not, `errors_known` is false and the scatter that of the rows (none of one alone).
/// Nothing where no line of the model's is there, or a motion of two independent frequencies would be.
struct RowsDwell {
  Dwell dwell;
  bool errors_known = false;
};
std::optional<RowsDwell> observe_rows(const DwellContext& context, const std::vector<IndexedRow>& rows,
                                      std::vector<std::string>& warnings);

/// Rows of tables among a campaign's records, those of one condition together.
std::vector<std::vector<std::size_t>> row_conditions(const Campaign& campaign, const Window& window);

}  // namespace secular
