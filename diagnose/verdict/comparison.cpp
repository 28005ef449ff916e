#include "diagnose/verdict/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <set>
#include <span>

#include "diagnose/evidence/line_evidence.hpp"
#include "diagnose/evidence/observe_conditions.hpp"
#include "diagnose/evidence/unresolved_blows.hpp"
#include "diagnose/verdict/first_frequencies.hpp"
#include "diagnose/verdict/start_values.hpp"
#include "estimator/identification/short_list.hpp"
#include "input/input_error.hpp"
#include "measure/data/false_alarm.hpp"
#include "measure/disturbances/lines.hpp"
#include "measure/observe/record_window.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// In what the model leaves of one record lines are looked for in so many at most.
constexpr Index most_searched_samples = 8192;

// Reads records and notes how many samples of each are within a window.
class CountingReader {
 public:
  CountingReader(const RecordReader& read, const Window& window) : read_(read), window_(window) {}

  Record operator()(std::size_t index) {
    Record record = read_(index);
    if (record.row) {
      samples_[index] = 1;  // as its condition counts it
      return record;
    }
    const auto range = range_of(record, window_);
    samples_[index] = range.count;
    const double from = record.start_s + static_cast<double>(range.first) / record.sample_rate_hz;
    spans_[index] = {from, from + static_cast<double>(range.count - 1) / record.sample_rate_hz};
    return record;
  }

  Index samples() const {
    return std::accumulate(samples_.begin(), samples_.end(), Index{0},
                           [](Index sum, const auto& record) { return sum + record.second; });
  }

  const std::map<std::size_t, TimeSpan>& spans() const { return spans_; }

 private:
  const RecordReader& read_;
  const Window& window_;
  std::map<std::size_t, Index> samples_;  // by record
  std::map<std::size_t, TimeSpan> spans_;
};

Index compared_samples(const std::vector<Condition>& conditions, const std::vector<Segment>& segments) {
  Index sum = 0;
  for (const Condition& condition : conditions) sum += condition.samples;
  for (const Segment& segment : segments) sum += segment.response.cols();
  return sum;
}

std::vector<double> natural_frequencies(const CompiledModel& model, const DiagnosisOptions& options,
                                        const VectorXd& start) {
  std::vector<double> natural;
  for (std::size_t k = 0; k < model.modes(); ++k) {
    const double seen = seen_frequency(options, k);
    natural.push_back(std::isfinite(seen) ? seen : start(static_cast<Index>(k)));
  }
  return natural;
}

// Of the modes whose natural frequency is fitted and that nothing but the model's nominal value tells.
std::vector<std::size_t> modes_unseen(const CampaignAndModel& sides, const DiagnosisOptions& options) {
  std::vector<std::size_t> modes;
  for (std::size_t k = 0; k < sides.model.modes(); ++k) {
    const std::string name(sides.model.symbols[k].name);
    const bool is_told = std::isfinite(seen_frequency(options, k)) || options.start.contains(name) ||
                         options.given.values.contains(name);
    if (!is_told && std::find(sides.own.begin(), sides.own.end(), k) != sides.own.end()) modes.push_back(k);
  }
  return modes;
}

// Of `start`, those that nothing but nominal values tells by the first turns of free decays.
VectorXd with_first_frequencies(const VectorXd& start, const CampaignAndModel& sides, const SensorModel& sensors,
                                const FaultTable& faults, const DiagnosisOptions& options) {
  const std::vector<std::size_t> modes = modes_unseen(sides, options);
  if (modes.empty()) return start;
  const std::vector<double> natural = natural_frequencies(sides.model, options, start);
  std::vector<std::string> said_again;  // when they are cut
  SegmentCut cut{options.window, SegmentLength::turns, options.most_samples};
  std::vector<Segment> turns =
      first_turns(cut_segments(sides.campaign, sides.read, sensors, natural, cut, said_again), natural);
  if (turns.empty()) return start;
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<SegmentEvidence>(sides.model, options.forces, sensors, faults, std::move(turns),
                                                    options.threads));
  return first_frequencies(discrepancy, start, modes, options.threads);
}

