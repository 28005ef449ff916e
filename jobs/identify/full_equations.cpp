#include "jobs/identify/full_equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "input/input_error.hpp"
#include "input/nearest_word.hpp"
#include "input/numerical_failure.hpp"
#include "jobs/shared/compared_records.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/disturbances/disturbance_watch.hpp"
#include "measure/observe/modal_projection.hpp"

namespace secular {
namespace {

/// Samples of decays, sweeps and broadband records that are compared, in all: time and memory go with them.
constexpr Eigen::Index most_samples = 100000;

bool holds_any(const Campaign& campaign, const Window& window, const auto& of_kind) {
  for (std::size_t r = 0; r < campaign.records.size(); ++r)
    if (window.takes(r, campaign.records[r].file) && of_kind(campaign.records[r].kind)) return true;
  return false;
}

bool has_no_expansion(RecordKind kind) {
  return kind == RecordKind::sweep || kind == RecordKind::broadband;
}

// Symbols that are fitted; the fixed ones are known.
std::vector<std::size_t> fitted_symbols(const CompiledModel& model, const std::map<std::string, double>& fixed) {
  std::vector<std::size_t> fitted;
  std::size_t known = 0;
  for (std::size_t s = 0; s < model.symbols.size(); ++s)
    if (fixed.contains(std::string(model.symbols[s].name)))
      ++known;
    else
      fitted.push_back(s);
  if (known == fixed.size()) return fitted;
  std::vector<std::string> names;
  for (const CompiledSymbol& symbol : model.symbols) names.emplace_back(symbol.name);
  for (const auto& [name, value] : fixed)
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InputError("--fix " + name, "", "is no symbol of model " + std::string(model.name),
                       remedy_for_word(fmt::format("one of {} is expected (lumps are of the modulation equations)",
                                                   fmt::join(names, ", ")),
                                       name, names));
  return fitted;
}

}  // namespace

Equations equations_for(const Campaign& campaign, const Window& window) {
  const bool is_driven = std::any_of(campaign.channels.begin(), campaign.channels.end(),
                                     [](const Channel& c) { return c.role == ChannelRole::excitation; });
  const bool any = holds_any(campaign, window, [&](RecordKind kind) {
    return has_no_expansion(kind) || (kind == RecordKind::impact && is_driven);
  });
  return any ? Equations::full : Equations::modulation;
}

bool holds_dwells_or_decays(const Campaign& campaign, const Window& window) {
  return holds_any(campaign, window,
                   [](RecordKind kind) { return is_steady(kind) || kind == RecordKind::free_decay; });
}

std::set<std::size_t> without_expansion(const Campaign& campaign, std::set<std::size_t> records) {
  std::erase_if(records, [&](std::size_t r) { return !has_no_expansion(campaign.records[r].kind); });
  return records;
}

std::map<std::string, double> start_by_modulation(const IdentificationRequest& request, const Campaign& campaign,
                                                  std::string& why) {
  std::map<std::string, double> start;
  if (!holds_dwells_or_decays(campaign, request.window)) return start;
  try {
    for (const EstimatedValue& value : identify_by_modulation(request, campaign).estimate.parameters)
      if (value.value && std::isfinite(*value.value)) start.emplace(value.name, *value.value);
  } catch (const InputError& error) {
    why = error.what();
  } catch (const NumericalFailure& failure) {
    why = failure.what();
  }
  return start;
}

FullFit fit_full_equations(const IdentificationRequest& request, const Identification& id,
                           const ModelSource& source, const std::vector<std::map<std::string, double>>& begins) {
  DisturbanceWatch watch(id.campaign);
  SelectedRecords reader(id.campaign, request.window, watch.look());
  const RecordReader read = [&](std::size_t r) { return reader.read(r); };
  DiagnosisOptions options;
  options.window = request.window;
  options.threads = request.threads;
  options.most_samples = most_samples;
  options.skips_blows = true;
  options.start = request.fixed;
  FullFit fit{{}, start_frequencies(source, id.campaign, read, options).warnings, 0};
  std::vector<Disturbance> found = found_in_records(id.campaign, request.window, reader, watch);
  const CampaignAndModel sides{id.campaign, read, *id.model, fitted_symbols(*id.model, request.fixed)};
  fit.of = estimate_by_full_equations(sides, options, begins, std::move(found), request.progress);
  for (std::string& warning : reader.warnings()) fit.warnings.push_back(std::move(warning));
  fit.looked_at = watch.records();
  return fit;
}

Identification identify_by_full_equations(const IdentificationRequest& request, const Campaign& campaign) {
  Identification id;
  const ModelSource source(request.model, request.interpret, request.note);
  id.campaign = campaign;
  id.model = source.load({});
  std::vector<std::map<std::string, double>> begins;
  std::string no_start;
  begins.push_back(start_by_modulation(request, campaign, no_start));
  if (begins.back().empty()) begins.clear();
  begins.push_back({});
  FullFit fit = fit_full_equations(request, id, source, begins);
  FullEstimate& full = id.full.emplace(std::move(fit.of));
  id.estimate = std::move(full.estimate);
  id.disturbances = std::move(full.disturbances);
  id.estimate.warnings.insert(id.estimate.warnings.end(), fit.warnings.begin(), fit.warnings.end());
  if (!full.has_converged && !no_start.empty())
    id.estimate.warnings.push_back("dwells and free decays give no start by the modulation equations: " + no_start);
  id.looked_at = fit.looked_at;
  id.coordinate_unit = modal_projection(id.campaign, *id.model).unit;
  return id;
}

std::string records_in_words(const Campaign& campaign, const std::set<std::size_t>& records) {
  std::map<RecordKind, std::size_t> counts;
  for (const std::size_t r : records) ++counts[campaign.records[r].kind];
  std::vector<std::pair<RecordKind, std::size_t>> kinds(counts.begin(), counts.end());
  std::stable_sort(kinds.begin(), kinds.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<std::string> words;
  for (const auto& [kind, count] : kinds) {
    std::string word = to_string(kind);
    std::replace(word.begin(), word.end(), '_', ' ');
    if (count > 1 && kind == RecordKind::broadband) word += " record";
    words.push_back(fmt::format("{} {}{}", count, word, count > 1 && kind != RecordKind::lines ? "s" : ""));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace secular
