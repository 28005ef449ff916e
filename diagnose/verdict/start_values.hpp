#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "diagnose/evidence/sensor_model.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "estimator/model/compiled_model.hpp"

namespace secular {

/// Those of `own`, the symbols that are fitted, that nothing is known of where the equations have no finite slope
/// by them at zero, or none at all that they have elsewhere (the d of x/d, the k and b of k*exp(b*x), the a and b
/// of a*b*x^2): no step from there means anything.
std::vector<std::string> symbols_without_start(const CompiledModel& model, const DiagnosisOptions& options,
                                               const std::vector<std::size_t>& own);

/// Where fits begin: the model's symbols, then those of the faults. Of a symbol what a user or the modulation
/// equations gave, else what the records tell, else its nominal value, else zero. Throws InputError where a natural
/// frequency is known from nowhere, and for symbols_without_start.
Eigen::VectorXd start_values(const CompiledModel& model, const FaultTable& faults, const DiagnosisOptions& options,
                             const std::vector<std::size_t>& own);

/// What the records tell of a natural frequency, rad/s; NaN: nothing.
double seen_frequency(const DiagnosisOptions& options, std::size_t mode);

}  // namespace secular
