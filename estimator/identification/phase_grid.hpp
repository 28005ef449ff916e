#pragma once

#include <vector>

#include "estimator/identification/phase_problem.hpp"

namespace secular {

/// docs/inference.md (17) on a grid of phases, with equations over the size of the motion.
struct GridMinima {
  std::vector<std::vector<double>>
      low;             ///< by record, the lowest first: where a search at the measured noise may start
  double p_value = 1;  ///< (18), of the lowest one against phases as measured
};

/// `together`: the case's regression with phases as measured.
GridMinima minima_on_grid(const PhaseProblem& problem, const CaseFit& together);

}  // namespace secular
