#include "jobs/plan/programme_in_use.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "input/input_error.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/data/campaign.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

void add_dwell(Programme& programme, double hz, double amplitude, int ensembles, double settle_s) {
  PlannedDwell dwell;
  dwell.frequency_hz = hz;
  dwell.amplitude = amplitude;
  dwell.ensembles = ensembles;
  dwell.settle_s = settle_s;
  dwell.responds = false;
  programme.dwells.push_back(std::move(dwell));
}

// At every dwell the stable response with the largest amplitude, level by level.
void find_responses(const DwellEvaluation& evaluation, Programme& programme) {
  std::map<double, std::vector<PlannedDwell*>> levels;
  for (PlannedDwell& dwell : programme.dwells) levels[dwell.amplitude].push_back(&dwell);
  for (auto& [level, dwells] : levels) {
    CandidateRequest request = evaluation.grid();
    request.settle_limit = std::numeric_limits<double>::max();
    request.reached = false;
    request.forcings = {level};
    for (const PlannedDwell* dwell : dwells) request.frequencies.push_back(dwell->frequency_hz / to_hz);
    std::sort(request.frequencies.begin(), request.frequencies.end());
    for (const DwellCandidate& candidate : response_candidates(evaluation.field(), request))
      for (PlannedDwell* dwell : dwells) {
        if (std::abs(candidate.state.frequency * to_hz - dwell->frequency_hz) > 1e-9) continue;
        const auto size = [](const DwellState& state) {
          double sum = 0;
          for (const auto& b : state.amplitude) sum += std::norm(b);
          return sum;
        };
        if (dwell->responds && size(candidate.state) <= size(dwell->candidate.state)) continue;
        dwell->responds = true;
        dwell->candidate = candidate;
        dwell->needed_s = candidate.settle_s;
      }
  }
}

}  // namespace

Programme programme_in_use(const PlanRequest& request, const PlanResult& plan, const DwellEvaluation& evaluation,
                           std::vector<std::string>& warnings) {
  Programme programme;
  programme.name = request.against;
  bool tables = false;
  if (plan.sensors) {
    for (const DwellProgramme& dwells : plan.sensors->dwells)
      for (const std::vector<double>& amplitude : dwells.amplitudes)
        for (const std::vector<double>& hz : dwells.frequencies_hz)
          add_dwell(programme, hz.front(), amplitude.front(), dwells.ensembles, dwells.settle_s);
  } else {
    const Campaign campaign = request.campaign ? *request.campaign : read_campaign(request.against);
    require_match(campaign, request.against_records);
    tables = std::any_of(campaign.records.begin(), campaign.records.end(),
                         [](const RecordEntry& entry) { return entry.row != nullptr; });
    double end = 0;
    for (std::size_t r = 0; r < campaign.records.size(); ++r) {
      const RecordEntry& entry = campaign.records[r];
      if (entry.kind != RecordKind::dwell || !entry.excitation_frequency_hz || !entry.excitation_amplitude)
        continue;
      const Record record = read_record(campaign, entry);
      const double duration = static_cast<double>(record.samples()) / campaign.sample_rate_hz;
      const int ensembles = std::max(1, static_cast<int>(duration / entry.ensemble_s.value_or(duration)));
      const double settle = entry.started_s ? std::max(0.0, *entry.started_s - end) : -1;
      if (request.against_records.takes(r, entry.file))
        add_dwell(programme, *entry.excitation_frequency_hz, *entry.excitation_amplitude, ensembles, settle);
      end = entry.started_s.value_or(end) + duration;
    }
  }
  if (programme.dwells.empty())
    throw InputError(request.against, "", "has no dwells with frequency and amplitude",
                     tables
                         ? "a table of lines does not say how long its dwells took: they cannot be weighed by time"
                         : "nothing to compare with");
  find_responses(evaluation, programme);
  for (PlannedDwell& dwell : programme.dwells)
    if (dwell.settle_s < 0) dwell.settle_s = dwell.needed_s;  // a campaign that does not say when
  evaluation.finish(programme);
  const auto quiet =
      std::count_if(programme.dwells.begin(), programme.dwells.end(), [](const auto& d) { return !d.responds; });
  if (quiet > 0)
    warnings.push_back(
        fmt::format("{} of {} dwells of {} have no stable response: they cost time and say "
                    "nothing here",
                    quiet, programme.dwells.size(), request.against));
  return programme;
}

}  // namespace secular
