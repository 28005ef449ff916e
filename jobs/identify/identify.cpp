#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "jobs/identify/following_estimates.hpp"
#include "jobs/identify/full_equations.hpp"
#include "jobs/identify/identification.hpp"
#include "jobs/shared/left_out.hpp"
#include "jobs/shared/record_selection.hpp"

namespace secular {
namespace {

// Dwells at rest are no lost ones: that nothing moves there is what they say.
std::optional<std::string> lost_records(const Identification& id, const Window& window) {
  const std::vector<std::string>& warnings = id.estimate.warnings;
  if (id.full) return mostly_left_out(warnings, id.campaign, records_within(id.campaign, window), id.full->records);
  std::set<std::size_t> given, used;
  for (std::size_t r = 0; r < id.campaign.records.size(); ++r) {
    const RecordEntry& entry = id.campaign.records[r];
    const bool read =
        is_steady(entry.kind) || entry.kind == RecordKind::free_decay || entry.kind == RecordKind::impact;
    if (read && window.takes(r, entry.file)) given.insert(r);
  }
  for (const ObservationSet& set : id.measured)
    for (const auto* observations : {&set.observations, &set.at_rest})
      for (const Observation& o : *observations) used.insert(o.record);
  return mostly_left_out(warnings, id.campaign, given, used);
}

// Options that only the modulation equations have a meaning for.
std::vector<std::string> options_of_modulation(const IdentificationRequest& request) {
  std::vector<std::string> names;
  if (!request.resonances.empty()) names.emplace_back("--case");
  if (request.bootstrap > 0) names.emplace_back("--bootstrap");
  if (request.refine) names.emplace_back("--refine");
  return names;
}

// `left_out`: what the user has to know of records that options leave out.
Equations equations_of(const IdentificationRequest& request, const Campaign& campaign,
                       std::vector<std::string>& left_out) {
  const std::vector<std::string> of_modulation = options_of_modulation(request);
  if ((request.by == Equations::full || request.by == Equations::both) && !of_modulation.empty())
    throw InputError(of_modulation.front(), "", "is of the modulation equations",
                     "leave it out, or --by modulation-equations");
  if (request.by == Equations::both) {
    const std::set<std::size_t> records = records_within(campaign, request.window);
    for (const std::size_t r : records)
      if (campaign.records[r].kind != RecordKind::free_decay)
        throw InputError("--by both-equations", "", campaign.records[r].file + " is no free decay",
                         "free decays alone are refined: choose them with --records");
  }
  if (request.by) return *request.by;
  if (of_modulation.empty()) return equations_for(campaign, request.window);
  const std::set<std::size_t> all = records_within(campaign, request.window),
                              others = without_expansion(campaign, all);
  const std::string words = records_in_words(campaign, others);
  if (!all.empty() && others == all)
    throw InputError(of_modulation.front(), "",
                     fmt::format("is of the modulation equations, which cannot use the records of {} ({})",
                                 campaign.folder.string(), words),
                     "leave it out: the full equations of motion tell the numbers, with error bars");
  if (!others.empty())
    left_out.push_back(fmt::format(
        "{} is of the modulation equations, which leave out {}; without it the full equations take all records",
        of_modulation.front(), words));
  return Equations::modulation;
}

// Excitations behind those that the model has (excitation_channels takes the first ones).
void warn_of_unused_excitations(Identification& id) {
  const std::vector<std::size_t> given = channels_of(id.campaign, ChannelRole::excitation);
  const std::size_t used = id.model->excitations.size();
  if (used == 0 || given.size() <= used) return;
  std::vector<std::string> names;
  for (std::size_t j = used; j < given.size(); ++j) names.push_back(id.campaign.channels[given[j]].name);
  id.estimate.warnings.insert(
      id.estimate.warnings.begin(),
      fmt::format("the model has {} excitation{}; of the channels that excite, {} is not used", used,
                  used == 1 ? "" : "s", fmt::join(names, ", ")));
}

}  // namespace

Equations equations_named(const std::string& name) {
  if (name == "full-equations") return Equations::full;
  if (name == "both-equations") return Equations::both;
  if (name == "modulation-equations") return Equations::modulation;
  throw std::invalid_argument("no equations are called " + name);
}

Identification identify(const IdentificationRequest& request, const Campaign& campaign) {
  std::vector<std::string> left_out;
  const Equations by = equations_of(request, campaign, left_out);
  Identification id = by == Equations::full ? identify_by_full_equations(request, campaign)
                                            : identify_by_modulation(request, campaign);
  if (by == Equations::both) refine_decays(request, id);
  std::vector<std::string>& warnings = id.estimate.warnings;
  warnings.insert(warnings.begin(), left_out.begin(), left_out.end());
  warn_of_unused_excitations(id);
  id.mostly_left_out = lost_records(id, request.window);
  id.following = following_estimates(
      [source = ModelSource(request.model, request.interpret, {})](const std::map<std::string, double>& values) {
        return source.following_coefficients(values);
      },
      id.estimate);
  return id;
}

}  // namespace secular
