#include "jobs/simulate/experiment_loading.hpp"

#include <string>
#include <system_error>
#include <vector>

#include "input/input_error.hpp"
#include "jobs/shared/model_loading.hpp"

namespace secular {
namespace {

ModelSource model_source(const std::filesystem::path& experiment, bool interpret, const NoteSink& note,
                         const EffectCatalogue& catalogue) {
  const std::string name = experiment_model(experiment);
  const std::filesystem::path beside = experiment.parent_path() / name;
  std::error_code unreadable;
  return {std::filesystem::is_regular_file(beside, unreadable) ? beside.string() : name, interpret, note,
          catalogue};
}

EffectTerm effect_term(const ExperimentEffect& effect, const ModelSource& source) {
  std::string text = effect.name;
  for (const std::string& part : {effect.mode, effect.other, effect.form}) {
    if (part.empty()) break;
    text += ":" + part;
  }
  try {
    return source.effect_term(text);
  } catch (const InputError& error) {
    throw InputError(effect.file, "line " + std::to_string(effect.line), "effect " + text + " " + error.wrong(),
                     error.right());
  }
}

}  // namespace

LoadedExperiment load_experiment(const std::filesystem::path& path, bool interpret, const NoteSink& note,
                                 const EffectCatalogue& catalogue) {
  const ModelSource source = model_source(path, interpret, note, catalogue);
  std::vector<EffectTerm> terms;
  for (const ExperimentEffect& effect : read_experiment_effects(path, catalogue))
    if (effect.is_motion()) terms.push_back(effect_term(effect, source));
  AugmentedCompiledModel loaded = source.load_with_effects(terms, {});  // equations of motion alone
  std::vector<InstalledEffect> installed;
  for (const AddedEffect& added : loaded.effects)
    installed.push_back({added.parameters, added.term.mode, added.signal, added.added_mode, added.law});
  const StatedParameters stated{source.following_names(),
                                [&](std::map<std::string, double>& values, const std::string& where) {
                                  source.take_rest_position(values, where);
                                }};
  Experiment experiment = read_experiment(path, *loaded.model, installed, catalogue, stated);
  return {std::move(loaded.model), std::move(experiment)};
}

}  // namespace secular
