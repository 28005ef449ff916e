#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace secular {

/// Of single samples that stand out of an excitation (`places`, rising) those that a response answers: blows of a
/// hammer that the sample rate is too low for, and no wrong samples. A response is predicted from the samples
/// before by an autoregression (least squares). Where a blow begins a new motion the error of prediction is, at
/// that sample or the two behind it, larger than all that are not beside any of the places: of n of those, chance
/// makes that with a probability of at most 3/(n + 3).
std::vector<std::size_t> answered_blows(std::span<const double> response, const std::vector<std::size_t>& places);

}  // namespace secular
