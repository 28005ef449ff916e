// Tuned thresholds of measure/ and estimator/ (docs/thresholds.md), each by 1/2 and by 2: what notices it. Groups
// of them that move nothing together are not looked at one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "estimator/thresholds_list.hpp"
#include "input/input_error.hpp"
#include "measure/data/watched_reader.hpp"
#include "measure/disturbances/disturbance_watch.hpp"
#include "measure/disturbances/treatment.hpp"
#include "measure/thresholds_list.hpp"
#include "recovered_campaign.hpp"
#include "tests/changed_thresholds.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

using namespace testing_support;

struct Changed {
  ChangedThresholds<MeasureThresholds> measure;
  ChangedThresholds<EstimatorThresholds> estimator;
};

struct Knob {
  std::string_view name;
  std::function<void(Changed&, double)> turn;
  bool of_measure;  // records are observed with it
};

std::vector<Knob> tuned() {
  std::vector<Knob> knobs;
  for (const auto& t : measure_threshold_list)
    if (t.kind == ThresholdKind::tuned)
      knobs.push_back({t.name, [&t](Changed& changed, double by) { changed.measure.multiply(t, by); }, true});
  for (const auto& t : estimator_threshold_list)
    if (t.kind == ThresholdKind::tuned)
      knobs.push_back({t.name, [&t](Changed& changed, double by) { changed.estimator.multiply(t, by); }, false});
  return knobs;
}

// What `identify` says.
struct Said {
  std::map<std::string, EstimatedValue> numbers;  // those that have a value
  std::set<std::string> disturbances;
};

// What is observed; nothing where no record is left.
struct Seen {
  std::optional<ObservationSet> set;
  std::set<std::string> disturbances;
};

// A campaign that was written, and is read anew whenever it is observed.
class Folder {
 public:
  Folder(const std::string& name, const MadeCampaign& made) : made_(made) {
    const std::filesystem::path path = process_folder() / name;
    CampaignWriter writer(path);
    const SimulatedCampaign& simulated = made.simulated;
    for (std::size_t r = 0; r < simulated.samples.size(); ++r)
      writer.write(simulated.campaign, simulated.campaign.records[r], simulated.samples[r]);
    writer.finish(simulated.campaign);
    campaign_ = read_campaign(path);
  }

  Seen seen() const {
    Seen result;
    try {
      DisturbanceWatch watch(campaign_);
      WatchedReader reader(campaign_, watch.look(), [&](std::size_t r, const Record& record, const auto& values) {
        return treatment_of(campaign_, r, record, values);
      });
      const RecordReader read = [&](std::size_t r) { return reader.read(r); };
      result.set = made_.resonance->excited
                       ? observe_dwells(campaign_, read, *made_.model, *made_.resonance, {})
                       : observe_free_decays(campaign_, read, *made_.model, *made_.resonance, {});
      for (const Disturbance& disturbance : watch.found())
        result.disturbances.insert(std::string(disturbance.kind) + " " + std::to_string(disturbance.record));
    } catch (const InputError&) {
      result = {};
    }
    return result;
  }

  // `corrected`: with the expansion's truncation taken out, which takes ten times as long.
  Said said(const Seen& seen, bool corrected = false) const {
    Said result;
    if (!seen.set) return result;
    try {
      const MeasuredUnits units{modal_projection(campaign_, *made_.model).unit, {"m/s^2"}};
      const std::span<const ObservationSet> sets(&*seen.set, 1);
      Estimate found = estimate(sets, units, {});
      const auto replay = [&](const ObservationSet& measured, const Eigen::VectorXd& parameters) {
        return observe_replay(campaign_, measured, parameters, 2);
      };
      if (corrected) found = correct_truncation(sets, found, units, {}, replay, [](const char*) {}).estimate;
      for (const EstimatedValue& value : found.parameters)
        if (value.value) result.numbers.emplace(value.name, value);
      result.disturbances = seen.disturbances;
    } catch (const NothingObserved&) {
      result = {};
    }
    return result;
  }

 private:
  const MadeCampaign& made_;
  Campaign campaign_;
};

// In standard deviations, of numbers that both tell.
double moved(const Said& from, const Said& to) {
  double most = 0;
  for (const auto& [name, value] : from.numbers)
    if (const auto other = to.numbers.find(name); other != to.numbers.end())
      most = std::max(most, std::abs(*other->second.value - *value.value) / std::max(value.sd, other->second.sd));
  return most;
}

// More than a tenth of a standard deviation, an error bar by 5 %, or what is told.
bool notices(const Said& from, const Said& to) {
  if (from.disturbances != to.disturbances || from.numbers.size() != to.numbers.size() || moved(from, to) > 0.1)
    return true;
  for (const auto& [name, value] : from.numbers) {
    const auto other = to.numbers.find(name);
    if (other == to.numbers.end() || other->second.doubtful != value.doubtful) return true;
    if (std::abs(std::log(other->second.sd / value.sd)) > 0.05) return true;
  }
  return false;
}

class Sweep {
 public:
  Sweep(const Folder& folder, double by)
      : folder_(folder), by_(by), seen_(folder.seen()), before_(folder.said(seen_)) {}

