#include "jobs/shared/record_assignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "input/input_error.hpp"
#include "measure/observe/natural_frequency_starts.hpp"
#include "measure/thresholds.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

bool is_chosen(const std::vector<std::string>& chosen, const std::string& name) {
  return chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end();
}

// Which cases free decays go to. All modes ring together after a pluck, so the case with most of them takes the
// decays, from the first window to the last one in which any of them is seen; of several, one whose resonance
// between the modes the natural frequencies fulfil. Cases of one mode each share the decays out.
std::vector<bool> decay_cases(const ModelSource& model, const std::vector<double>& natural,
                              const std::vector<std::string>& chosen) {
  const std::vector<CaseOutline>& cases = model.cases();
  std::vector<bool> takes(cases.size(), false);
  std::size_t best = cases.size();
  const auto off_resonance = [&](const CaseOutline& resonance) {
    return mismatch({resonance.excited, resonance.relations}, natural, 0);
  };
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const CaseOutline& resonance = cases[c];
    if (resonance.excited) continue;
    if (!chosen.empty()) {
      takes[c] = std::find(chosen.begin(), chosen.end(), resonance.name) != chosen.end() &&
                 (model.modes() > 1 || std::find(takes.begin(), takes.end(), true) == takes.end());
      continue;
    }
    const double off = off_resonance(resonance);  // infinite without relations
    if (std::isfinite(off) && off >= measure_thresholds().largest_detuning) continue;
    if (best == cases.size() || resonance.active_modes > cases[best].active_modes ||
        (resonance.active_modes == cases[best].active_modes && off < off_resonance(cases[best])))
      best = c;
  }
  if (best == cases.size()) return takes;
  takes[best] = true;
  if (cases[best].active_modes == 1 && model.modes() > 1)
    for (std::size_t c = 0; c < cases.size(); ++c) takes[c] = !cases[c].excited && cases[c].active_modes == 1;
  return takes;
}

bool nominal_given(const ModelSource& model) {
  const std::vector<double>& nominal = model.nominal_frequencies();
  return std::all_of(nominal.begin(), nominal.begin() + static_cast<std::ptrdiff_t>(model.modes()),
                     [](double w) { return std::isfinite(w); });
}

}  // namespace

FrequencyStarts frequency_starts(const ModelSource& model, const Campaign& campaign, const RecordReader& read,
                                 const std::vector<double>& nominal, const std::vector<std::string>& chosen,
                                 const Window& window) {
  FrequencyStarts starts;
  for (const CaseOutline& resonance : model.cases())
    starts.cases.push_back({resonance.excited && is_chosen(chosen, resonance.name), resonance.relations});
  starts.dwells = dwell_tones(campaign, read, starts.cases, window);
  NaturalFrequencyStarts found =
      natural_frequency_starts(campaign, read, nominal, starts.cases, starts.dwells, window);
  starts.frequency = std::move(found.frequency);
  starts.moved = std::move(found.moved);
  std::string text;
  for (std::size_t k = 0; k < nominal.size(); ++k)
    if (starts.moved[k])
      text += fmt::format("{}{} is near {:.4g} rad/s, {:.4g} was given", text.empty() ? "" : "; ",
                          model.frequency_names()[k], starts.frequency[k], nominal[k]);
  if (!text.empty())
    starts.warnings.push_back(
        fmt::format("the records resonate elsewhere than at the natural frequencies given, and are sorted by what "
                    "they show: {}{}",
                    text, nominal.size() > 1 ? " (modes go to lines in order of frequency)" : ""));
  return starts;
}

std::shared_ptr<const CompiledModel> with_starts(std::shared_ptr<const CompiledModel> model,
                                                 const FrequencyStarts& starts) {
  if (std::find(starts.moved.begin(), starts.moved.end(), true) == starts.moved.end()) return model;
  struct Started {
    std::shared_ptr<const CompiledModel> base;
    std::vector<double> nominal;
    CompiledModel model;
  };
  auto started = std::make_shared<Started>(
      Started{model, std::vector<double>(model->nominal.begin(), model->nominal.end()), *model});
  for (std::size_t k = 0; k < starts.moved.size(); ++k)
    if (starts.moved[k]) started->nominal[k] = starts.frequency[k];
  started->model.nominal = started->nominal;
  return {started, &started->model};
}

Assignment assign_records(const ModelSource& model, const Campaign& campaign, const FrequencyStarts& starts,
                          const std::vector<std::string>& chosen, const Window& window) {
  const std::vector<CaseOutline>& cases = model.cases();
  std::vector<std::vector<bool>> records(cases.size(), std::vector<bool>(campaign.records.size(), false));
  const auto excited =
      std::count_if(starts.cases.begin(), starts.cases.end(), [](const Resonance& c) { return c.excited; });
  const auto only = static_cast<std::size_t>(
      std::find_if(starts.cases.begin(), starts.cases.end(), [](const Resonance& c) { return c.excited; }) -
      starts.cases.begin());
  const std::vector<bool> decays_to = decay_cases(model, starts.frequency, chosen);
  Assignment result;
  bool dwells = false, decays = false;
  double stray = 0;
  auto tones = starts.dwells.begin();
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    const RecordEntry& entry = campaign.records[r];
    if (!window.takes(r, entry.file)) continue;
    if (entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact) {
      decays = true;
      for (std::size_t c = 0; c < cases.size(); ++c)
        if (decays_to[c]) records[c][r] = true;
    }
    if (!is_steady(entry.kind)) continue;
    dwells = true;
    // A case that was asked for takes every dwell, and one whose natural frequencies nothing determined, or which
    // one frequency does not tell.
    const bool has_several_excitations = model.nominal_frequencies().size() > model.modes() + 1;
    if (excited == 1 && (!chosen.empty() || !nominal_given(model) || has_several_excitations)) {
      records[only][r] = true;
      continue;
    }
    if (!entry.excitation_frequency_hz) {
      result.warnings.push_back(
          fmt::format("{}: a dwell without excitation_frequency_hz belongs to no case, left out", entry.file));
      continue;
    }
    while (tones->record != r) ++tones;
    if (const std::size_t own = case_of_dwell(*tones, starts.cases, starts.frequency).resonance;
        own < cases.size()) {
      records[own][r] = true;
    } else {
      stray = *entry.excitation_frequency_hz;
      result.warnings.push_back(fmt::format(
          "{}: {:.4g} Hz excites no resonance that the model has a case for, left out", entry.file, stray));
    }
  }
  for (std::size_t c = 0; c < cases.size(); ++c)
    if (std::find(records[c].begin(), records[c].end(), true) != records[c].end()) {
      result.names.push_back(cases[c].name);
      result.records.push_back(records[c]);
    }
  if (!result.names.empty()) return result;
  if (dwells)
    throw InputError(campaign.folder.string(), "",
                     stray > 0
                         ? fmt::format("its dwells near {:.4g} Hz excite no resonance that model {} has a case for",
                                       stray, model.name())
                         : "its dwells belong to no case of model " + model.name(),
                     "name the case with --case, or add a [[case]] to the model");
  throw InputError(campaign.folder.string(), "",
                   "has no records that model " + model.name() + " can be identified from",
                   decays ? "its free decays need a case with excitation = false"
                          : "dwells with excitation_frequency_hz or free decays were expected");
}

}  // namespace secular
