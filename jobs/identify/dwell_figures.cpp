#include "jobs/identify/dwell_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "jobs/identify/response_levels.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using report::Figure;
using report::Panel;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

/// Levels with a colour and a curve of their own: those with most dwells.
constexpr std::size_t most_levels = 6;

std::string level_text(const CaseView& view, double forcing) {
  const std::string unit = view.excitation_units.empty() ? "" : report::pretty_unit(view.excitation_units.front());
  return report::format_number(forcing, 3) + (unit.empty() ? "" : " " + unit);
}

report::Axis amplitude_axis(const CaseView& view) {
  return {fmt::format("Peak amplitude of {}", view.model->coordinates[first_mode(view)]),
          view.coordinate_unit,
          false,
          {}};
}

/// Measured amplitudes of dwells, and those that the full equations make there.
std::pair<Series, Series> series_of(const std::vector<DwellMean>& dwells, double DwellMean::*x, int group) {
  Series data, computed;
  data.style = SeriesStyle::error_bars;
  data.role = SeriesRole::data;
  computed.style = SeriesStyle::points;
  computed.role = SeriesRole::held_out;  // hollow
  data.group = computed.group = group;
  for (const DwellMean& dwell : dwells) {
    data.x.push_back(dwell.*x);
    data.y.push_back(dwell.amplitude);
    data.y_error.push_back(2 * dwell.amplitude_sd);
    computed.x.push_back(dwell.*x);
    computed.y.push_back(dwell.model_amplitude > 0 ? dwell.model_amplitude
                                                   : std::numeric_limits<double>::quiet_NaN());
  }
  return {std::move(data), std::move(computed)};
}

/// The curve of one level; `named`: kinds of pieces that are in the legend already.
void add_curve(Panel& panel, const std::vector<CurvePiece>& pieces, int group, std::pair<bool, bool>& named) {
  for (const CurvePiece& piece : pieces) {
    bool& known = piece.stable ? named.first : named.second;
    Series line;
    line.name = known ? "" : piece.stable ? "model at that level" : "unstable";
    known = true;
    line.style = SeriesStyle::line;
    line.role = piece.stable ? SeriesRole::model : SeriesRole::unstable;
    line.group = group;
    line.x = piece.frequency_hz;
    line.y = piece.amplitude;
    panel.series.push_back(std::move(line));
  }
}

/// Levels with a colour, rising, and the dwells of all others.
std::pair<std::vector<ResponseLevel>, std::vector<DwellMean>> shown_levels(const CaseView& view) {
  std::vector<ResponseLevel> levels = response_levels(view);
  std::stable_sort(levels.begin(), levels.end(), [](const ResponseLevel& a, const ResponseLevel& b) {
    return a.dwells.size() > b.dwells.size();
  });
  std::vector<DwellMean> others;
  for (std::size_t l = most_levels; l < levels.size(); ++l)
    others.insert(others.end(), levels[l].dwells.begin(), levels[l].dwells.end());
  if (levels.size() > most_levels) levels.resize(most_levels);
  std::sort(levels.begin(), levels.end(),
            [](const ResponseLevel& a, const ResponseLevel& b) { return a.forcing < b.forcing; });
  return {std::move(levels), std::move(others)};
}

}  // namespace

Figure dwell_response(const CaseView& view) {
  const auto [levels, others] = shown_levels(view);
  Figure figure;
  figure.title = "Steady response: measured, and the model's curve at each level";
  figure.x = {"Excitation frequency", "Hz", false, {}};
  Panel panel;
  panel.y = amplitude_axis(view);
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const DwellMean& dwell : dwell_means(view)) {
    low = std::min(low, dwell.frequency_hz);
    high = std::max(high, dwell.frequency_hz);
  }
  const double margin = 0.1 * (high - low);
  std::pair<bool, bool> named;
  std::vector<Series> points;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const int group = static_cast<int>(l);
    add_curve(panel, model_curve(view, levels[l], low - margin, high + margin), group, named);
    auto [data, computed] = series_of(levels[l].dwells, &DwellMean::frequency_hz, group);
    data.name = level_text(view, levels[l].forcing);
    if (l == 0) computed.name = "full equations at a dwell (hollow)";
    points.push_back(std::move(data));
    if (view.is_replayed()) points.push_back(std::move(computed));
  }
  if (!others.empty()) {
    auto [data, computed] = series_of(others, &DwellMean::frequency_hz, 0);
    data.name = "other levels";
    data.role = SeriesRole::reference;
    points.push_back(std::move(data));
  }
  panel.series.insert(panel.series.end(), points.begin(), points.end());
  figure.panels.push_back(std::move(panel));
  return figure;
}

std::optional<Figure> dwells_by_level(const CaseView& view) {
  if (response_levels(view).size() < 3) return std::nullopt;
  Figure figure;
  figure.title = "Steady response against the excitation's level";
  figure.x = {
      "Excitation amplitude", view.excitation_units.empty() ? "" : view.excitation_units.front(), false, {}};
  auto [data, computed] = series_of(dwell_means(view), &DwellMean::forcing, 0);
  data.name = "measured";
  computed.name = "full equations (hollow)";
  Panel panel{"", amplitude_axis(view), {data}};
  if (view.is_replayed()) panel.series.push_back(std::move(computed));
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure dwell_differences(const CaseView& view) {
  Figure figure;
  figure.title = "Measured minus computed";
  figure.x = amplitude_axis(view);
  Series amplitude, phase;
  amplitude.style = phase.style = SeriesStyle::error_bars;
  amplitude.role = phase.role = SeriesRole::data;
  for (const DwellMean& dwell : dwell_means(view)) {
    amplitude.x.push_back(dwell.amplitude);
    amplitude.y.push_back(100 * (dwell.amplitude / dwell.model_amplitude - 1));
    amplitude.y_error.push_back(200 * dwell.amplitude_sd / dwell.model_amplitude);
    phase.x.push_back(dwell.amplitude);
    phase.y.push_back(dwell.phase_difference);
    phase.y_error.push_back(2 * dwell.phase_sd);
  }
  figure.panels.push_back({"", {"Amplitude difference", "%", false, {}}, {amplitude}, true});
  figure.panels.push_back({"", {"Phase difference", "degrees", false, {}}, {phase}, true});
  return figure;
}

std::string size_of_differences(const CaseView& view) {
  double square = 0;
  const std::vector<DwellMean> dwells = dwell_means(view);
  for (const DwellMean& dwell : dwells) square += std::pow(dwell.amplitude / dwell.model_amplitude - 1, 2);
  return fmt::format("Root mean square of the amplitude's difference: {} %.",
                     report::format_number(100 * std::sqrt(square / static_cast<double>(dwells.size())), 2));
}

}  // namespace secular
