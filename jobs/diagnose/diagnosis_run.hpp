#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/verdict/diagnosis.hpp"
#include "estimator/model/compiled_model.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/parameter_file.hpp"
#include "measure/data/campaign.hpp"
#include "measure/disturbances/disturbance.hpp"

namespace secular {

struct DiagnosisRequest {
  std::string model;            ///< as ModelSource takes it
  GivenParameters parameters;   ///< whose gap is diagnosed; none: those that fit best
  std::string parameters_name;  ///< what messages call them
  Window window;
  /// Window in which the explanation is tried on records in one piece; none: no such trial.
  std::optional<double> check_from_s, check_to_s;
  bool fit_check = false;
  std::vector<std::string> without;  ///< effects that are not to be considered
  EffectCatalogue catalogue = effect_catalogue();
  double highest_level = usual_highest_level;  ///< DiagnosisOptions::highest_level
  bool interpret = false;
  unsigned threads = 1;
  NoteSink note = {};  ///< of loading the model
  SearchProgress progress = {};
};

/// A diagnosis and what it was made of.
struct DiagnosisRun {
  Campaign campaign;
  std::shared_ptr<const CompiledModel> model;  ///< with all effects that it was tried with
  Diagnosis diagnosis;
  std::string coordinate_unit;                 ///< of the modes' displacements
  std::vector<Disturbance> disturbances;       ///< in the records that were read
  std::size_t looked_at = 0;                   ///< records
  std::optional<std::string> mostly_left_out;  ///< see mostly_left_out()
};

/// Loads the model with every effect of the catalogue that fits it (equations of motion alone: compiled once for
/// all candidates) and diagnoses the campaign. Throws InputError.
DiagnosisRun run_diagnosis(const DiagnosisRequest& request, const Campaign& campaign);

}  // namespace secular
