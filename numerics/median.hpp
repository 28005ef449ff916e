#pragma once

#include <vector>

namespace secular {

/// The upper of the two middle values where their number is even; values may not be empty.
double upper_median(std::vector<double> values);

}  // namespace secular
