#include "jobs/shared/shipped_models.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "input/input_error.hpp"
#include "input/nearest_word.hpp"
#include "jobs/shared/install_layout.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code unreadable;
  return fs::is_regular_file(path, unreadable);
}

// Whether a path can be the name of a shipped file: "./duffing" and "../duffing" are of the caller's folder.
bool is_below_shipped(const fs::path& path) {
  return path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == "." || part == ".."; });
}

fs::path folder_that_was_set;

// Names of the files in a folder of the shipped ones, as they are typed.
std::vector<std::string> shipped_in(const fs::path& below) {
  std::vector<std::string> names;
  for (const fs::path& folder : model_folders()) {
    std::error_code unreadable;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / below, unreadable))
      if (entry.path().extension() == ".toml" && is_file(entry.path()))
        names.push_back((below / entry.path().stem()).string());
    if (!unreadable) break;
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

fs::path program_folder() {
  if (!folder_that_was_set.empty()) return folder_that_was_set;
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown).parent_path();
}

void set_program_folder(const fs::path& folder) {
  folder_that_was_set = folder;
}

std::vector<fs::path> model_folders() {
  std::vector<fs::path> folders;
  const char* const chosen = std::getenv("SECULAR_MODELS");
  if (chosen != nullptr && *chosen != '\0') folders.emplace_back(chosen);
  if (const fs::path program = program_folder(); !program.empty())
    folders.push_back((program / models_from_program_folder).lexically_normal());
  folders.emplace_back(models_in_source_tree);
  return folders;
}

std::vector<std::string> shipped_models() {
  return shipped_in("");
}

fs::path resolve_model(const std::string& name_or_path) {
  if (is_file(name_or_path)) return name_or_path;
  if (!name_or_path.empty() && fs::path(name_or_path).is_relative())
    for (const fs::path& folder : model_folders()) {
      const fs::path file = folder / (name_or_path + ".toml");
      if (is_file(file)) return file;
    }
  const fs::path below = is_below_shipped(name_or_path) ? fs::path(name_or_path).parent_path() : fs::path();
  std::vector<std::string> names = shipped_in(below);
  const bool has_any = !names.empty();
  if (!has_any) names = shipped_models();
  const std::string kind = has_any && !below.empty() ? "file" : "model";
  throw InputError(name_or_path, "", "neither a file nor the name of a shipped " + kind,
                   names.empty() ? "no shipped models were found; SECULAR_MODELS can name their folder"
                                 : remedy_for_word(fmt::format("shipped {}s: {}", kind, fmt::join(names, ", ")),
                                                   name_or_path, names));
}

}  // namespace secular
