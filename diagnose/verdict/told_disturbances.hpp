#pragma once

#include <vector>

#include "diagnose/verdict/blows_alone.hpp"
#include "diagnose/verdict/diagnosis.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "estimator/model/compiled_model.hpp"
#include "measure/data/campaign.hpp"
#include "measure/disturbances/disturbance.hpp"

namespace secular {

/// What was found in records: what the fit of a diagnosis with these options allows for is said to be fitted, and
/// what it tells beside that comes last, offsets of responses, how late records are, and their own frequencies.
std::vector<Disturbance> told_disturbances(std::vector<Disturbance> found, const Diagnosis& diagnosis,
                                           const DiagnosisOptions& options, const Campaign& campaign,
                                           const CompiledModel& model);

/// Blows that do not do what their excitation says, where only what follows them counts in the diagnosis.
std::vector<Disturbance> blow_mismatches(const BlowsAlone& blows, const Diagnosis& diagnosis,
                                         const CompiledModel& model);

}  // namespace secular
