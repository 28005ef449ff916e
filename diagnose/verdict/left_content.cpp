#include "diagnose/verdict/left_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "measure/data/false_alarm.hpp"
#include "measure/disturbances/left_lines.hpp"
#include "measure/disturbances/lines.hpp"
#include "measure/disturbances/noise_colour.hpp"
#include "measure/disturbances/searched_record.hpp"
#include "numerics/distribution.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

// Lines are told apart by the window's main lobe.
bool are_one_tone(const Disturbance& a, const Disturbance& b) {
  const double shorter_s = std::min(a.to_s - a.from_s, b.to_s - b.from_s);
  return a.channel == b.channel && std::abs(*a.frequency_hz - *b.frequency_hz) * shorter_s < lobe_bins;
}

// Of channels that show it in two records or more; then it does in the others, seen there or not. In one record
// alone that of a displacement may be the motion's own mean; velocities and accelerations have none.
WanderingZeros wandering_zeros(const std::vector<Disturbance>& found, const Campaign& campaign,
                               const Window& window) {
  if (!window.passes(0)) return {};                      // a band takes it away
  std::map<std::size_t, std::set<std::size_t>> records;  // by channel
  for (const Disturbance& d : found)
    if (d.kind == wander_kind && d.channel) records[*d.channel].insert(d.record);
  WanderingZeros zeros;
  for (const auto& [channel, with] : records)
    if (with.size() > 1 || has_no_mean(campaign.channels[channel])) zeros.insert(channel);
  return zeros;
}

// Of every record that is compared sample by sample: a tone that is found in one record is in the others, seen
// there or not. What a band takes away is in none.
ForeignTones foreign_tones(const std::vector<Disturbance>& found, const Campaign& campaign, const Window& window) {
  ForeignTones tones;
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    if (is_steady(campaign.records[r].kind)) continue;
    std::vector<const Disturbance*> kept;
    for (const bool own : {true, false})
      for (const Disturbance& d : found) {
        if (d.kind != tone_kind || !d.channel || !d.frequency_hz || (d.record == r) != own) continue;
        if (!window.passes(two_pi * *d.frequency_hz)) continue;
        if (std::none_of(kept.begin(), kept.end(), [&](const Disturbance* k) { return are_one_tone(*k, d); }))
          kept.push_back(&d);
      }
    for (const Disturbance* d : kept) tones[r].push_back({*d->channel, two_pi * *d->frequency_hz});
  }
  return tones;
}

Disturbance found_in(const SegmentEvidence::Left& left, const Campaign& campaign, std::string_view kind,
                     double size) {
  Disturbance d;
  d.kind = kind;
  d.record = left.record;
  d.channel = left.channel;
  d.from_s = left.from_s;
  d.to_s = left.to_s;
  d.size = size;
  d.unit = campaign.channels[left.channel].unit;
  const double rms =
      std::sqrt(std::inner_product(left.reading.begin(), left.reading.end(), left.reading.begin(), 0.0) /
                static_cast<double>(left.reading.size()));
  d.share = size / rms;
  d.treated = "fitted";
  return d;
}

// Within its width a falling line is one.
bool rings_alike(const ForeignTone& a, const ForeignTone& b) {
  return a.channel == b.channel && a.rate > 0 &&
         std::abs(a.frequency - b.frequency) < two_pi * std::max(a.rate, b.rate);
}

bool is_ring_of(const Disturbance& d, const ForeignTones& ringing) {
  const auto own = ringing.find(d.record);
  if (d.kind != ring_kind || own == ringing.end()) return false;
  return std::any_of(own->second.begin(), own->second.end(),
                     [&](const ForeignTone& t) { return t.frequency == two_pi * *d.frequency_hz; });
}

bool is_known(const std::vector<Disturbance>& found, const Disturbance& d) {
  return std::any_of(found.begin(), found.end(), [&](const Disturbance& f) {
    return f.kind == d.kind && f.record == d.record && f.channel == d.channel &&
           (!d.frequency_hz || are_one_tone(f, d));
  });
}

// What makes errors white by noise of the excitation leaves less of a colour where that noise acts: a colour is
// told by errors that are white, and found in those that are not.
std::optional<NoiseColour> colour_of(const SegmentEvidence::Left& left, const ForeignContent& content,
                                     double level) {
  const auto known = content.coloured.find(left.record);
  const bool is_known = known != content.coloured.end() &&
                        std::any_of(known->second.begin(), known->second.end(),
                                    [&](const ColouredNoise& noise) { return noise.channel == left.channel; });
  const double rate_hz = 1 / left.sample_s;
  if (!is_known) {
    const auto told = find_noise_colour(left.noise, left.reading, rate_hz, level);
    if (!told || follows(*told, left.noise, left.reading, rate_hz, level)) return std::nullopt;
  }
  return find_noise_colour(left.unwhited, left.reading, rate_hz, level);
}

}  // namespace

