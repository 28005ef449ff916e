// Tuned thresholds of measure/ and estimator/ (docs/thresholds.md), each by 1/2 and by 2: what notices it. Groups
// of them that move nothing together are not looked at one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>
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
};

std::vector<Knob> tuned() {
  std::vector<Knob> knobs;
  for (const auto& t : measure_threshold_list)
    if (t.kind == ThresholdKind::tuned)
      knobs.push_back({t.name, [&t](Changed& changed, double by) { changed.measure.multiply(t, by); }});
  for (const auto& t : estimator_threshold_list)
    if (t.kind == ThresholdKind::tuned)
      knobs.push_back({t.name, [&t](Changed& changed, double by) { changed.estimator.multiply(t, by); }});
  return knobs;
}

// What `identify` says.
struct Said {
  std::map<std::string, EstimatedValue> numbers;  // those that have a value
  std::set<std::string> disturbances;
};

// A campaign that was written, and is read anew each time.
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

  // `corrected`: with the expansion's truncation taken out, which takes ten times as long.
  Said said(bool corrected = false) const {
    Said result;
    try {
      DisturbanceWatch watch(campaign_);
      WatchedReader reader(campaign_, watch.look(), [&](std::size_t r, const Record& record, const auto& values) {
        return treatment_of(campaign_, r, record, values);
      });
      const RecordReader read = [&](std::size_t r) { return reader.read(r); };
      const ObservationSet set = made_.resonance->excited
                                     ? observe_dwells(campaign_, read, *made_.model, *made_.resonance, {})
                                     : observe_free_decays(campaign_, read, *made_.model, *made_.resonance, {});
      const MeasuredUnits units{modal_projection(campaign_, *made_.model).unit, {"m/s^2"}};
      Estimate found = estimate(std::span(&set, 1), units, {});
      const auto replay = [&](const ObservationSet& measured, const Eigen::VectorXd& parameters) {
        return observe_replay(campaign_, measured, parameters, 2);
      };
      if (corrected)
        found = correct_truncation(std::span(&set, 1), found, units, {}, replay, [](const char*) {}).estimate;
      for (const EstimatedValue& value : found.parameters)
        if (value.value) result.numbers.emplace(value.name, value);
      for (const Disturbance& disturbance : watch.found())
        result.disturbances.insert(std::string(disturbance.kind) + " " + std::to_string(disturbance.record));
    } catch (const InputError&) {
      result = {};  // nothing is left to estimate from
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
  Sweep(const Folder& folder, double by) : folder_(folder), by_(by), before_(folder.said()) {}

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
  double moves_corrected(std::string_view name, const std::vector<Knob>& knobs) {
    if (corrected_.numbers.empty()) corrected_ = folder_.said(true);
    for (const Knob& knob : knobs)
      if (knob.name == name) return moved(corrected_, with(std::span(&knob, 1), true));
    return INFINITY;
  }

  const Said& before() const { return before_; }

 private:
  Said with(std::span<const Knob> knobs, bool corrected = false) const {
    Changed changed;
    for (const Knob& knob : knobs) knob.turn(changed, by_);
    return folder_.said(corrected);
  }

  const Folder& folder_;
  double by_;
  Said before_, corrected_;
};

// Mains of 2 % in the response, a converter of 60 steps, and once in a while a spike or a sample that is held.
void spoil(MadeCampaign& made) {
  for (Record& record : made.simulated.samples) {
    std::vector<double>& x = record.channels.back();
    double rms = 0;
    for (const double value : x) rms += value * value / static_cast<double>(x.size());
    rms = std::sqrt(rms);
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double turn = 2 * std::numbers::pi * 50 * static_cast<double>(i) / record.sample_rate_hz;
      x[i] = rms / 30 * std::round((x[i] + 0.02 * rms * std::cos(turn)) / (rms / 30));
      if (i % 1709 == 7) x[i] += rms;
      if (i % 701 == 0) x[i] = x[i - 1];
    }
  }
}

// Standard deviations by which a clean campaign's number may move. Windows of a decay twice as short, as
// bins_from_constant makes them, move one of the pendulum by 1.1.
double most_moved(std::string_view name) {
  return name == "bins_from_constant" ? 1.5 : 1;
}

TEST(SlowThresholds, EachByHalfAndByTwice) {
  const std::vector<Knob> knobs = tuned();
  std::set<std::string> unnoticed;
  for (const Knob& knob : knobs) unnoticed.insert(std::string(knob.name));
  for (const char* name : {"principal_parametric", "pendulum_decay"})
    for (const bool clean : {true, false}) {
      MadeCampaign made = make_campaign(name, 3);
      if (!clean) spoil(made);
      const Folder folder(name + std::string(clean ? "" : "_spoilt"), made);
      for (const double by : {0.5, 2.0}) {
        Sweep sweep(folder, by);
        EXPECT_FALSE(sweep.before().numbers.empty());
        for (const auto& [knob, by_how_much] : sweep.noticed(knobs)) {
          unnoticed.erase(knob);
          std::cout << name << (clean ? "" : ", spoilt") << ", x " << by << ": " << knob
                    << " moves numbers by up to " << by_how_much << " sd\n";
          if (clean && by_how_much > most_moved(knob)) {
            EXPECT_LE(sweep.moves_corrected(knob, knobs), most_moved(knob))
                << knob << " by " << by << " in " << name;
          }
        }
      }
    }
  std::cout << "noticed by none of these campaigns:";
  for (const std::string& name : unnoticed) std::cout << ' ' << name;
  std::cout << '\n';
}

}  // namespace
}  // namespace secular
