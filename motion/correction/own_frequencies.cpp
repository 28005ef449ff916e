#include "motion/correction/own_frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "estimator/identification/estimation.hpp"
#include "estimator/identification/instrument_motions.hpp"
#include "estimator/identification/record_order.hpp"
#include "estimator/identification/record_scatter.hpp"
#include "estimator/identification/setting_functions.hpp"
#include "estimator/identification/unsupported_values.hpp"
#include "estimator/thresholds.hpp"
#include "measure/data/campaign_clock.hpp"
#include "measure/observe/common_observations.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

/// Weights hang on the scatter; as few values as there are records do not tell it better.
constexpr double same_scatter = 0.1;
/// That shifts at random are taken to follow an order of their records.
constexpr auto& order_alarm = estimator_thresholds().setting_alarm;
/// The second one has instruments by numbers that scatter has not biased.
constexpr int fewest_scatter_rounds = 2, most_scatter_rounds = 5;

using ModesByCase = std::map<std::string, std::set<std::size_t>>;

const CompiledCase* case_of(const Estimate& estimate, const std::string& name) {
  const auto found = std::find_if(estimate.cases.begin(), estimate.cases.end(),
                                  [&](const CompiledCase* c) { return c->name == name; });
  return found == estimate.cases.end() ? nullptr : *found;
}

// Modes whose balance of frequency dwells do not keep. Its rows draw the coefficients that it shares with that of
// energy, so that this may fail as well until they have their noise.
ModesByCase out_of_balance(const Estimate& estimate) {
  ModesByCase modes;
  for (const CaseLackOfFit& tests : estimate.lack_of_fit)
    for (const LackOfFit& test : tests.equations) {
      const CompiledCase* resonance = case_of(estimate, tests.resonance);
      if (!test.significant || resonance == nullptr || !resonance->excited) continue;
      const RegressorBlock& block = resonance->blocks[test.block];
      if (block.kind != BlockKind::modulation || test.part != EquationPart::in_quadrature) continue;
      modes[tests.resonance].insert(static_cast<std::size_t>(block.mode));
    }
  return modes;
}

// What laws may depend on, most often first. Level and frequency together make the amplitude, by way of the
// record's own natural frequency: functions of all three would follow whatever that is.
VectorXd amplitude_and_level(double amplitude, double level, double /*frequency*/, double time) {
  return VectorXd{{1, amplitude * amplitude, level * level, time, amplitude, level}};
}

VectorXd level_and_frequency(double /*amplitude*/, double level, double frequency, double time) {
  return VectorXd{{1, level * level, time, frequency, level, level * frequency, frequency * frequency}};
}

// Whether what a mode's natural frequency is off in each record comes at random, beside the motions that the
// records would have without, where these are found, of half of the records at least. Of these the amplitude does
// not follow it.
bool comes_at_random(const ObservationSet& set, const std::vector<InstrumentMotion>& common,
                     const ScatterBetweenRecords& scatter, const Campaign& campaign, double tests) {
  const std::vector<double> times = record_times(campaign);
  std::vector<double> own;
  std::vector<DwellPlace> places;
  std::vector<VectorXd> by_amplitude, by_frequency;
  for (std::size_t r = 0; r < scatter.records.size(); ++r) {
    const auto i = static_cast<std::size_t>(
        std::find_if(set.observations.begin(), set.observations.end(),
                     [&](const Observation& at) { return at.record == scatter.records[r]; }) -
        set.observations.begin());
    const Observation& o = set.observations[i];
    const double frequency = o.excitation_frequency.front();
    double level = 0;
    for (const std::complex<double>& force : o.forcing) level = std::hypot(level, std::abs(force));
    places.push_back({campaign.records[o.record].excitation_amplitude.value_or(level), frequency, times[o.record]});
    if (!common[i].found) continue;
    const double amplitude = std::abs(common[i].amplitude[scatter.mode]);
    own.push_back(scatter.shifts[r]);
    by_amplitude.push_back(amplitude_and_level(amplitude, level, frequency, times[o.record]));
    by_frequency.push_back(level_and_frequency(amplitude, level, frequency, times[o.record]));
  }
  if (2 * own.size() <= places.size() || tests * order_p_value(scatter, places) < order_alarm) return false;
  const VectorXd values = Eigen::Map<const VectorXd>(own.data(), static_cast<Eigen::Index>(own.size()));
  const auto at_random = [&](const std::vector<VectorXd>& functions) {
    return follows_settings(values, independent_functions(functions), 2 * tests) == Following::at_random;
  };
  return at_random(by_amplitude) && at_random(by_frequency);
}

// A case of dwells whose natural frequencies may differ, and what its rows say of it beside an estimate.
struct Told {
  std::size_t set;
  const std::set<std::size_t>* modes;
  CaseFit fit;
};

