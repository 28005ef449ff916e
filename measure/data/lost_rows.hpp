#pragma once

#include <cstddef>
#include <vector>

namespace secular {

/// Where stamps that are even otherwise leave out a few rows (at most longest_filled in a row: the step there is a
/// whole multiple of the others), stamps are put in and, in every channel, zeros for the samples that are not
/// known. Returns the places of these rows, rising; empty, and nothing changed, where a gap is longer or no whole
/// number of steps, or where stamps are rounded to the ticks of a clock.
std::vector<std::size_t> insert_lost_rows(std::vector<double>& stamps_s,
                                          std::vector<std::vector<double>>& channels);

}  // namespace secular
