#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace secular::app {

/// Folders that may hold shipped models, first choice first: $SECULAR_MODELS, `../share/secular/models` beside the
/// running program's folder (an installed program), the models/ of the source tree it was built from.
std::vector<std::filesystem::path> model_folders();

/// Names of the shipped models, sorted: the .toml files of the first of model_folders() that exists.
std::vector<std::string> shipped_models();

/// The file of a model: `name_or_path` itself if it is a file, otherwise NAME.toml in the first of model_folders()
/// that has it ("two_mass_mode1", "experiments/principal_parametric"). Throws InputError that lists the shipped
/// models.
std::filesystem::path resolve_model(const std::string& name_or_path);

}  // namespace secular::app