void allow_for(const ForeignContent& content, const Campaign& campaign, DiagnosisOptions& options) {
  options.wandering = wandering_zeros(content.found, campaign, options.window);
  options.tones = foreign_tones(content.found, campaign, options.window);
  options.coloured = content.coloured;
  // A mode that rings in one record does so in the others, seen there or not.
  for (std::size_t r = 0; r < campaign.records.size(); ++r) {
    if (is_steady(campaign.records[r].kind)) continue;
    std::vector<ForeignTone>& tones = options.tones[r];
    const auto take = [&](const std::vector<ForeignTone>& rings) {
      for (const ForeignTone& ring : rings)
        if (std::none_of(tones.begin(), tones.end(), [&](const ForeignTone& t) { return rings_alike(t, ring); }))
          tones.push_back(ring);
    };
    if (const auto own = content.ringing.find(r); own != content.ringing.end()) take(own->second);
    for (const auto& [record, rings] : content.ringing) take(rings);
  }
}

std::size_t find_left_content(const std::vector<SegmentEvidence::Left>& compared,
                              const std::vector<SegmentEvidence::Left>& records, const Campaign& campaign,
                              ForeignContent& content) {
  const double level = false_alarm_of_channel(campaign);
  std::vector<Disturbance> fresh;
  ForeignTones rings;
  ColouredNoises coloured;
  const auto add = [&](Disturbance d, double rate) {
    if (is_known(content.found, d) || is_known(fresh, d)) return;
    if (rate > 0) rings[d.record].push_back({*d.channel, two_pi * *d.frequency_hz, rate});
    fresh.push_back(std::move(d));
  };
  const std::vector<Disturbance> before = content.found;
  // Rings and colours are found anew.
  std::erase_if(content.found,
                [&](const Disturbance& d) { return d.kind == colour_kind || is_ring_of(d, content.ringing); });
  std::set<std::pair<std::size_t, std::size_t>> new_lines;  // record, channel
  for (const SegmentEvidence::Left& l : records)
    for (const LeftLine& line : find_left_lines(l.rest, l.reading, 1 / l.sample_s, level)) {
      Disturbance d = found_in(l, campaign, line.rate > 0 ? ring_kind : tone_kind, line.amplitude);
      d.frequency_hz = line.frequency_hz;
      d.text = line.rate > 0 ? fmt::format(
                                   "rings at {:.4g} Hz with {:.3g} {} at the begin, falling by {:.2g} 1/s, "
                                   "which no mode of the model does",
                                   line.frequency_hz, d.size, d.unit, line.rate)
                             : fmt::format("a steady tone of {:.5g} Hz and {:.3g} {} that the model leaves",
                                           line.frequency_hz, d.size, d.unit);
      if (!is_known(before, d)) new_lines.insert({l.record, l.channel});
      add(std::move(d), line.rate);
    }
  for (const SegmentEvidence::Left& l : compared) {
    const Channel& channel = campaign.channels[l.channel];
    if (has_no_mean(channel) && l.slow_freedom >= 1 &&
        f_upper_tail(l.slow / l.slow_freedom / (l.other / l.other_freedom), l.slow_freedom, l.other_freedom) <
            level) {
      Disturbance d = found_in(l, campaign, wander_kind, std::sqrt(l.slow / l.other) * l.rms);
      d.text = fmt::format("the zero wanders by {:.3g} {} rms beside what the model moves", d.size, d.unit);
      add(std::move(d), 0);
    }
    if (new_lines.contains({l.record, l.channel})) continue;  // beside it a colour is told
    if (const auto colour = colour_of(l, content, level)) {
      Disturbance d = found_in(l, campaign, colour_kind, colour->sd);
      d.text = fmt::format("noise of {:.3g} {} (sd) beside white noise, correlated over {:.2g} s", colour->sd,
                           d.unit, colour->time_s);
      coloured[l.record].push_back({l.channel, colour->sd, colour->time_s, colour->white_sd});
      add(std::move(d), 0);
    }
  }
  content.found.insert(content.found.end(), fresh.begin(), fresh.end());
  content.ringing = std::move(rings);
  content.coloured = std::move(coloured);
  return fresh.size();
}

}  // namespace secular
