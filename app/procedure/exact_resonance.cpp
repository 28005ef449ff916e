#include "app/procedure/exact_resonance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "numerics/hertz.hpp"
#include "thesis/procedures/jump_frequencies.hpp"
#include "thesis/procedures/rest_instability.hpp"

namespace secular::app {

namespace {

// Mean excitation amplitude of the dwells of some groups.
double level_of(const ProcedureData& test, const std::vector<std::string>& groups) {
  double sum = 0, count = 0;
  for (const DwellMean& dwell : test.dwells)
    if (std::find(groups.begin(), groups.end(), dwell.group) != groups.end()) {
      sum += dwell.forcing;
      ++count;
    }
  return sum / count;
}

}  // namespace

double exact_resonance(const ProcedureData& test, int modes_in_sum) {
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t r = 0; r < test.run.campaign.records.size(); ++r) {
    const RecordEntry& entry = test.run.campaign.records[r];
    if (entry.kind == RecordKind::dwell && entry.excitation_frequency_hz &&
        test.request.window.takes(r, entry.file))
      groups[entry.group].push_back(r);
  }
  std::optional<Onset> forward, reverse;
  std::string forward_group, reverse_group;
  for (const auto& [name, records] : groups) {
    std::vector<SweepDwell> sweep;
    for (const std::size_t r : records) {
      const bool responds =
          std::any_of(test.dwells.begin(), test.dwells.end(), [&](const DwellMean& c) { return c.record == r; });
      sweep.push_back({*test.run.campaign.records[r].excitation_frequency_hz / to_hz, responds});
    }
    const auto rising = [](const SweepDwell& a, const SweepDwell& b) { return a.frequency < b.frequency; };
    const auto falling = [](const SweepDwell& a, const SweepDwell& b) { return a.frequency > b.frequency; };
    if (sweep.size() < 2) continue;
    if (std::is_sorted(sweep.begin(), sweep.end(), rising) && !forward) {
      forward = onset_of(sweep);
      forward_group = name;
    }
    if (std::is_sorted(sweep.begin(), sweep.end(), falling) && !reverse) {
      reverse = onset_of(sweep);
      reverse_group = name;
    }
  }
  if (forward && reverse) {
    const ResonanceCentre centre = resonance_centre(*forward, *reverse);
    ProcedureSection section;
    section.method = "jump_frequencies";
    section.title = "Natural frequency from the two jump frequencies";
    section.text = fmt::format(
        "The state of rest is unstable in an interval that is symmetric about exact resonance (Eq. (5.27), "
        "section "
        "6.4). The forward sweep is quiet at {:.4f} Hz and responds at {:.4f} Hz, the reverse sweep is quiet at "
        "{:.4f} Hz and responds at {:.4f} Hz. Recovered: the mean of the middles of both brackets; as printed: "
        "the "
        "mean of the first frequencies that respond.",
        forward->quiet * to_hz, forward->responds * to_hz, reverse->quiet * to_hz, reverse->responds * to_hz);
    ProcedureRow row;
    row.name = modes_in_sum == 2 ? "omega0" : "omega1 + omega2";
    row.unit = "rad/s";
    row.recovered = centre.bracketed / modes_in_sum;
    row.sd = centre.sd / modes_in_sum;
    row.as_printed = centre.thesis / modes_in_sum;
    row.truth = modes_in_sum == 2 ? test.truth.symbol("omega0") : test.truth.symbol("omega1");
    if (modes_in_sum == 1 && row.truth) row.truth = *row.truth + *test.truth.symbol("omega2");
    // Of known parameters: between the jumps that they make, not those of the sweeps.
    if (test.values_only)
      row.recovered = most_unstable_excitation(*test.run.model, *test.run.resonance, test.truth.parameters(),
                                               level_of(test, {forward_group, reverse_group})) /
                      modes_in_sum;
    section.rows.push_back(row);
    test.run.sections.push_back(std::move(section));
    return centre.bracketed;
  }
  double nominal = 0;
  for (std::size_t k = 0; k < test.run.model->modes(); ++k) nominal += modes_in_sum * test.run.model->nominal[k];
  if (modes_in_sum == 1) nominal = test.run.model->nominal[0] + test.run.model->nominal[1];
  if (!std::isfinite(nominal))
    throw InputError(test.request.campaign, "",
                     "has no forward and reverse sweep that starts quiet and then responds",
                     "add such sweeps (groups of dwells with rising and with falling frequency), or give the model "
                     "a [nominal] frequency");
  test.run.warnings.push_back(
      fmt::format("no forward and reverse sweep that starts quiet and then responds: exact resonance is taken "
                  "from the model's "
                  "nominal numbers, {:.4f} Hz, on which every stiffness here depends",
                  nominal * to_hz));
  return nominal;
}

}  // namespace secular::app