// Velocities and accelerations of a motion that lasts have no mean: what is there is the sensor's. No row sees that
// of a zero that wanders.
std::vector<std::size_t> offsets_of_derivatives(const CompiledModel& model, const SensorModel& sensors,
                                                const FaultTable& faults, const WanderingZeros& wandering) {
  std::vector<std::size_t> offsets;
  for (std::size_t c = 0; c < sensors.responses.size() && sensors.derivatives > 0; ++c)
    if (!wandering.contains(sensors.responses[c])) offsets.push_back(model.symbols.size() + faults.offset(c));
  return offsets;
}

// Offsets of zeros that wander.
bool is_wandering_offset(const Candidate& candidate, const CompiledModel& model, const SensorModel& sensors,
                         const FaultTable& faults, const WanderingZeros& wandering) {
  for (std::size_t c = 0; c < sensors.responses.size(); ++c)
    if (wandering.contains(sensors.responses[c]) &&
        candidate.strengths == std::vector{model.symbols.size() + faults.offset(c)})
      return true;
  return false;
}

InputError nothing_to_compare(const Campaign& campaign, const CompiledModel& model,
                              const std::vector<std::string>& warnings) {
  return InputError(campaign.folder.string(), "",
                    "holds no record that model " + std::string(model.name) + " can be compared with" +
                        (warnings.empty() ? "" : " (" + warnings.front() + ")"),
                    "settled dwells, free decays, sweeps or broadband records near the model's resonances are "
                    "expected");
}

// By record that is driven: standard deviation of a time anywhere within a period of the excitation, s.
std::map<std::size_t, double> unknown_lateness(const std::vector<Condition>& conditions) {
  std::map<std::size_t, double> unknown;
  for (const Condition& condition : conditions)
    if (const double frequency = condition.excitation_frequency(); frequency > 0)
      unknown[condition.record] = 2 * std::numbers::pi / frequency / std::sqrt(12.0);
  return unknown;
}

BetweenSamples between_samples(const Campaign& campaign, const std::vector<Segment>& segments,
                               const std::vector<double>& natural) {
  BetweenSamples blows;
  std::vector<const Segment*> of_blows;
  for (const Segment& s : segments)
    if (campaign.records[s.record].kind == RecordKind::impact && s.excitation.cols() > 0) of_blows.push_back(&s);
  for (const double frequency : natural)
    if (const double share = unresolved_share(of_blows, frequency); share > blows.share)
      blows = {{}, share, frequency};
  if (blows.share == 0) return blows;
  for (const Segment* s : of_blows) blows.records.insert(s->record);
  // Blows that are alike may be off alike: the mean of all is not known better than one.
  blows.share = std::min(1.0, blows.share * std::sqrt(static_cast<double>(blows.records.size())));
  return blows;
}

// Laws with an exponent: a strength then has much the same size whatever the exponent.
void set_scales(std::vector<StateForce>& forces, const VectorXd& largest, const std::vector<double>& natural) {
  for (StateForce& force : forces) {
    const double displacement = std::max(0.5 * largest(static_cast<Index>(force.mode)), 1e-300);
    force.scale = force.law.of_velocity ? displacement * natural[force.mode] : displacement;
  }
}

void note_scales(const std::vector<StateForce>& forces, std::vector<Candidate>& candidates) {
  for (const StateForce& force : forces)
    for (Candidate& c : candidates)
      if (c.equation && c.strengths.front() == force.strength_symbol) {
        if (force.law.is_power) c.power_scale = force.scale;
        if (force.law.is_slider()) c.slip_scale = force.stiffness_scale();
      }
}

void check_left_out(const std::set<std::string>& left_out, const EffectCatalogue& catalogue) {
  const std::vector<std::string> names = effect_names(catalogue);
  for (const std::string& name : left_out)
    if (!std::binary_search(names.begin(), names.end(), name))
      throw InputError("--without " + name, "", "is no effect of the catalogue",
                       fmt::format("one of {} is expected", fmt::join(names, ", ")));
}

std::string unsteady_warning(const Unsteadiness& unsteady) {
  return fmt::format(
      "motion varies within dwells by {:.2g} times what the noise beside it explains (p = {:.1g}, "
      "most in {}) though the excitation is steady: a force that no channel records, or a structure "
      "that changes from minute to minute, which no effect of the catalogue does",
      unsteady.ratio, unsteady.p_value, unsteady.record);
}

