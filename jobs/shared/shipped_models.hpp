#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace secular {

/// The folder that installed files are found from: that of the running program, or the one that was set by what is
/// no program of its own (a Python module). Empty: not known.
std::filesystem::path program_folder();
void set_program_folder(const std::filesystem::path& folder);

/// Folders that may hold shipped models, first choice first: $SECULAR_MODELS, `../share/secular/models` beside
/// program_folder() (an installed program), the models/ of the source tree it was built from.
std::vector<std::filesystem::path> model_folders();

/// Names of the shipped models, sorted: the .toml files of the first of model_folders() that exists.
std::vector<std::string> shipped_models();

/// The file of a model: `name_or_path` itself if it is a file, otherwise NAME.toml in the first of model_folders()
/// that has it ("two_mass_mode1", "experiments/principal_parametric"). Throws InputError that lists the shipped
/// models.
std::filesystem::path resolve_model(const std::string& name_or_path);

}  // namespace secular
