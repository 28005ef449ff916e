#pragma once

#include <vector>

#include "estimator/identification/phase_problem.hpp"

namespace secular {

/// Low minima of docs/inference.md (17) on a grid of phases, by record, the lowest first: where the search for
/// phases at the measured noise may start. `together`: the case's regression with phases as measured.
std::vector<std::vector<double>> minima_on_grid(const PhaseProblem& problem, const CaseFit& together);

}  // namespace secular
