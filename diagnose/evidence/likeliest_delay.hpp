#pragma once

#include <functional>
#include <optional>

namespace secular {

/// Where within a period (s) a record's excitation is read likeliest later (s), from `here` on (docs/inference.md
/// (24)). `deviance`: -2 log likelihood by that time; infinite: impossible.
double likeliest_delay(const std::function<double(double)>& deviance, double here, double period);

/// The same from where it was likeliest by numbers that have moved since, in four evaluations; nothing where it is
/// not close by any more (docs/inference.md (24b)).
std::optional<double> likeliest_delay_near(const std::function<double(double)>& deviance, double here,
                                           double period);

}  // namespace secular
