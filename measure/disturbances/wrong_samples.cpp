#include "measure/disturbances/wrong_samples.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numerics/fill_gaps.hpp"

namespace secular {
namespace {

// How far samples are off what those around all of `places` tell of them (fill_gaps).
class Told {
 public:
  Told(std::span<const double> samples, const std::vector<std::size_t>& places)
      : samples_(samples), filled_(samples.begin(), samples.end()), left_(fill_gaps(filled_, places)) {}

  // Nothing where nothing tells it.
  std::optional<double> off(std::size_t place) const {
    if (std::binary_search(left_.begin(), left_.end(), place)) return std::nullopt;
    return std::abs(samples_[place] - filled_[place]);
  }

 private:
  std::span<const double> samples_;
  std::vector<double> filled_;
  std::vector<std::size_t> left_;
};

std::vector<std::size_t> foreign_firsts(std::span<const double> samples, const WrongSamples& wrong) {
  std::vector<std::size_t> firsts, foreign;
  for (const HeldSamples::Run& run : wrong.held.runs) firsts.push_back(run.begin - 1);
  const Told told(samples, in_one({wrong.marks.at, firsts, held_places(wrong), places_of(wrong.impulses.spikes)}));
  for (const std::size_t first : firsts)
    if (told.off(first) > wrong.impulses.most_off(first)) foreign.push_back(first);
  return foreign;
}

// What the samples around a spike tell by their whole motion is no spike: a tone of few samples a turn is not
// smooth on the scale of five.
void drop_motion(std::span<const double> samples, std::vector<Impulses::One>& spikes) {
  const Told told(samples, places_of(spikes));
  std::erase_if(spikes, [&](const Impulses::One& spike) {
    const std::optional<double> off = told.off(spike.at);
    return off && 2 * *off < spike.size;
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

std::vector<std::size_t> held_places(const WrongSamples& wrong) {
  std::vector<std::size_t> held = wrong.foreign;
  for (const HeldSamples::Run& run : wrong.held.runs)
    for (std::size_t i = run.begin; i < run.end; ++i) held.push_back(i);
  return held;
}

std::vector<std::size_t> places_of(const std::vector<Impulses::One>& impulses) {
  std::vector<std::size_t> places;
  for (const Impulses::One& one : impulses) places.push_back(one.at);
  return places;
}

std::vector<std::size_t> in_one(std::initializer_list<std::vector<std::size_t>> lists) {
  std::vector<std::size_t> all;
  for (const std::vector<std::size_t>& list : lists) all.insert(all.end(), list.begin(), list.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

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
