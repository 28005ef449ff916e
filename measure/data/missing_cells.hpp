#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "measure/data/time_axis.hpp"

namespace secular {

/// By channel, the places of samples that are no finite numbers, rising.
using MissingCells = std::vector<std::vector<std::size_t>>;

/// As they are in the file, before anything is filled.
MissingCells missing_cells(const std::vector<std::vector<double>>& channels);

/// A number that stands for none (-9.96921e36, 1e30, 2147483647): one modulus of 1e9 or more, at one sample or
/// more, that is 1e8 times as large as all others. Next to it these are equal (SameValue): no motion has both. Sets
/// such samples to NaN; a channel that is zero otherwise stays as it is. Returns how many there are.
std::size_t drop_fill_values(std::vector<double>& samples);

/// A number that seems to stand for none in a file, by what is usual: -999, 9999, 99999.9 (nines alone, three or
/// more), the ends of the range of integers of 16 and 32 bits, or what drop_fill_values() takes for such.
struct FillValue {
  double value = 0;
  std::size_t count = 0, first = 0;  ///< samples that hold it
};

/// One that is farther from all other samples than they are from each other; nothing where there is none.
std::optional<FillValue> suspected_fill_value(std::span<const double> samples);

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

/// Takes off what are no numbers at both ends, where fewest_recorded samples or more are left. Returns how many
/// there were at the beginning.
std::size_t drop_ends_without_numbers(std::vector<double>& samples);

/// Throws InputError where a channel has samples that could not be filled, with the row where the first gap begins.
void require_filled(const std::vector<double>& samples, const std::string& channel, const std::string& file,
                    const RowPlace& place);

}  // namespace secular
