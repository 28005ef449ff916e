#pragma once

#include <vector>

namespace secular {

/// Normal law: standard deviation over the median of absolute values.
inline constexpr double sd_of_median = 1.4826;

/// The upper of the two middle values where their number is even; values may not be empty.
double upper_median(std::vector<double> values);

}  // namespace secular
