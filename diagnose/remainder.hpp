#pragma once

#include <vector>

#include "diagnose/refit.hpp"

namespace secular {

/// What an explanation leaves of the equations of motion, as smooth functions of the test's settings.
struct SmoothRemainder {
  double squares = 0, freedom = 0;  ///< chi-squared of those functions, and how many there are
  double p_value = 1;
  double excess() const { return squares > freedom ? squares - freedom : 0; }
};

/// Neyman's smooth test (1937): rows of every balance (real and imaginary part of every line of every mode) are
/// compared with low powers of amplitude, level, frequency and time, of which the fitted unknowns (the columns of
/// fit.jacobian) are taken out first. Structure that is spread over many rows shows here long before it shows in
/// their sum of squares. `labels` belong to fit.rows.
SmoothRemainder smooth_remainder(const Refit& fit, const std::vector<RowLabel>& labels);

}  // namespace secular