// Whether most of what drives a record are lines of its spectrum.
bool is_driven_by_lines(const Campaign& campaign, const Record& record) {
  double in_lines = 0, in_all = 0;
  for (std::size_t c = 0; c < campaign.channels.size() && c < record.channels.size(); ++c) {
    if (campaign.channels[c].role != ChannelRole::excitation) continue;
    const std::span<const double> samples = std::span(record.channels[c]).first(record.channels[c].size() / 2 * 2);
    const Eigen::Map<const VectorXd> reading(samples.data(), static_cast<Index>(samples.size()));
    if (!reading.allFinite()) continue;
    in_all += (reading.array() - reading.mean()).square().mean();
    for (const Line& line : find_lines(samples, record.sample_rate_hz, false_alarm_of_channel(campaign)))
      in_lines += 0.5 * line.amplitude * line.amplitude;
  }
  return 2 * in_lines > in_all;
}

}  // namespace

std::vector<std::size_t> Comparison::fitted_beside(std::vector<std::size_t> own) const {
  own.insert(own.end(), nuisances.begin(), nuisances.end());
  return own;
}

ConditionModel Comparison::condition_model(const CompiledModel& model) const {
  return ConditionModel(MotionBalance(model, forces), sensors, faults);
}

std::vector<std::string> Comparison::unknown_names(const CompiledModel& model) const {
  std::vector<std::string> names;
  for (const auto& symbol : model.symbols) names.emplace_back(symbol.name);
  names.insert(names.end(), faults.names().begin(), faults.names().end());
  return names;
}

Comparison compare(const CampaignAndModel& sides, const std::vector<EquationEffect>& effects,
                   const DiagnosisOptions& options) {
  const Campaign& campaign = sides.campaign;
  const CompiledModel& model = sides.model;
  const SensorModel sensors = sensor_model(campaign, model, model.excitations.size() - options.forces.size());
  const FaultTable faults(model, sensors);
  check_given(options.given, model, sides.own);
  Comparison result{.forces = options.forces,
                    .sensors = sensors,
                    .faults = faults,
                    .nuisances = offsets_of_derivatives(model, sensors, faults, options.wandering),
                    .start = start_values(model, faults, options, sides.own),
                    .conditions = {},
                    .candidates = {},
                    .discrepancy = {},
                    .of_records = {},
                    .apart = {},
                    .unsteady = {},
                    .spans = {},
                    .warnings = {}};
  result.start = with_first_frequencies(result.start, sides, sensors, faults, options);
  const std::vector<double> natural = natural_frequencies(model, options, result.start);
  CountingReader counting(sides.read, options.window);
  const RecordReader counted = [&](std::size_t r) { return counting(r); };
  ObservedConditions observed =
      observe_conditions({campaign, model, sensors, natural, options.window, options.wandering}, counted);
  result.warnings = std::move(observed.warnings);
  const auto cut = [&](const Window& window, SegmentLength length) {
    return cut_segments(campaign, counted, sensors, natural,
                        {window, length, options.most_samples, options.wandering, options.tones, options.coloured,
                         options.blows_as_decays, options.whole_decays, options.skips_blows},
                        result.warnings);
  };
  std::vector<Segment> segments = cut(options.window, SegmentLength::turns);
  result.of_records.of_blows = between_samples(campaign, segments, natural);
  if (observed.conditions.empty() && segments.empty()) throw nothing_to_compare(campaign, model, result.warnings);
  result.conditions = std::move(observed.conditions);
  result.segments = segments.size();
  const std::vector<std::string> left_out =
      leave_out_unsteady(result.conditions, observed.nonstationarity, campaign);
  if (!left_out.empty())
    result.warnings.push_back(fmt::format("left out because their motion is not steady: {}", short_list(left_out)));
  result.unsteady = judge_steadiness(observed.nonstationarity, campaign);
  if (result.unsteady.detected) result.warnings.push_back(unsteady_warning(result.unsteady));
  result.data_used =
      static_cast<double>(compared_samples(result.conditions, segments)) / static_cast<double>(counting.samples());
  result.spans = counting.spans();
  const LargestMotions largest = largest_motions(result.conditions, segments, sensors, natural);
  if (!options.keeps_scales) set_scales(result.forces, largest.displacement, natural);
  result.candidates =
      candidates_of(options.catalogue, effects, {model, sensors, faults, result.conditions, segments, largest});
  note_scales(result.forces, result.candidates);
  check_left_out(options.left_out, options.catalogue);
  std::erase_if(result.candidates, [&](const Candidate& c) {
    return options.left_out.contains(c.effect) || is_wandering_offset(c, model, sensors, faults, options.wandering);
  });
  if (!result.conditions.empty())
    result.discrepancy.add(std::make_unique<LineEvidence>(result.condition_model(model), result.conditions,
                                                          result.start, options.threads));
  if (!segments.empty()) {
    auto evidence = std::make_unique<SegmentEvidence>(model, result.forces, sensors, faults, std::move(segments),
                                                      options.threads);
    result.segment_evidence = evidence.get();
    result.discrepancy.add(std::move(evidence));
  }
  result.of_records.delay = model.symbols.size() + faults.delay(sensors.responses.size());
  if (options.late) result.of_records.delay_sd = unknown_lateness(result.conditions);
  result.of_records.frequency_sd = options.frequency_scatter;
  result.discrepancy.admit(result.of_records);
  if (options.check) {
    std::vector<Segment> apart = cut(*options.check, SegmentLength::whole);
    if (apart.empty())
      throw InputError("--check-from, --check-to", "",
                       "hold no part of a free decay, sweep or broadband record of " + campaign.folder.string(),
                       "a window in seconds of the records' own time is expected");
    result.apart.emplace(model, result.forces, sensors, faults, std::move(apart), options.threads);
  }
  return result;
}

