#include "app/diagnose/lateness.hpp"

#include <algorithm>

#include "app/shared/identification.hpp"
#include "input/input_error.hpp"

namespace secular::app {

bool can_be_late(const Campaign& campaign, const CompiledModel& model) {
  const bool one_excitation =
      std::count_if(campaign.channels.begin(), campaign.channels.end(),
                    [](const Channel& channel) { return channel.role == ChannelRole::excitation; }) == 1;
  return one_excitation && !model.excitations.empty() &&
         std::any_of(campaign.records.begin(), campaign.records.end(),
                     [](const RecordEntry& record) { return record.kind == RecordKind::dwell; });
}

Lateness find_lateness(const DiagnosisRequest& request) {
  IdentificationRequest wanted;
  wanted.campaign = request.campaign;
  wanted.model = request.model;
  wanted.interpret = request.interpret;
  wanted.window = request.window;
  wanted.threads = request.threads;
  Identification id;
  try {
    id = identify(wanted);
  } catch (const InputError&) {
    return {};  // the model as it is cannot be identified from these records
  }
  Lateness result;
  for (const CaseLateness& of_case : id.freed) {
    if (of_case.finding != PhaseFinding::shifted) continue;
    for (const RecordLateness& record : of_case.records) {
      result.late_s[record.record] = record.late_s;
      result.period_s[record.record] = record.period_s;
    }
  }
  result.holds = std::any_of(id.lateness.begin(), id.lateness.end(),
                             [](const CaseLateness& of_case) { return of_case.finding == PhaseFinding::shifted; });
  return result;
}

}  // namespace secular::app
