#pragma once

#include <string>
#include <vector>

#include "diagnose/inference/held_out.hpp"
#include "diagnose/inference/refit.hpp"

namespace secular {

/// What an explanation leaves of the equations of motion, as smooth functions of the test's settings.
struct SmoothStructure {
  double squares = 0, freedom = 0;  ///< chi-squared of those functions, and how many there are
  double p_value = 1;
  double excess() const { return squares > freedom ? squares - freedom : 0; }
};

/// Neyman's smooth test (1937): rows of every balance (real and imaginary part of every line of every mode) are
/// compared with low powers of amplitude, level, frequency and time, of which the fitted unknowns (the columns of
/// fit.jacobian) are taken out first. Structure that is spread over many rows shows here long before it shows in
/// their sum of squares. `labels` belong to fit.rows.
SmoothStructure smooth_structure(const Refit& fit, const std::vector<RowLabel>& labels);

/// What the best explanation leaves.
struct ResidualStructure {
  double p_value = 1;         ///< of the sum of squares of all rows
  double smooth_p_value = 1;  ///< of smooth_structure
  double smooth_share = 0;    ///< what that is beyond noise of all that there was to explain, as amplitudes
};

/// `freedom`: of all rows. `explained`: fall of the sum of squares by the explanation.
ResidualStructure residual_structure_of(const Refit& fit, const std::vector<RowLabel>& labels, double freedom,
                                        double explained);

/// How far an explanation goes.
enum class Reach {
  little,       ///< it is not shown to close more of the gap than it leaves, leaves structure and a tenth of it, or
                ///< fits what it has seen and misses what was held out
  approximate,  ///< it closes most of the gap, and structure is left beside it
  all           ///< what it leaves is what repeatability leaves, also of conditions that were held out
};

/// Whether held-out conditions show that an explanation closes half of the gap: the lower end of its interval does.
bool closes_more_than_it_leaves(const ClosedShare& closing);

/// Of an explanation that closes so much on conditions that were held out and leaves this structure. One that is
/// not shown to close more than it leaves is no cause, however likely it is beside others; nor is one of a gap that
/// is smaller than repeatability, where there is nothing to close.
Reach reach_of(const ResidualStructure& structure, const ClosedShare& closing);

/// Whether it closes nine tenths, and half is shown.
bool closes_most(const ClosedShare& closing);

/// In words: what keeps an explanation of little reach from being named.
std::string what_is_missing(const ResidualStructure& structure, const ClosedShare& closing);

}  // namespace secular