std::vector<SegmentEvidence::Left> left_of_records(const CampaignAndModel& sides, const Comparison& comparison,
                                                   const DiagnosisOptions& options, const VectorXd& unknowns) {
  std::vector<std::string> said_before;
  std::set<std::size_t> by_lines;
  const RecordReader read = [&](std::size_t r) {
    Record record = sides.read(r);
    if (is_driven_by_lines(sides.campaign, record)) by_lines.insert(r);
    return record;
  };
  std::vector<Segment> segments = cut_segments(
      sides.campaign, read, comparison.sensors, natural_frequencies(sides.model, options, comparison.start),
      {options.window, SegmentLength::turns, std::numeric_limits<Index>::max(), options.wandering, options.tones,
       options.coloured, options.blows_as_decays, options.whole_decays, options.skips_blows},
      said_before);
  std::erase_if(segments, [&](const Segment& s) { return s.excitation.cols() > 0 && by_lines.contains(s.record); });
  if (segments.empty()) return {};
  std::map<std::size_t, Index> samples;  // so far, by record
  std::erase_if(segments, [&](const Segment& s) {
    Index& before = samples[s.record];
    const bool is_first = before == 0;
    before += s.response.cols();
    return !is_first && before > most_searched_samples;
  });
  SegmentEvidence evidence(sides.model, comparison.forces, comparison.sensors, comparison.faults,
                           std::move(segments), options.threads);
  evidence.freeze(unknowns, 0);
  return evidence.left(unknowns);
}

std::vector<std::string> disturbed_records(const Comparison& comparison, const Campaign& campaign) {
  std::vector<std::string> warnings;
  if (!comparison.segment_evidence) return warnings;
  for (const SegmentEvidence::Disturbed& d : comparison.segment_evidence->disturbed()) {
    std::vector<std::string> times;
    for (const double t : d.worst_s) times.push_back(fmt::format("{:.1f} s", t));
    warnings.push_back(
        fmt::format("{}: what the model leaves in its {} segments follows no law of the amplitude (slips of the "
                    "clock, knocks?){}; it counts as disturbance of the record",
                    campaign.records[d.record].file, d.segments,
                    times.empty() ? "" : fmt::format(", most of it about {}", fmt::join(times, ", "))));
  }
  return warnings;
}

}  // namespace secular
