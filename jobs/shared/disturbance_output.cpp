#include "jobs/shared/disturbance_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "input/input_error.hpp"
#include "measure/disturbances/disturbance_watch.hpp"
#include "measure/disturbances/lines.hpp"
#include "measure/signal/transform_length.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using report::Column;
using report::Figure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

// More points than a figure has pixels are drawn as the extremes of so many pieces.
constexpr std::size_t pieces = 800;

// In every piece the value that is farthest from zero, at its place.
Series farthest_from_zero(const std::vector<double>& values, double first, double step, std::size_t begin,
                          std::size_t end) {
  Series series{"", SeriesStyle::line, SeriesRole::data, {}, {}, {}, {}};
  const std::size_t length = std::max<std::size_t>(1, (end - begin) / pieces);
  for (std::size_t i = begin; i < end; i += length) {
    std::size_t at = i;
    for (std::size_t j = i; j < std::min(end, i + length); ++j)
      if (std::abs(values[j]) > std::abs(values[at])) at = j;
    series.x.push_back(first + step * static_cast<double>(at));
    series.y.push_back(values[at]);
  }
  return series;
}

Series marked(std::vector<double> x, std::vector<double> y) {
  return {"disturbance", SeriesStyle::points, SeriesRole::model, std::move(x), std::move(y), {}, {}};
}

Figure spectrum_of(const std::vector<double>& samples, double rate, const Disturbance& tone,
                   const std::string& unit) {
  const auto length = static_cast<std::size_t>(cut_transform_length(static_cast<Eigen::Index>(samples.size())));
  const std::vector<double> window = lobe_window(length);
  std::vector<double> amplitude = windowed_powers(samples, window);
  double sum = 0;
  for (const double w : window) sum += w;
  for (double& a : amplitude) a = 2 * std::sqrt(a) / sum;
  Figure figure;
  figure.title = "Spectrum of the channel with the worst disturbance";
  figure.x = {"Frequency", "Hz", false, {}};
  figure.panels.push_back(
      {"",
       {"Amplitude", unit, true, {}},
       {farthest_from_zero(amplitude, 0, rate / static_cast<double>(length), 0, amplitude.size()),
        marked({*tone.frequency_hz}, {tone.size})}});
  return figure;
}

Figure history_of(const std::vector<double>& samples, const Record& record, const Disturbance& worst,
                  const std::string& unit) {
  // Something local is shown with as much again on either side, of 64 samples at least.
  const auto sample_at = [&](double t) {
    const double at = std::round((t - record.start_s) * record.sample_rate_hz);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(samples.size())));
  };
  const std::size_t from = sample_at(worst.from_s), to = sample_at(worst.to_s);
  const std::size_t around = std::max<std::size_t>(64, to - from);
  const double step = 1 / record.sample_rate_hz;
  Figure figure;
  figure.title = "Samples of the channel with the worst disturbance";
  figure.x = {"Time", "s", false, {}};
  report::Panel panel{"",
                      {"Value", unit, false, {}},
                      {farthest_from_zero(samples, record.start_s, step, from - std::min(from, around),
                                          std::min(samples.size(), to + around))}};
  if (to - from < samples.size() / 2) {
    panel.series.push_back(
        farthest_from_zero(samples, record.start_s, step, from, std::min(samples.size(), to + 1)));
    panel.series.back().name = "disturbance";
    panel.series.back().style = SeriesStyle::line_and_points;  // one sample is no line
    panel.series.back().role = SeriesRole::model;
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace

nlohmann::ordered_json disturbances_json(const std::vector<Disturbance>& found, const Campaign& campaign) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Disturbance& d : found) {
    nlohmann::ordered_json entry = {{"kind", d.kind}, {"record", campaign.records[d.record].file}};
    if (d.channel) entry["channel"] = campaign.channels[*d.channel].name;
    entry["from_s"] = d.from_s;
    entry["to_s"] = d.to_s;
    entry["size"] = d.size;
    entry["unit"] = d.unit;
    entry["share"] = d.share;
    if (d.frequency_hz) entry["frequency_hz"] = *d.frequency_hz;
    entry["treated"] = d.treated;
    entry["text"] = d.text;
    list.push_back(std::move(entry));
  }
  return list;
}

void add_disturbances(report::HtmlReport& page, const std::vector<Disturbance>& found, const Campaign& campaign) {
  if (found.empty()) return;
  page.paragraph("What the records hold beside the motion: of each kind the worst.");
  report::Table table;
  table.columns = {{"Kind", Column::Kind::text, ""},     {"Records", Column::Kind::number, ""},
                   {"Worst in", Column::Kind::text, ""}, {"Channel", Column::Kind::text, ""},
                   {"Size", Column::Kind::number, ""},   {"Unit", Column::Kind::text, ""},
                   {"Share", Column::Kind::number, "%"}, {"What", Column::Kind::text, ""}};
  const std::vector<const Disturbance*> kinds = worst_of_kinds(found);
  for (const Disturbance* d : kinds)
    table.rows.push_back({std::string(d->kind), std::to_string(records_with(found, d->kind)),
                          campaign.records[d->record].file, d->channel ? campaign.channels[*d->channel].name : "",
                          report::format_number(d->size, 3), d->unit, report::format_number(100 * d->share, 2),
                          d->text});
  page.table(table);
  const auto shown =
      std::find_if(kinds.begin(), kinds.end(), [](const Disturbance* d) { return d->channel.has_value(); });
  if (shown == kinds.end()) return;
  const Disturbance& worst = **shown;
  std::optional<Record> record;
  try {
    record = read_record(campaign, campaign.records[worst.record]);
  } catch (const InputError&) {
    return;  // its samples are not in a file any more
  }
  const std::vector<double>& samples = record->channels[*worst.channel];
  const std::string unit = campaign.channels[*worst.channel].unit;
  page.figure(worst.frequency_hz ? spectrum_of(samples, record->sample_rate_hz, worst, unit)
                                 : history_of(samples, *record, worst, unit),
              fmt::format("{}, {}: {}.", campaign.records[worst.record].file,
                          campaign.channels[*worst.channel].name, worst.text));
}

}  // namespace secular
