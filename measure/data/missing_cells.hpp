#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/data/time_axis.hpp"

namespace secular {

/// By channel, the places of samples that are no finite numbers, rising.
using MissingCells = std::vector<std::vector<std::size_t>>;

MissingCells missing_cells(const std::vector<std::vector<double>>& channels);

/// Puts in what fill_gaps finds for these samples; where it finds nothing they stay. Returns those that were
/// filled.
MissingCells fill_missing_cells(MissingCells missing, std::vector<std::vector<double>>& channels);

/// Of a channel of which some could not be filled. Throws InputError with the row where the first gap that is left
/// begins.
[[noreturn]] void refuse_long_gap(const std::vector<double>& samples, const std::string& channel,
                                  const std::string& file, const RowPlace& place);

/// Their places among all rows, once the `lost` ones (lost_rows) stand among them.
void move_behind(const std::vector<std::size_t>& lost, MissingCells& cells);

}  // namespace secular
