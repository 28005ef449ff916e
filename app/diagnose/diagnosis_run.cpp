#include "app/diagnose/diagnosis_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "app/diagnose/lateness.hpp"
#include "app/shared/model_loading.hpp"
#include "app/shared/number_file.hpp"
#include "app/shared/parameter_file.hpp"
#include "app/shared/record_assignment.hpp"
#include "app/shared/record_selection.hpp"
#include "input/input_error.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "measure/disturbances/disturbance_watch.hpp"
#include "numerics/distribution.hpp"
#include "numerics/median.hpp"

namespace secular::app {
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

// Numbers that say where the modes are and nothing else, of a model that has further parameters: no numbers whose
// gap could be judged.
bool only_rough_frequencies(const GivenNumbers& given, const ModelSource& source, const CompiledModel& model,
                            const std::vector<std::size_t>& own) {
  const std::vector<std::string>& frequencies = source.frequency_names();
  const auto is_frequency = [&](const std::string& name) {
    return std::find(frequencies.begin(), frequencies.end(), name) != frequencies.end();
  };
  if (!given || !std::all_of(given.values.begin(), given.values.end(),
                             [&](const auto& value) { return is_frequency(value.first); }))
    return false;
  return std::any_of(own.begin(), own.end(), [&](std::size_t s) {
    return !given.values.contains(std::string(model.symbols[s].name)) && !std::isfinite(model.nominal[s]);
  });
}

// The place of a response's offset among the numbers of the fit; nothing where it is none of them.
std::optional<Eigen::Index> fitted_offset(const Channel& channel, const Diagnosis& diagnosis) {
  const std::vector<std::string>& names = diagnosis.fitted.names;
  const auto found = std::find(names.begin(), names.end(), "offset(" + channel.name + ")");
  if (channel.role != ChannelRole::response || found == names.end()) return std::nullopt;
  return found - names.begin();
}

// Something that the fit tells of a record, within the window.
Disturbance fitted_in(std::size_t record, std::string_view kind, const Diagnosis& diagnosis) {
  Disturbance d;
  d.kind = kind;
  d.record = record;
  d.treated = "fitted";
  if (const auto span = diagnosis.spans.find(record); span != diagnosis.spans.end()) {
    d.from_s = span->second.from_s;
    d.to_s = span->second.to_s;
  }
  return d;
}

// Offsets of responses that the fit tells and the records alone do not, at the level of all disturbances.
std::vector<Disturbance> fitted_offsets(const Diagnosis& diagnosis, const Campaign& campaign,
                                        const std::vector<Disturbance>& found) {
  std::vector<Disturbance> offsets;
  for (std::size_t c = 0; c < campaign.channels.size(); ++c) {
    const Channel& channel = campaign.channels[c];
    const bool known = std::any_of(found.begin(), found.end(),
                                   [&](const Disturbance& d) { return d.kind == "offset" && d.channel == c; });
    const std::optional<Eigen::Index> place = fitted_offset(channel, diagnosis);
    if (known || !place) continue;
    const double value = diagnosis.fitted.values(*place),
                 sd = std::sqrt(diagnosis.fitted.covariance(*place, *place));
    const double level = disturbance_false_alarm / static_cast<double>(campaign.channels.size());
    if (!(sd > 0) || 2 * normal_upper_tail(std::abs(value) / sd) > level) continue;
    Disturbance d = fitted_in(diagnosis.spans.empty() ? 0 : diagnosis.spans.begin()->first, "offset", diagnosis);
    d.channel = c;
    d.size = std::abs(value);
    d.unit = channel.unit;
    d.text = fmt::format("reads {:.3g} {} (sd {:.1g}) at rest, the same in all records", value, channel.unit, sd);
    offsets.push_back(std::move(d));
  }
  return offsets;
}

// By how much the records of a case are late, as far as phases of their own made its equations hold better.
std::vector<Disturbance> late_records(const DiagnosisOptions& options, const Lateness& lateness,
                                      const Diagnosis& diagnosis) {
  std::vector<Disturbance> found;
  for (const auto& [record, late_s] : options.late_s) {
    Disturbance d = fitted_in(record, "late_record", diagnosis);
    d.size = late_s;
    d.unit = "s";
    d.share = std::abs(late_s) / lateness.period_s.at(record);
    d.text =
        fmt::format("responses are {:.3g} ms {} their excitation, up to whole periods of {:.3g} ms",
                    1e3 * std::abs(late_s), late_s < 0 ? "ahead of" : "behind", 1e3 * lateness.period_s.at(record));
    found.push_back(std::move(d));
  }
  return found;
}

DiagnosisOptions options_of(const DiagnosisRequest& request) {
  DiagnosisOptions options;
  options.catalogue = request.catalogue;
  options.window = request.window;
  options.threads = request.threads;
  options.progress = request.progress;
  options.left_out.insert(request.without.begin(), request.without.end());
  if (request.check_from_s || request.check_to_s) {
    options.check = request.window;
    options.check->from_s = request.check_from_s.value_or(Window{}.from_s);
    options.check->to_s = request.check_to_s.value_or(Window{}.to_s);
    options.fit_check = request.fit_check;
  }
  if (request.parameters.empty()) return options;
  GivenParameters given = read_parameter_file(request.parameters);
  options.given.values = std::move(given.values);
  for (const auto& [name, value] : given.representative)
    if (options.given.values.emplace(name, value).second) options.given.open.insert(name);
  options.given.sd = std::move(given.sd);
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

// Whether one time by which all responses are late does as well: that is a cause, channel_skew, and no disturbance.
bool share_a_delay(const TriedModel& tried, const Campaign& campaign, const RecordReader& read,
                   const DiagnosisOptions& options, const Lateness& lateness) {
  std::vector<double> late;
  for (const auto& [record, seconds] : lateness.late_s) late.push_back(seconds);
  return !misses(campaign, read, *tried.model, tried.own, options, upper_median(std::move(late)));
}

// Records that identify finds out of step with their excitation are diagnosed with phases of their own: at once
// where its equations hold then, otherwise where that alone leaves nothing unexplained.
Diagnosis diagnose_in_step(const DiagnosisRequest& request, const TriedModel& tried, const Campaign& campaign,
                           const RecordReader& read, DiagnosisOptions& options, Lateness& lateness) {
  const auto diagnosed = [&](const std::map<std::size_t, double>& late_s) {
    options.late_s = late_s;
    return diagnose(campaign, read, *tried.model, tried.own, tried.effects, options);
  };
  if (can_be_late(campaign, *tried.model) && misses(campaign, read, *tried.model, tried.own, options))
    lateness = find_lateness(request);
  if (lateness.late_s.empty() || share_a_delay(tried, campaign, read, options, lateness)) return diagnosed({});
  if (lateness.holds) return diagnosed(lateness.late_s);
  Diagnosis in_step = diagnosed({});
  if (is_told(in_step)) return in_step;
  Diagnosis freed = diagnosed(lateness.late_s);
  if (is_told(freed)) return freed;
  options.late_s.clear();
  return in_step;
}

}  // namespace

DiagnosisRun run_diagnosis(const DiagnosisRequest& request) {
  DiagnosisRun run;
  const ModelSource source(request.model, request.interpret, request.catalogue);
  run.campaign = read_campaign(request.campaign);
  DiagnosisOptions options = options_of(request);
  DisturbanceWatch watch(run.campaign);
  SelectedRecords reader(run.campaign, request.window, watch.look());
  const RecordReader read = [&](std::size_t r) { return reader.read(r); };
  std::vector<double> nominal = source.nominal_frequencies();
  nominal.resize(source.modes());
  for (std::size_t k = 0; k < nominal.size(); ++k)
    if (const auto given = options.given.values.find(source.frequency_names()[k]);
        given != options.given.values.end())
      nominal[k] = given->second;
  const FrequencyStarts starts = frequency_starts(source, run.campaign, read, nominal, {}, request.window);
  options.natural_frequency = starts.frequency;
  for (std::size_t k = 0; k < nominal.size(); ++k)
    if (std::isfinite(nominal[k]) && !starts.moved[k]) options.natural_frequency[k] = nominal[k];
  const TriedModel tried = with_effects(source, request.catalogue);
  run.model = tried.model;
  options.forces = tried.forces;
  const std::string unused = unused_numbers(request.parameters, options.given.values, *run.model);
  const bool rough = only_rough_frequencies(options.given, source, *run.model, tried.own);
  if (rough) options.given = {};
  Lateness lateness;
  run.diagnosis = diagnose_in_step(request, tried, run.campaign, read, options, lateness);
  run.diagnosis.warnings.insert(run.diagnosis.warnings.begin(), starts.warnings.begin(), starts.warnings.end());
  if (rough)
    run.diagnosis.warnings.push_back(
        request.parameters +
        ": holds natural frequencies alone, which are taken as a start: all parameters are fitted");
  if (!unused.empty()) run.diagnosis.warnings.push_back(unused);
  if (!lateness.warning.empty()) run.diagnosis.warnings.push_back(lateness.warning);
  for (std::string& warning : reader.warnings()) run.diagnosis.warnings.push_back(std::move(warning));
  run.disturbances = watch.found();
  for (Disturbance& d : run.disturbances)
    if (d.kind == "offset" && d.channel && fitted_offset(run.campaign.channels[*d.channel], run.diagnosis))
      d.treated = "fitted";
  for (Disturbance& d : fitted_offsets(run.diagnosis, run.campaign, run.disturbances))
    run.disturbances.push_back(std::move(d));
  for (Disturbance& d : late_records(options, lateness, run.diagnosis)) run.disturbances.push_back(std::move(d));
  run.looked_at = watch.records();
  return run;
}

}  // namespace secular::app
