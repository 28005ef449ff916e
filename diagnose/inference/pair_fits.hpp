#pragma once

#include "diagnose/inference/explanation_search.hpp"

namespace secular {

/// Most of the best explanations that are followed farther: to partners of theirs, or alone.
inline constexpr std::size_t most_firsts = 3;

/// Pairs of the best single explanations with what shows beside them, and members of the best pairs alone. A second
/// effect only where the best single one leaves more than noise, or where one stands out that would be worth its
/// unknown and its prior odds: among many rows that fit, a few that do not are no excess of all.
void add_pairs(ExplanationSearch& search);

}  // namespace secular
