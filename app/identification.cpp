#include "app/identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/model_loading.hpp"
#include "estimator/identification/modal_projection.hpp"
#include "input/input_error.hpp"
#include "simulate/replay.hpp"

namespace secular::app {
namespace {

/// The correction is evaluated at the estimate and once more at the corrected one.
constexpr int truncation_passes = 2;

// How far a dwell is from a case's resonances, relative; infinite where that cannot be told.
double mismatch(const ModelSource& model, const CaseOutline& resonance, double excitation_frequency) {
  const std::vector<double>& nominal = model.nominal_frequencies();
  if (resonance.relations.empty() || nominal.size() != model.modes() + 1) return INFINITY;
  double worst = 0;
  for (const std::vector<int>& relation : resonance.relations) {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < relation.size(); ++i) {
      const double term = relation[i] * (i < model.modes() ? nominal[i] : excitation_frequency);
      sum += term;
      size = std::max(size, std::abs(term));
    }
    worst = std::max(worst, std::abs(sum) / size);
  }
  return worst;
}

void require_case(const ModelSource& model, const std::string& name) {
  std::string known;
  for (const CaseOutline& resonance : model.cases()) {
    if (resonance.name == name) return;
    known += (known.empty() ? "" : ", ") + resonance.name;
  }
  throw InputError("--case " + name, "", "is no case of model " + model.name(), "its cases are " + known);
}

// The case whose resonance the dwells excite, or the one without excitation for decays.
std::string fitting_case(const ModelSource& model, const Campaign& campaign, const Window& window) {
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
    const CaseOutline* best = nullptr;
    for (const CaseOutline& resonance : model.cases())
      if (resonance.excited && (!best || mismatch(model, resonance, typical) < mismatch(model, *best, typical)))
        best = &resonance;
    if (best && mismatch(model, *best, typical) < 0.1) return best->name;
    throw InputError(campaign.folder.string(), "",
                     fmt::format("its dwells near {:.4g} Hz excite no resonance that model {} has a case for",
                                 typical / (2 * std::numbers::pi), model.name()),
                     "name the case with --case, or add a [[case]] to the model");
  }
  if (decays)
    for (const CaseOutline& resonance : model.cases())
      if (!resonance.excited) return resonance.name;
  throw InputError(campaign.folder.string(), "",
                   "has no records that model " + model.name() + " can be identified from",
                   decays ? "its free decays need a case with excitation = false"
                          : "dwells with excitation_frequency_hz or free decays were expected");
}

const CompiledCase& named_case(const CompiledModel& model, const std::string& name) {
  return *std::find_if(model.cases.begin(), model.cases.end(),
                       [&](const CompiledCase& resonance) { return resonance.name == name; });
}

}  // namespace

Identification identify(const IdentificationRequest& request) {
  Identification result;
  const ModelSource source(request.model, request.interpret);
  if (!request.resonance.empty()) require_case(source, request.resonance);
  result.campaign = read_campaign(request.campaign);
  const Campaign& campaign = result.campaign;
  const std::string resonance =
      request.resonance.empty() ? fitting_case(source, campaign, request.window) : request.resonance;
  result.model = source.load({resonance});
  const CompiledModel& model = *result.model;
  result.resonance = &named_case(model, resonance);
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
    return observe_replay(campaign, result.measured, result.estimate.parameter_values, request.threads);
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
