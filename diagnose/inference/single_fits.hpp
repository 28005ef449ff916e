#pragma once

#include <vector>

#include "diagnose/inference/explanation_search.hpp"

namespace secular {

/// Candidates whose gain is worth a fit, best first, `most` at most: a share of the best gain, and more than
/// `least`.
std::vector<std::size_t> promising(const std::vector<Screening>& screened, std::size_t most, double least);

/// Below this gain a candidate is not fitted: among true errors it is chance, among wider ones none is too small.
double least_gain_worth_a_fit(const ExplanationSearch& search);

/// Every single candidate that shows at first order beside the null, fitted.
void fit_singles(ExplanationSearch& search);

}  // namespace secular
