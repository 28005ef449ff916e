#include "diagnose/verdict/told_disturbances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "diagnose/verdict/left_content.hpp"
#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

// The place of a response's offset among the numbers of the fit; nothing where it is none of them.
std::optional<Eigen::Index> fitted_offset(const Channel& channel, const Diagnosis& diagnosis) {
  const std::vector<std::string>& names = diagnosis.fitted.names;
  const auto found = std::find(names.begin(), names.end(), "offset(" + channel.name + ")");
  if (channel.role != ChannelRole::response || found == names.end()) return std::nullopt;
  return found - names.begin();
}

// Whether the fit allows for something that was found in the records.
bool is_fitted(const Disturbance& d, const Diagnosis& diagnosis, const DiagnosisOptions& options,
               const Campaign& campaign) {
  if (!d.channel) return false;
  const Channel& channel = campaign.channels[*d.channel];
  if (d.kind == tone_kind) {
    const auto tones = options.tones.find(d.record);
    return tones != options.tones.end() &&
           std::any_of(tones->second.begin(), tones->second.end(), [&](const auto& t) {
             return t.channel == *d.channel && t.rate == 0 && t.frequency == two_pi * *d.frequency_hz;
           });
  }
  if (d.kind == wander_kind) return channel.role == ChannelRole::response && options.wandering.contains(*d.channel);
  if (d.kind == "offset" && options.wandering.contains(*d.channel)) return true;
  return d.kind == "offset" && fitted_offset(channel, diagnosis).has_value();
}

// Something that the fit tells of a record, within the window.
Disturbance fitted_in(std::size_t record, std::string_view kind, const Diagnosis& diagnosis) {
  Disturbance d;
  d.kind = kind;
  d.record = record;
  d.treated = "fitted";
  if (const auto span = diagnosis.spans.find(record); span != diagnosis.spans.end()) {
    d.from_s = span->second.from_s;
    d.to_s = span->second.to_s;
  }
  return d;
}

// Offsets of responses that the fit tells and the records alone do not, at the level of all disturbances.
std::vector<Disturbance> fitted_offsets(const Diagnosis& diagnosis, const Campaign& campaign,
                                        const std::vector<Disturbance>& found) {
  std::vector<Disturbance> offsets;
  for (std::size_t c = 0; c < campaign.channels.size(); ++c) {
    const Channel& channel = campaign.channels[c];
    const bool known = std::any_of(found.begin(), found.end(),
                                   [&](const Disturbance& d) { return d.kind == "offset" && d.channel == c; });
    const std::optional<Eigen::Index> place = fitted_offset(channel, diagnosis);
    if (known || !place) continue;
    const double value = diagnosis.fitted.values(*place),
                 sd = std::sqrt(diagnosis.fitted.covariance(*place, *place));
    const double level =
        measure_thresholds().disturbance_false_alarm / static_cast<double>(campaign.channels.size());
    if (!(sd > 0) || 2 * normal_upper_tail(std::abs(value) / sd) > level) continue;
    Disturbance d = fitted_in(diagnosis.spans.empty() ? 0 : diagnosis.spans.begin()->first, "offset", diagnosis);
    d.channel = c;
    d.size = std::abs(value);
    d.unit = channel.unit;
    d.text = fmt::format("reads {:.3g} {} (sd {:.1g}) at rest, the same in all records", value, channel.unit, sd);
    offsets.push_back(std::move(d));
  }
  return offsets;
}

// By how much records are late, where phases of their own made the equations hold.
std::vector<Disturbance> late_records(const Diagnosis& diagnosis) {
  std::vector<Disturbance> found;
  for (const OwnLateness& own : diagnosis.late.records) {
    Disturbance d = fitted_in(own.record, "late_record", diagnosis);
    d.size = own.late_s;
    d.unit = "s";
    d.share = std::abs(own.late_s) / own.period_s;
    d.text = fmt::format(
        "responses are {:.3g} ms {} their excitation, up to whole periods of {:.3g} ms (half ones, if the force "
        "has the other sign)",
        1e3 * std::abs(own.late_s), own.late_s < 0 ? "ahead of" : "behind", 1e3 * own.period_s);
    found.push_back(std::move(d));
  }
  return found;
}

// By how much natural frequencies of each record's own depart from their mean.
std::vector<Disturbance> own_frequencies(const Diagnosis& diagnosis, const CompiledModel& model) {
  std::vector<Disturbance> found;
  const FrequencyScatter& scatter = diagnosis.frequency_scatter;
  for (const OwnFrequency& own : scatter.records) {
    Disturbance d = fitted_in(own.record, "record_scatter", diagnosis);
    d.size = own.offset;
    d.share = std::abs(own.offset);
    d.text =
        fmt::format("{} is {:.2g} % {} the mean (sd {:.1g} %); records differ by {:.2g} % (sd)",
                    model.symbols[own.mode].name, 100 * std::abs(own.offset), own.offset < 0 ? "below" : "above",
                    100 * std::sqrt(own.variance), 100 * scatter.sd(static_cast<Eigen::Index>(own.mode)));
    found.push_back(std::move(d));
  }
  return found;
}

}  // namespace

std::vector<Disturbance> told_disturbances(std::vector<Disturbance> found, const Diagnosis& diagnosis,
                                           const DiagnosisOptions& options, const Campaign& campaign,
                                           const CompiledModel& model) {
  for (Disturbance& d : found)
    if (is_fitted(d, diagnosis, options, campaign)) d.treated = "fitted";
  const auto add = [&](std::vector<Disturbance> told) {
    std::move(told.begin(), told.end(), std::back_inserter(found));
  };
  add(fitted_offsets(diagnosis, campaign, found));
  add(late_records(diagnosis));
  add(own_frequencies(diagnosis, model));
  return found;
}

std::vector<Disturbance> blow_mismatches(const BlowsAlone& blows, const Diagnosis& diagnosis,
                                         const CompiledModel& model) {
  const BlowStrengths* strengths = blows.most_different();
  std::vector<Disturbance> found;
  for (const std::size_t record : blows.records) {
    Disturbance d = fitted_in(record, "blow_mismatch", diagnosis);
    d.treated = "left_out";
    const std::string left = fmt::format(
        "blows, each at its own strength, leave {:.3g} times the noise, and what they do between their "
        "samples is open to {:.2g} %; what drives them does not count, what follows them does",
        std::sqrt(blows.left.chi_squared / std::max(1.0, blows.left.freedom)), 100 * blows.between_samples);
    d.text = left;
    if (const BlowStrength* own = strengths ? strengths->of(record) : nullptr; own && strengths->mean != 0) {
      const double mean = std::abs(strengths->mean);
      d.size = own->value / strengths->mean - 1;
      d.share = std::abs(d.size);
      d.text = fmt::format(
          "its excitation acts {:.2g} % {} the mean of all blows (sd {:.1g} %): {} would be {:.5g}; blows differ "
          "by {:.2g} % (sd); {}",
          100 * d.share, d.size < 0 ? "below" : "above", 100 * std::sqrt(own->variance) / mean,
          model.symbols[strengths->symbol].name, own->value, 100 * strengths->sd / mean, left);
    }
    found.push_back(std::move(d));
  }
  return found;
}

}  // namespace secular
