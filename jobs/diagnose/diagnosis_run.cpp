#include "jobs/diagnose/diagnosis_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/verdict/given_numbers.hpp"
#include "diagnose/verdict/start_values.hpp"
#include "diagnose/verdict/step_by_step.hpp"
#include "jobs/identify/full_equations.hpp"
#include "jobs/shared/compared_records.hpp"
#include "jobs/shared/left_out.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/number_file.hpp"
#include "jobs/shared/parameter_file.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/disturbances/disturbance_watch.hpp"
#include "measure/observe/modal_projection.hpp"

namespace secular {
namespace {

// Of others the diagnosis has descriptions of its own: they are not terms that a line of a steady motion sees.
bool is_seen_by_lines(const EffectTerm& term, const EffectCatalogue& catalogue) {
  const Effect& effect = *catalogue.find(term.effect);
  return effect.kind == Effect::Kind::term && !effect.is_of_time();
}

std::string subject_of(const EffectTerm& term, const CompiledModel& model) {
  std::string subject(model.coordinates[term.mode]);
  if (term.other != EffectTerm::none) subject += ", " + std::string(model.coordinates[term.other]);
  return subject;
}

std::size_t symbol_index(const CompiledModel& model, const std::string& name) {
  const auto found = std::find_if(model.symbols.begin(), model.symbols.end(),
                                  [&](const CompiledSymbol& symbol) { return symbol.name == name; });
  return static_cast<std::size_t>(found - model.symbols.begin());
}

DiagnosisOptions options_of(const DiagnosisRequest& request) {
  DiagnosisOptions options;
  options.catalogue = request.catalogue;
  options.window = request.window;
  options.threads = request.threads;
  options.progress = request.progress;
  options.highest_level = request.highest_level;
  options.left_out.insert(request.without.begin(), request.without.end());
  if (request.check_from_s || request.check_to_s) {
    options.check = request.window;
    options.check->from_s = request.check_from_s.value_or(Window{}.from_s);
    options.check->to_s = request.check_to_s.value_or(Window{}.to_s);
    options.fit_check = request.fit_check;
  }
  const GivenParameters& given = request.parameters;
  options.given.values = given.values;
  for (const auto& [name, value] : given.representative)
    if (options.given.values.emplace(name, value).second) options.given.open.insert(name);
  options.given.sd = given.sd;
  return options;
}

// A model with every effect that it can be tried with.
struct TriedModel {
  std::shared_ptr<const CompiledModel> model;
  std::vector<EquationEffect> effects;
  std::vector<StateForce> forces;
  std::vector<std::size_t> own;  // symbols of the model as it was
};

TriedModel with_effects(const ModelSource& source, const EffectCatalogue& catalogue) {
  std::vector<EffectTerm> terms;
  for (const EffectTerm& term : source.applicable_effects())
    if (is_seen_by_lines(term, catalogue)) terms.push_back(term);
  for (const EffectTerm& term : source.open_law_terms()) terms.push_back(term);
  const AugmentedCompiledModel augmented = source.load_with_effects(terms, {});
  TriedModel tried;
  tried.model = augmented.model;
  std::vector<bool> added(tried.model->symbols.size(), false);
  for (const AddedEffect& effect : augmented.effects) {
    EquationEffect equation;
    equation.effect = effect.term.effect;
    equation.form = effect.term.form;
    equation.mode = effect.term.mode;
    equation.subject = subject_of(effect.term, *tried.model);
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
      const std::size_t symbol = symbol_index(*tried.model, effect.parameters[p]);
      if (symbol >= added.size()) continue;  // a symbol that no equation holds
      added[symbol] = true;
      if (p == 0)
        equation.strength = symbol;
      else
        equation.shapes.push_back(symbol);
    }
    if (effect.signal != EffectTerm::none)
      tried.forces.push_back({effect.law, effect.signal, effect.term.mode, equation.strength,
                              equation.shapes.empty() ? StateForce::none : equation.shapes.back()});
    tried.effects.push_back(std::move(equation));
  }
  for (std::size_t s = 0; s < added.size(); ++s)
    if (!added[s]) tried.own.push_back(s);
  return tried;
}

IdentificationRequest identification_of(const DiagnosisRequest& request) {
  IdentificationRequest wanted;
  wanted.model = request.model;
  wanted.interpret = request.interpret;
  wanted.window = request.window;
  wanted.threads = request.threads;
  wanted.note = request.note;
  return wanted;
}

// What dwells and decays tell of the model as it is; nothing where there are none.
std::vector<EstimatedValue> identified(const DiagnosisRequest& request, const Campaign& campaign) {
  if (!holds_dwells_or_decays(campaign, request.window)) return {};
  return identify_by_modulation(identification_of(request), campaign).estimate.parameters;
}

}  // namespace

DiagnosisRun run_diagnosis(const DiagnosisRequest& request, const Campaign& campaign) {
  DiagnosisRun run;
  const ModelSource source(request.model, request.interpret, request.note, request.catalogue);
  run.campaign = campaign;
  DiagnosisOptions options = options_of(request);
  // What differs from record to record is allowed for in further turns; of one record there is none, and the time
  // for it is that of more samples.
  if (records_within(run.campaign, request.window).size() == 1) options.most_samples *= 2;
  source.take_rest_position(options.given.values, request.parameters_name);
  DisturbanceWatch watch(run.campaign);
  SelectedRecords reader(run.campaign, request.window, watch.look());
  const RecordReader read = [&](std::size_t r) { return reader.read(r); };
  const FrequencyStarts starts = start_frequencies(source, run.campaign, read, options);
  std::vector<Disturbance> found = found_in_records(run.campaign, request.window, reader, watch);
  const TriedModel tried = with_effects(source, request.catalogue);
  run.model = tried.model;
  options.forces = tried.forces;
  if (std::string why; !symbols_without_start(*tried.model, options, tried.own).empty())
    options.start.merge(start_by_modulation(identification_of(request), run.campaign, why));
  const std::string unused = unused_numbers(request.parameters_name, options.given.values, *run.model);
  StepwiseDiagnosis steps =
      diagnose_step_by_step({run.campaign, read, *tried.model, tried.own}, tried.effects, std::move(options),
                            std::move(found), [&] { return identified(request, run.campaign); });
  run.diagnosis = std::move(steps.diagnosis);
  std::vector<std::string>& warnings = run.diagnosis.warnings;
  warnings.insert(warnings.begin(), starts.warnings.begin(), starts.warnings.end());
  if (steps.numbers_were_a_start)
    warnings.push_back(request.parameters_name +
                       ": holds natural frequencies alone, which are taken as a start: all parameters are fitted");
  if (!unused.empty()) warnings.push_back(unused);
  if (!steps.decays_warning.empty()) warnings.push_back(std::move(steps.decays_warning));
  for (std::string& warning : reader.warnings()) warnings.push_back(std::move(warning));
  if (!steps.blows_warning.empty()) warnings.push_back(std::move(steps.blows_warning));
  run.coordinate_unit = modal_projection(run.campaign, *run.model).unit;
  run.disturbances = std::move(steps.disturbances);
  run.looked_at = watch.records();
  run.mostly_left_out = mostly_left_out(warnings, run.campaign, records_within(run.campaign, request.window), {});
  return run;
}

}  // namespace secular
