#pragma once

#include <cstddef>
#include <vector>

namespace secular {

/// Where stamps that are even otherwise leave out a few rows (at most longest_filled in a row: the step there is a
/// whole multiple of the others): the places of these rows among all, rising. Empty where a gap is longer or no
/// whole number of steps, and where stamps are rounded to the ticks of a clock.
std::vector<std::size_t> lost_rows(const std::vector<double>& stamps_s);

/// Puts the lost rows in, and in every channel the samples that fill_gaps finds for them. Stamps and channels stay
/// as they are where it finds none, or where a channel has samples that are no numbers; whether they were put in.
bool fill_lost_rows(const std::vector<std::size_t>& lost, std::vector<double>& stamps_s,
                    std::vector<std::vector<double>>& channels);

}  // namespace secular
