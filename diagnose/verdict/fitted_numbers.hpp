#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "diagnose/effects/candidate.hpp"
#include "diagnose/inference/refit.hpp"
#include "estimator/identification/symbol_units.hpp"
#include "estimator/model/compiled_model.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// Numbers that a fit chose and that the data identify: symbols of the model and faults of the measurement.
struct FittedNumbers {
  std::vector<std::string> names;
  std::vector<std::string> units;  ///< "1" for none, empty where the equations do not fix it
  Eigen::VectorXd values;
  Eigen::MatrixXd covariance;
};

/// `members`: candidates of the explanation whose fit this is; their strengths are given as their terms have them.
/// `names`: of all unknowns, those of the model's symbols first. `covariance`: of the fit's free unknowns. Units
/// follow from those of the channels of `campaign`; a symbol that multiplies a force with a signal of its own
/// (memory, time, a power) has none.
FittedNumbers fitted_numbers(const Refit& fit, const std::vector<const Candidate*>& members,
                             const std::vector<std::string>& names, const Eigen::MatrixXd& covariance,
                             const Campaign& campaign, const CompiledModel& model);

}  // namespace secular
