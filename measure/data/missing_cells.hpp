#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/data/time_axis.hpp"

namespace secular {

/// By channel, the places of samples that are no finite numbers, rising.
using MissingCells = std::vector<std::vector<std::size_t>>;

MissingCells missing_cells(const std::vector<std::vector<double>>& channels);

/// Puts in what fill_gaps finds for them; where it finds nothing they stay. Returns those that were filled.
MissingCells fill_missing_cells(std::vector<std::vector<double>>& channels);

/// What a record holds that its file does not: whole rows, and samples of single channels, by their places among
/// all rows, rising.
struct FilledSamples {
  std::vector<std::size_t> rows;
  MissingCells cells;
};

/// Fills missing cells, then lost rows (fill_lost_rows; none where cells are left).
FilledSamples fill_missing(std::vector<double>& stamps_s, std::vector<std::vector<double>>& channels);

/// Throws InputError where a channel has samples that could not be filled, with the row where the first gap begins.
void require_filled(const std::vector<double>& samples, const std::string& channel, const std::string& file,
                    const RowPlace& place);

}  // namespace secular
