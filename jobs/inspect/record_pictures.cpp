#include "jobs/inspect/record_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "measure/disturbances/lines.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using report::Figure;
using report::Panel;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

// More points than a figure has pixels are drawn as the extremes of so many stretches.
constexpr std::size_t drawn_stretches = 800;

// Of every stretch the least and the largest value, at their places.
Series extremes(const std::vector<double>& values, double first, double step, std::size_t begin, std::size_t end) {
  Series series{"", SeriesStyle::line, SeriesRole::data, {}, {}, {}, {}};
  const std::size_t stretch = std::max<std::size_t>(1, (end - begin) / drawn_stretches);
  for (std::size_t i = begin; i < end; i += stretch) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(i),
               to = values.begin() + static_cast<std::ptrdiff_t>(std::min(end, i + stretch));
    auto [low, high] = std::minmax_element(from, to);
    if (low > high) std::swap(low, high);
    for (const auto& at : {low, high}) {
      series.x.push_back(first + step * static_cast<double>(at - values.begin()));
      series.y.push_back(*at);
      if (low == high) break;
    }
  }
  return series;
}

bool is_of(const Disturbance& disturbance, std::size_t channel) {
  return !disturbance.channel || *disturbance.channel == channel;
}

// By kind, the samples of what is local; a break between two of them.
std::map<std::string, Series> local_marks(const std::vector<double>& samples, std::size_t channel,
                                          const Record& record, const std::vector<Disturbance>& found) {
  std::map<std::string, Series> marks;
  const double step = 1 / record.sample_rate_hz;
  const auto sample_at = [&](double t) {
    const double at = std::round((t - record.start_s) * record.sample_rate_hz);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(samples.size() - 1)));
  };
  for (const Disturbance& d : found) {
    if (!is_of(d, channel) || d.frequency_hz) continue;
    const std::size_t from = sample_at(d.from_s), to = sample_at(d.to_s) + 1;
    if (to - from > samples.size() / 2) continue;  // of all of it
    Series piece = extremes(samples, record.start_s, step, from, to);
    Series& mark = marks[std::string(d.kind)];
    mark.name = d.kind;
    mark.style = SeriesStyle::line_and_points;
    mark.role = SeriesRole::model;
    mark.x.insert(mark.x.end(), piece.x.begin(), piece.x.end());
    mark.y.insert(mark.y.end(), piece.y.begin(), piece.y.end());
    mark.x.push_back(mark.x.back());
    mark.y.push_back(std::numeric_limits<double>::quiet_NaN());
  }
  return marks;
}

// Peak amplitudes by bin.
std::vector<double> amplitudes(const std::vector<double>& samples, std::size_t length) {
  const std::vector<double> window = lobe_window(length);
  std::vector<double> lines = windowed_powers(std::span(samples).first(length), window);
  double sum = 0;
  for (const double w : window) sum += w;
  for (double& line : lines) line = 2 * std::sqrt(line) / sum;
  return lines;
}

Series named_tone(const std::string& name, double hz, double amplitude, SeriesRole role) {
  return {fmt::format("{}, {} Hz", name, report::format_number(hz, 5)),
          SeriesStyle::points,
          role,
          {hz},
          {amplitude},
          {},
          {}};
}

// The strongest line, the excitation's own, and lines that do not belong to the motion.
void add_tones(const std::vector<double>& lines, double bin_hz, const RecordEntry& entry, std::size_t channel,
               const std::vector<Disturbance>& found, Panel& panel) {
  const auto strongest = static_cast<std::size_t>(
      std::max_element(lines.begin() + std::min<std::ptrdiff_t>(5, std::ssize(lines) - 1), lines.end()) -
      lines.begin());
  const double strongest_hz = bin_hz * static_cast<double>(strongest);
  const double driven_hz = entry.excitation_frequency_hz.value_or(0);
  const bool drives = std::abs(strongest_hz - driven_hz) < lobe_bins * bin_hz;
  if (!drives)
    panel.series.push_back(named_tone("strongest", strongest_hz, lines[strongest], SeriesRole::held_out));
  if (const auto bin = static_cast<std::size_t>(std::llround(driven_hz / bin_hz)); bin > 0 && bin < lines.size())
    panel.series.push_back(named_tone("excitation", driven_hz, lines[bin], SeriesRole::alternative));
  for (const Disturbance& d : found)
    if (d.frequency_hz && is_of(d, channel))
      panel.series.push_back(named_tone(std::string(d.kind), *d.frequency_hz, d.size, SeriesRole::model));
}

}  // namespace

RecordPictures record_pictures(const Campaign& campaign, std::size_t index, const Record& record,
                               const std::vector<Disturbance>& found) {
  RecordPictures pictures;
  pictures.record = index;
  const RecordEntry& entry = campaign.records[index];
  pictures.history.title = entry.file;
  pictures.history.x = {"Time", "s", false, {}};
  pictures.spectrum.title = entry.file + ": spectrum";
  const std::size_t length = record.samples() / 2 * 2;
  const double bin_hz = record.sample_rate_hz / static_cast<double>(std::max<std::size_t>(1, length));
  pictures.spectrum.x = {"Frequency", "Hz", false, std::pair(0.0, 0.5 * record.sample_rate_hz)};
  for (std::size_t c = 0; c < std::min(record.channels.size(), most_pictured_channels); ++c) {
    const Channel& channel = campaign.channels[c];
    std::vector<double> samples = record.channels[c];
    const bool any = std::any_of(samples.begin(), samples.end(), [](double x) { return x != 0; });
    if (length < 64 || !any) continue;
    Panel history{"", {channel.name, channel.unit, false, {}}, {}};
    history.series.push_back(extremes(samples, record.start_s, 1 / record.sample_rate_hz, 0, samples.size()));
    for (auto& [kind, mark] : local_marks(samples, c, record, found)) history.series.push_back(std::move(mark));
    pictures.history.panels.push_back(std::move(history));
    for (double& x : samples)
      if (!std::isfinite(x)) x = 0;
    const std::vector<double> lines = amplitudes(samples, length);
    const double top = *std::max_element(lines.begin(), lines.end());
    if (!(top > 0)) continue;
    const double least = *std::min_element(lines.begin() + 1, lines.end());
    Panel spectrum{
        "", {channel.name, channel.unit, true, std::pair(std::max(1e-10 * top, 0.5 * least), 2 * top)}, {}};
    spectrum.series.push_back(extremes(lines, 0, bin_hz, 0, lines.size()));
    add_tones(lines, bin_hz, entry, c, found, spectrum);
    pictures.spectrum.panels.push_back(std::move(spectrum));
  }
  return pictures;
}

}  // namespace secular