  /// By name, what each of the knobs that are noticed moves.
  std::map<std::string, double> noticed(std::span<const Knob> knobs) const {
    std::map<std::string, double> found;
    const Said after = with(knobs);
    if (!notices(before_, after)) return found;
    if (knobs.size() == 1) return {{std::string(knobs[0].name), moved(before_, after)}};
    const std::size_t half = knobs.size() / 2;
    found = noticed(knobs.first(half));
    found.merge(noticed(knobs.subspan(half)));
    return found;
  }

  // What one of them moves when the truncation is taken out: what it leaves depends on the length of windows.
  double moves_corrected(const Knob& knob) {
    if (corrected_.numbers.empty()) corrected_ = folder_.said(seen_, true);
    return moved(corrected_, with(std::span(&knob, 1), true));
  }

  const Said& before() const { return before_; }

 private:
  // Records are observed anew only where one of the knobs has a part in that.
  Said with(std::span<const Knob> knobs, bool corrected = false) const {
    Changed changed;
    for (const Knob& knob : knobs) knob.turn(changed, by_);
    const bool anew = std::any_of(knobs.begin(), knobs.end(), [](const Knob& knob) { return knob.of_measure; });
    return folder_.said(anew ? folder_.seen() : seen_, corrected);
  }

  const Folder& folder_;
  double by_;
  Seen seen_;
  Said before_, corrected_;
};

// Mains of 2 % in the response, a converter of 60 steps, and once in a while a spike or a sample that is held, as
// often in a turn of the pendulum as in so many of the dwells.
void spoil(MadeCampaign& made) {
  const bool dwells = made.resonance->excited;
  const std::size_t from_spike_to_spike = dwells ? 1709 : 427, from_held_to_held = dwells ? 701 : 175;
  for (Record& record : made.simulated.samples) {
    std::vector<double>& x = record.channels.back();
    double rms = 0;
    for (const double value : x) rms += value * value / static_cast<double>(x.size());
    rms = std::sqrt(rms);
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double turn = 2 * std::numbers::pi * 50 * static_cast<double>(i) / record.sample_rate_hz;
      x[i] = rms / 30 * std::round((x[i] + 0.02 * rms * std::cos(turn)) / (rms / 30));
      if (i % from_spike_to_spike == 7) x[i] += rms;
      if (i % from_held_to_held == 0) x[i] = x[i - 1];
    }
  }
}

// Standard deviations by which a clean campaign's number may move. Windows of a decay twice as short, as
// bins_from_constant makes them, move one of the pendulum by 1.1.
double most_moved(std::string_view name) {
  return name == "bins_from_constant" ? 1.5 : 1;
}

// Spoilt records of a pendulum that is sampled 270 times in a turn show what those of the shipped one do with four
// times as many samples; so do dwells of half as many ensembles.
MadeCampaign campaign_of(const std::string& name, bool clean) {
  Experiment experiment = shipped_experiment(name);
  if (!experiment.free_decays.empty() && !clean) experiment.sample_rate_hz = 250;
  if (!clean)
    for (DwellProgramme& dwell : experiment.dwells) dwell.ensembles = 5;
  MadeCampaign made = make_campaign(std::move(experiment), 3);
  if (!clean) spoil(made);
  return made;
}

TEST(SlowThresholds, EachByHalfAndByTwice) {
  const std::vector<Knob> knobs = tuned();
  const auto of_estimator =
      std::find_if(knobs.begin(), knobs.end(), [](const Knob& knob) { return !knob.of_measure; });
  std::map<std::string, const Knob*> unnoticed;
  for (const Knob& knob : knobs) unnoticed[std::string(knob.name)] = &knob;
  const std::map<std::string, const Knob*> by_name = unnoticed;
  for (const char* name : {"principal_parametric", "pendulum_decay"})
    for (const bool clean : {true, false}) {
      const MadeCampaign made = campaign_of(name, clean);
      const Folder folder(name + std::string(clean ? "" : "_spoilt"), made);
      for (const double by : {0.5, 2.0}) {
        Sweep sweep(folder, by);
        EXPECT_FALSE(sweep.before().numbers.empty());
        std::map<std::string, double> noticed = sweep.noticed({knobs.begin(), of_estimator});
        noticed.merge(sweep.noticed({of_estimator, knobs.end()}));
        for (const auto& [knob, by_how_much] : noticed) {
          unnoticed.erase(knob);
          std::cout << name << (clean ? "" : ", spoilt") << ", x " << by << ": " << knob
                    << " moves numbers by up to " << by_how_much << " sd\n";
          if (clean && by_how_much > most_moved(knob)) {
            EXPECT_LE(sweep.moves_corrected(*by_name.at(knob)), most_moved(knob))
                << knob << " by " << by << " in " << name;
          }
        }
      }
    }
  std::cout << "noticed by none of these campaigns:";
  for (const auto& [name, knob] : unnoticed) std::cout << ' ' << name;
  std::cout << '\n';
}

}  // namespace
}  // namespace secular