std::vector<Told> what_dwells_tell(const CorrectedEstimate& found, const EstimateTask& task,
                                   const ModesByCase& modes) {
  const Estimation e(found.corrected, task.units, task.options);
  const EstimationState& state = *found.estimate.state;
  CaseKnowledge known = e.knowledge;
  known.natural_frequency = state.natural_frequency;
  for (const auto& [lump, value] : state.frequency_lumps) known.fixed[lump] = value;
  std::vector<Told> result;
  for (std::size_t s = 0; s < e.sets.size(); ++s) {
    const auto here = modes.find(std::string(e.sets[s]->resonance->name));
    if (here == modes.end()) continue;
    result.push_back({static_cast<std::size_t>(e.sets[s] - found.corrected.data()), &here->second,
                      fit_case(*e.sets[s], state.blocks[s], known,
                               {.start = &state.regressions[s], .keep = true, .threads = task.options.threads})});
  }
  return result;
}

// What the natural frequencies of `modes` differ by, beside an estimate, goes into `sets`. The largest change,
// relative; nothing where those of a mode are not told to differ.
std::optional<double> take_scatter(const std::vector<Told>& told, std::vector<ObservationSet>& sets) {
  double change = 0;
  for (const Told& here : told) {
    std::vector<double>& sd = sets[here.set].frequency_scatter;
    if (sd.empty()) sd.resize(sets[here.set].model->modes(), 0.0);
    const RecordScatter scatter = record_scatter(here.fit);
    std::size_t modes = 0;
    for (std::size_t n = 0; n < scatter.frequencies.size(); ++n) {
      const std::size_t mode = scatter.frequencies[n].mode;
      if (!here.modes->contains(mode)) continue;
      if (!(scatter.told[n] > 0)) return std::nullopt;
      change = std::max(change, std::abs(sd[mode] / scatter.told[n] - 1));
      sd[mode] = scatter.told[n];
      ++modes;
    }
    if (modes < here.modes->size()) return std::nullopt;
  }
  return change;
}

// Where columns of dwells are taken beside an estimate, (54).
void take_instruments(const std::vector<Told>& told, std::vector<ObservationSet>& sets) {
  for (const Told& here : told) {
    ObservationSet& own = sets[here.set];
    ObservationSet fitted = *here.fit.set;
    fitted.frequency_scatter = own.frequency_scatter;
    std::vector<InstrumentMotion> motions = instrument_motions(fitted, here.fit.blocks, here.fit.state.at);
    for (Observation& o : own.observations)
      o.instrument = std::make_shared<InstrumentMotion>(InstrumentMotion{o.amplitude, o.rate});
    for_common_observations(own, fitted, [&](std::size_t i, std::size_t at) {
      own.observations[i].instrument = std::make_shared<InstrumentMotion>(std::move(motions[at]));
    });
  }
}

bool come_at_random(const std::vector<Told>& told, const Campaign& campaign) {
  double tests = 0;
  for (const Told& here : told) tests += static_cast<double>(here.modes->size());
  for (const Told& here : told) {
    const std::vector<InstrumentMotion> common =
        instrument_motions(*here.fit.set, here.fit.blocks, here.fit.state.at, TakenOff::all);
    for (const ScatterBetweenRecords& scatter : record_scatter(here.fit).frequencies)
      if (here.modes->contains(scatter.mode) && !comes_at_random(*here.fit.set, common, scatter, campaign, tests))
        return false;
  }
  return true;
}

}  // namespace

void let_frequencies_differ(std::vector<ObservationSet>& sets, const EstimateTask& task, CorrectedEstimate& found) {
  const ModesByCase modes = out_of_balance(found.estimate);
  if (modes.empty() || found.corrected.empty()) return;
  std::vector<ObservationSet> own = sets;
  std::vector<Told> told = what_dwells_tell(found, task, modes);
  CorrectedEstimate freed;
  for (int round = 0; round < most_scatter_rounds; ++round) {
    const std::optional<double> change = take_scatter(told, own);
    if (!change) return;
    if (round >= fewest_scatter_rounds && *change < same_scatter) break;
    take_instruments(told, own);
    freed = estimate_corrected(own, task, round == 0 ? &found.estimate : &freed.estimate);
    if (freed.corrected.empty()) return;
    told = what_dwells_tell(freed, task, modes);
  }
  if (!freed.estimate.correction_settled) return;
  if (!cases_with_lack_of_fit(freed.estimate).empty() || freed.estimate.consistency.significant) return;
  if (!std::all_of(told.begin(), told.end(), [](const Told& here) { return instruments_tell(here.fit); })) return;
  if (!come_at_random(told, task.campaign)) return;
  sets = std::move(own);
  found = std::move(freed);
}

}  // namespace secular
