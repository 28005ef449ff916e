#include "app/identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/shipped_models.hpp"
#include "codegen/canonical_model.hpp"
#include "estimator/identification/modal_projection.hpp"
#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "perturb/model.hpp"
#include "simulate/replay.hpp"

namespace secular::app {
namespace {

/// The correction is evaluated at the estimate and once more at the corrected one.
constexpr int truncation_passes = 2;

std::string compiled_names() {
  std::string names;
  for (const CompiledModel* model : generated::compiled_models())
    names += (names.empty() ? "" : ", ") + std::string(model->name);
  return names;
}

// How far a dwell is from a case's resonances, relative; infinite where that cannot be told.
double mismatch(const CompiledModel& model, const CompiledCase& resonance, double excitation_frequency) {
  const std::size_t modes = model.modes(), columns = modes + model.excitations.size();
  if (resonance.relations.empty() || model.excitations.size() != 1) return INFINITY;
  double worst = 0;
  for (std::size_t r = 0; r * columns < resonance.relations.size(); ++r) {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < columns; ++i) {
      const double term =
          resonance.relations[r * columns + i] * (i < modes ? model.nominal[i] : excitation_frequency);
      sum += term;
      size = std::max(size, std::abs(term));
    }
    worst = std::max(worst, std::abs(sum) / size);
  }
  return worst;
}

const CompiledCase& named_case(const CompiledModel& model, const std::string& name) {
  std::string known;
  for (const CompiledCase& resonance : model.cases) {
    if (resonance.name == name) return resonance;
    known += (known.empty() ? "" : ", ") + std::string(resonance.name);
  }
  throw InputError("--case " + name, "", "is no case of model " + std::string(model.name),
                   "its cases are " + known);
}

// The case whose resonance the dwells excite, or the one without excitation for decays.
const CompiledCase& fitting_case(const CompiledModel& model, const Campaign& campaign, const Window& window) {
  std::vector<double> frequencies;
  bool decays = false;
  for (const RecordEntry& entry : campaign.records) {
    if (!matches_pattern(window.records, entry.file)) continue;
    if (entry.kind == RecordKind::dwell && entry.excitation_frequency_hz)
      frequencies.push_back(2 * std::numbers::pi * *entry.excitation_frequency_hz);
    decays = decays || entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact;
  }
  if (!frequencies.empty()) {
    std::nth_element(frequencies.begin(), frequencies.begin() + static_cast<std::ptrdiff_t>(frequencies.size() / 2),
                     frequencies.end());
    const double typical = frequencies[frequencies.size() / 2];
    const CompiledCase* best = nullptr;
    for (const CompiledCase& resonance : model.cases)
      if (resonance.excited && (!best || mismatch(model, resonance, typical) < mismatch(model, *best, typical)))
        best = &resonance;
    if (best && mismatch(model, *best, typical) < 0.1) return *best;
    throw InputError(campaign.folder.string(), "",
                     fmt::format("its dwells near {:.4g} Hz excite no resonance that model {} has a case for",
                                 typical / (2 * std::numbers::pi), model.name),
                     "name the case with --case, or add a [[case]] to the model");
  }
  if (decays)
    for (const CompiledCase& resonance : model.cases)
      if (!resonance.excited) return resonance;
  throw InputError(campaign.folder.string(), "",
                   "has no records that model " + std::string(model.name) + " can be identified from",
                   decays ? "its free decays need a case with excitation = false"
                          : "dwells with excitation_frequency_hz or free decays were expected");
}

}  // namespace

const CompiledModel& compiled_model_of(const std::string& name_or_path) {
  if (const CompiledModel* shipped = generated::find_compiled_model(name_or_path)) return *shipped;
  const std::string path = resolve_model(name_or_path).string();
  const CanonicalModel canonical = canonical_model(read_model(path));
  const CompiledModel* compiled = generated::find_compiled_model(canonical.name);
  if (!compiled)
    throw InputError(path, "", "model " + canonical.name + " is not compiled into this program",
                     "compiled are " + compiled_names() + "; add others with `secular generate` and build again");
  if (compiled->fingerprint != canonical.fingerprint)
    throw InputError(path, "", "differs from the model " + canonical.name + " that is compiled into this program",
                     "give it another name, or run `secular generate` and build again");
  return *compiled;
}

Identification identify(const IdentificationRequest& request) {
  Identification result;
  result.model = &compiled_model_of(request.model);
  const CompiledModel& model = *result.model;
  result.campaign = read_campaign(request.campaign);
  const Campaign& campaign = result.campaign;
  result.resonance = request.resonance.empty() ? &fitting_case(model, campaign, request.window)
                                               : &named_case(model, request.resonance);
  result.coordinate_unit = modal_projection(campaign, model).unit;
  if (result.resonance->excited)
    for (const std::size_t channel : excitation_channels(campaign, model))
      result.excitation_units.push_back(campaign.channels[channel].unit);
  const RecordReader read = [&](std::size_t r) { return read_record(campaign, campaign.records[r]); };
  result.measured = result.resonance->excited
                        ? observe_dwells(campaign, read, model, *result.resonance, request.window)
                        : observe_free_decays(campaign, read, model, *result.resonance, request.window);
  const EstimateOptions options{request.fixed};
  const Estimate raw = estimate(result.measured, result.coordinate_unit, result.excitation_units, options);
  result.estimate = raw;
  const auto replay = [&] {
    return observe_replay(
        campaign, result.measured,
        replay_records(campaign, result.measured, result.estimate.parameter_values, request.threads));
  };
  try {
    for (int pass = 0; pass < truncation_passes; ++pass) {
      const Estimate again = estimate(replay(), result.coordinate_unit, result.excitation_units, options);
      result.estimate =
          truncation_corrected(raw, again, result.estimate.parameter_values, model, *result.resonance);
    }
    result.replayed = replay();
  } catch (const InputError& error) {
    result.replayed = {};
    result.estimate = raw;
    result.estimate.warnings.push_back(
        std::string("the expansion's truncation could not be corrected by the full equations (") + error.what() +
        "): standard deviations do not contain it");
  }
  if (!result.resonance->excited)
    for (std::size_t r = 0; r < campaign.records.size(); ++r)
      if (auto prediction = predict_held_out_decay(campaign, read, result.measured, r,
                                                   result.estimate.parameter_values, request.window))
        result.held_out.push_back(std::move(*prediction));
  return result;
}

}  // namespace secular::app
