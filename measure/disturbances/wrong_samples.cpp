#include "measure/disturbances/wrong_samples.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/fill_gaps.hpp"

namespace secular {
namespace {

std::vector<std::size_t> foreign_firsts(std::span<const double> samples, const WrongSamples& wrong) {
  std::vector<std::size_t> missing = wrong.marks.at, foreign;
  for (const HeldSamples::Run& run : wrong.held.runs)
    for (std::size_t i = run.begin - 1; i < run.end; ++i) missing.push_back(i);
  for (const Impulses::One& spike : wrong.impulses.spikes) missing.push_back(spike.at);
  std::sort(missing.begin(), missing.end());
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  std::vector<double> filled(samples.begin(), samples.end());
  const std::vector<std::size_t> left = fill_gaps(filled, missing);
  for (const HeldSamples::Run& run : wrong.held.runs) {
    const std::size_t first = run.begin - 1;
    if (!std::binary_search(left.begin(), left.end(), first) &&
        std::abs(samples[first] - filled[first]) > wrong.impulses.most_off(first))
      foreign.push_back(first);
  }
  return foreign;
}

// What the samples around a spike tell by their whole motion (fill_gaps) is no spike: a tone of few samples a turn
// is not smooth on the scale of five.
void drop_motion(std::span<const double> samples, std::vector<Impulses::One>& spikes) {
  std::vector<std::size_t> places;
  for (const Impulses::One& spike : spikes) places.push_back(spike.at);
  std::vector<double> filled(samples.begin(), samples.end());
  const std::vector<std::size_t> left = fill_gaps(filled, places);
  std::erase_if(spikes, [&](const Impulses::One& spike) {
    return !std::binary_search(left.begin(), left.end(), spike.at) &&
           2 * std::abs(samples[spike.at] - filled[spike.at]) < spike.size;
  });
}

// A spike that is held stands out as a knock does, in samples that are equal: these count as held.
void hold_spikes(WrongSamples& wrong) {
  HeldSamples& held = wrong.held;
  for (const HeldSamples::Run& run : held.likely) {
    const auto is_of_run = [&](const Impulses::One& knock) {
      return knock.at + 1 >= run.begin && knock.at < run.end;
    };
    if (std::erase_if(wrong.impulses.knocks, is_of_run) == 0) continue;
    const auto place = std::partition_point(held.runs.begin(), held.runs.end(),
                                            [&](const HeldSamples::Run& r) { return r.begin < run.begin; });
    if (place == held.runs.end() || place->begin != run.begin) held.runs.insert(place, run);
  }
}

}  // namespace

WrongSamples find_wrong(std::span<const double> samples, const ChannelValues& values, double false_alarm) {
  WrongSamples wrong;
  wrong.held = find_held(samples, values, false_alarm);
  wrong.impulses = find_impulses(samples, values.grid, wrong.held, false_alarm);
  if (!wrong.impulses.spikes.empty()) drop_motion(samples, wrong.impulses.spikes);
  hold_spikes(wrong);
  wrong.marks = find_lost_marks(samples, values.sorted, wrong.impulses, false_alarm);
  const auto is_mark = [&](std::size_t i) {
    return std::binary_search(wrong.marks.at.begin(), wrong.marks.at.end(), i);
  };
  std::erase_if(wrong.held.runs, [&](const HeldSamples::Run& run) { return is_mark(run.begin); });
  for (auto* list : {&wrong.impulses.spikes, &wrong.impulses.knocks})
    std::erase_if(*list, [&](const Impulses::One& one) { return is_mark(one.at); });
  if (!wrong.held.runs.empty()) wrong.foreign = foreign_firsts(samples, wrong);
  return wrong;
}

}  // namespace secular
