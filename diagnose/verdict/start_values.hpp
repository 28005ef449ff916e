#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "diagnose/evidence/sensor_model.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "estimator/model/compiled_model.hpp"

namespace secular {

/// Where fits begin: the model's symbols, then those of the faults. Of a symbol what a user or the modulation
/// equations gave, else what the records tell, else its nominal value, else zero. Throws InputError where a natural
/// frequency is known from nowhere, and for those of `own`, the symbols that are fitted, that nothing is known of
/// where the equations have no finite slope by them at zero, or none at all that they have elsewhere (the d of x/d,
/// the k and b of k*exp(b*x)): no step from there means anything.
Eigen::VectorXd start_values(const CompiledModel& model, const FaultTable& faults, const DiagnosisOptions& options,
                             const std::vector<std::size_t>& own);

/// What the records tell of a natural frequency, rad/s; NaN: nothing.
double seen_frequency(const DiagnosisOptions& options, std::size_t mode);

}  // namespace secular
