#pragma once

#include <filesystem>
#include <memory>

#include "estimator/model/compiled_model.hpp"
#include "jobs/shared/model_loading.hpp"
#include "motion/simulate/experiment.hpp"

namespace secular {

/// An experiment and the equations of motion it is run on, the terms of its [[effect]] tables included.
struct LoadedExperiment {
  std::shared_ptr<const CompiledModel> model;
  Experiment experiment;
};

/// The model that the file names is a file beside it, otherwise a path or a shipped model. `interpret`: no compiled
/// code. `note`: of loading it. Throws InputError.
LoadedExperiment load_experiment(const std::filesystem::path& path, bool interpret, const NoteSink& note,
                                 const EffectCatalogue& catalogue = effect_catalogue());

}  // namespace secular
