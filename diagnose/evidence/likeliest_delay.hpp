#pragma once

#include <functional>

namespace secular {

/// Where within a period (s) a record's excitation is read likeliest later (s), from `here` on (docs/inference.md
/// (24)). `misfit`: -2 log likelihood by that time; infinite: impossible.
double likeliest_delay(const std::function<double(double)>& misfit, double here, double period);

}  // namespace secular
