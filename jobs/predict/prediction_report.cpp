#include "jobs/predict/prediction_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "estimator/model/locked_excitations.hpp"
#include "jobs/predict/prediction_files.hpp"
#include "jobs/predict/response_band.hpp"
#include "jobs/predict/uncertain_text.hpp"
#include "numerics/hertz.hpp"
#include "report/html_report.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using report::Column;
using report::Figure;
using report::Panel;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;
using report::Table;

constexpr double to_degrees = 180 / std::numbers::pi;

// A plain file of numbers does not say in which unit coordinates are.
std::string unit_of_coordinates(const Prediction& prediction) {
  return prediction.coordinate_unit.empty() ? "unit of coordinates" : prediction.coordinate_unit;
}

std::string unit_of_squares(const Prediction& prediction) {
  return prediction.coordinate_unit.empty() ? "its square" : "(" + prediction.coordinate_unit + ")^2";
}

constexpr const char* outside_name = "outside of the expansion's range";

// The line's points from `first` on that lie outside of the expansion's range move to a line of their own, drawn
// from the last point inside.
template <class Points>
void split_outside(const Points& points, std::size_t first, Series& inside, Series& outside) {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  outside.name = outside_name;
  outside.role = SeriesRole::reference;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = inside.x[first + i], y = inside.y[first + i];
    const bool here = points[i].outside, before = i > 0 && points[i - 1].outside;
    if (here && !before && i > 0 && std::isfinite(inside.y[first + i - 1])) {
      outside.x.push_back(inside.x[first + i - 1]);
      outside.y.push_back(inside.y[first + i - 1]);
    }
    outside.x.push_back(here ? x : gap);
    outside.y.push_back(here ? y : gap);
    if (here) inside.y[first + i] = gap;
  }
}

SeriesRole role_of(int unstable) {
  return unstable == 0 ? SeriesRole::model : unstable == 1 ? SeriesRole::unstable : SeriesRole::hopf;
}

// Lines of one role from all branches, interrupted where stability changes and between branches.
class StabilityLines {
 public:
  void put(double x, double y, int unstable, bool outside) {
    const std::size_t now = outside ? beyond : index(unstable);
    if (last_ && *last_ != now) {  // the change lies between: both lines reach it
      line(now, previous_x_, previous_y_);
      gap(*last_);
    }
    line(now, x, y);
    last_ = now;
    previous_x_ = x;
    previous_y_ = y;
  }
  void interrupt() {
    if (last_) gap(*last_);
    last_.reset();
  }
  void move_to(std::vector<Series>& series) {
    static constexpr const char* names[] = {"stable", "unstable", "unstable, two or more growing directions",
                                            outside_name};
    for (std::size_t i = 0; i <= beyond; ++i) {
      if (lines_[i].x.empty()) continue;
      lines_[i].name = names[i];
      lines_[i].style = SeriesStyle::line;
      lines_[i].role = i == beyond ? SeriesRole::reference : role_of(static_cast<int>(i));
      series.push_back(std::move(lines_[i]));
    }
  }

 private:
  static std::size_t index(int unstable) { return unstable == 0 ? 0U : unstable == 1 ? 1U : 2U; }
  void line(std::size_t i, double x, double y) {
    lines_[i].x.push_back(x);
    lines_[i].y.push_back(y);
  }
  void gap(std::size_t i) {
    line(i, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN());
  }

  static constexpr std::size_t beyond = 3;
  Series lines_[beyond + 1];
  std::optional<std::size_t> last_;
  double previous_x_ = 0, previous_y_ = 0;
};

std::string axis_label(const VariedParameter& varied, const std::string& unit) {
  return unit == "Hz" ? "Excitation frequency " + varied.name : varied.name;
}

template <class Value>
Panel response_panel(const Prediction& prediction, std::size_t mode, const report::Axis& axis, const Value& value,
                     bool rest) {
  Panel panel;
  panel.y = axis;
  StabilityLines lines;
  Series marks;
  marks.name = "special points";
  marks.style = SeriesStyle::points;
  marks.role = SeriesRole::alternative;
  for (const ResponseBranch& branch : prediction.diagram.branches) {
    if (branch.at_rest && !rest) continue;
    for (const ResponsePoint& at : branch.points) {
      if (at.at_rest && !rest) {
        lines.interrupt();
        continue;
      }
      lines.put(at.parameter / prediction.axis, value(at.modes, mode), at.unstable, at.outside);
    }
    lines.interrupt();
    for (const ResponseSpecial& special : branch.special) {
      if (special.at.outside || (special.at.at_rest && !rest)) continue;
      marks.x.push_back(special.at.parameter / prediction.axis);
      marks.y.push_back(value(special.at.modes, mode));
    }
  }
  lines.move_to(panel.series);
  if (!marks.x.empty()) panel.series.push_back(std::move(marks));
  return panel;
}

double peak_amplitude(const ModeAmplitudes& modes, std::size_t mode) {
  return 2 * std::abs(modes.amplitude[mode]);
}

std::vector<std::size_t> moving_modes(const Prediction& prediction) {
  std::vector<std::size_t> modes;
  for (std::size_t k = 0; k < prediction.model->modes(); ++k)
    if (!prediction.resonance->mode_at_rest[k]) modes.push_back(k);
  return modes;
}

// Measured dwells, a series for every group of records: an up and a down sweep are told apart.
void add_measured(Panel& panel, const Prediction& prediction, std::size_t mode) {
  std::vector<Series> groups;
  for (const MeasuredPoint& point : prediction.measured) {
    const std::string name = "measured dwells" + (point.group.empty() ? "" : ": " + point.group);
    auto series = std::find_if(groups.begin(), groups.end(), [&](const Series& s) { return s.name == name; });
    if (series == groups.end()) {
      Series fresh;
      fresh.name = name;
      fresh.style = SeriesStyle::points;
      fresh.role = groups.size() % 2 == 0 ? SeriesRole::data : SeriesRole::held_out;
      series = groups.insert(groups.end(), std::move(fresh));
    }
    series->x.push_back(point.parameter / prediction.axis);
    series->y.push_back(point.amplitude[mode]);
  }
  for (Series& series : groups) panel.series.push_back(std::move(series));
}

Figure response_figure(const Prediction& prediction) {
  Figure figure;
  figure.title = "Steady responses";
  figure.x = {axis_label(*prediction.vary, prediction.axis_unit), prediction.axis_unit, false, {}};
  for (const std::size_t mode : moving_modes(prediction)) {
    const std::string name(prediction.model->coordinates[mode]);
    Panel panel =
        response_panel(prediction, mode, {"Peak amplitude of " + name, unit_of_coordinates(prediction), false, {}},
                       peak_amplitude, true);
    if (std::optional<Series> band = response_band(prediction, mode))
      panel.series.insert(panel.series.begin(), *std::move(band));
    int group = 0;
    for (const PredictedSweep& sweep : prediction.sweeps) {
      Series points;
      points.name = "full equations, sweep " + sweep.direction;
      points.style = SeriesStyle::points;
      points.role = !prediction.measured.empty() ? SeriesRole::reference
                    : group++ == 0               ? SeriesRole::data
                                                 : SeriesRole::held_out;
      for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        points.x.push_back(sweep.parameter[i] / prediction.axis);
        points.y.push_back(sweep.points[i].amplitude[mode]);
      }
      panel.series.push_back(std::move(points));
    }
    add_measured(panel, prediction, mode);
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

Figure phase_figure(const Prediction& prediction) {
  Figure figure;
  figure.title = "Phases";
  figure.x = {axis_label(*prediction.vary, prediction.axis_unit), prediction.axis_unit, false, {}};
  for (const std::size_t mode : moving_modes(prediction)) {
    const std::string name(prediction.model->coordinates[mode]);
    Panel panel = response_panel(
        prediction, mode, {"Phase of " + name, "degrees", false, {}},
        [](const ModeAmplitudes& modes, std::size_t k) { return std::arg(modes.amplitude[k]) * to_degrees; },
        false);
    // Where the phase passes 180 degrees, or the amplitude zero.
    for (Series& series : panel.series) {
      if (series.style != SeriesStyle::line) continue;
      for (std::size_t i = 1; i < series.y.size(); ++i)
        if (std::abs(series.y[i] - series.y[i - 1]) > 90)
          series.y[i - 1] = std::numeric_limits<double>::quiet_NaN();
    }
    // A phase that a symmetry leaves free was set to zero: nothing to see.
    const auto zero = [](const Series& s) {
      return std::all_of(s.y.begin(), s.y.end(), [](double y) { return std::isnan(y) || std::abs(y) < 1e-6; });
    };
    if (!std::all_of(panel.series.begin(), panel.series.end(), zero)) figure.panels.push_back(std::move(panel));
  }
  return figure;
}

template <class X, class Y>
Panel curve_panel(const Prediction& prediction, const report::Axis& axis, const X& x, const Y& y) {
  Panel panel;
  panel.y = axis;
  Series line, outside;
  line.role = SeriesRole::model;
  for (const ResponseCurve& curve : prediction.curves) {
    line.name = in_words(curve.kind);
    if (!line.x.empty()) {
      line.x.push_back(std::numeric_limits<double>::quiet_NaN());
      line.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    for (const ResponseCurvePoint& at : curve.points) {
      line.x.push_back(x(at));
      line.y.push_back(y(at));
    }
    split_outside(curve.points, line.x.size() - curve.points.size(), line, outside);
  }
  const bool any = std::any_of(outside.y.begin(), outside.y.end(), [](double v) { return std::isfinite(v); });
  panel.series.push_back(std::move(line));
  if (any) panel.series.push_back(std::move(outside));
  return panel;
}

bool of_peaks(const Prediction& prediction) {
  return prediction.curves.front().kind == CurveKind::peak;
}

Figure parameter_plane(const Prediction& prediction) {
  Figure figure;
  figure.title = of_peaks(prediction) ? "Where the response is largest" : "Where the response changes";
  figure.x = {axis_label(*prediction.vary, prediction.axis_unit), prediction.axis_unit, false, {}};
  figure.panels.push_back(curve_panel(
      prediction, {axis_label(*prediction.against, prediction.against_unit), prediction.against_unit, false, {}},
      [&](const ResponseCurvePoint& at) { return at.first / prediction.axis; },
      [&](const ResponseCurvePoint& at) { return at.second / prediction.against_axis; }));
  return figure;
}

// Amplitude along the curve against the second parameter: the saddle-node diagram.
Figure amplitude_diagram(const Prediction& prediction) {
  Figure figure;
  figure.title = "Amplitude along the curve";
  figure.x = {axis_label(*prediction.against, prediction.against_unit), prediction.against_unit, false, {}};
  for (const std::size_t mode : moving_modes(prediction)) {
    const std::string name(prediction.model->coordinates[mode]);
    const auto x = [&](const ResponseCurvePoint& at) { return at.second / prediction.against_axis; };
    const auto y = [&](const ResponseCurvePoint& at) { return peak_amplitude(at.modes, mode); };
    figure.panels.push_back(
        curve_panel(prediction, {"Peak amplitude of " + name, unit_of_coordinates(prediction), false, {}}, x, y));
    figure.panels.push_back(curve_panel(prediction, {"Its square", unit_of_squares(prediction), false, {}}, x,
                                        [&](const ResponseCurvePoint& at) { return y(at) * y(at); }));
  }
  return figure;
}

// Two standard deviations about a line of the backbone, inside of the expansion's range.
template <class Spread>
Series backbone_band(const Series& line, const std::vector<BackbonePoint>& points,
                     const std::vector<BackboneSpread>& spreads, const Spread& spread) {
  Series band = line;
  band.name = band_name;
  band.style = SeriesStyle::band;
  for (std::size_t i = 0; i < points.size(); ++i)
    band.y_error.push_back(points[i].outside ? std::numeric_limits<double>::quiet_NaN() : 2 * spread(spreads[i]));
  return band;
}

// In both panels: at the cycle's frequency, and at no decay.
void mark_limit_cycles(Figure& figure, const Prediction& prediction, std::size_t b) {
  for (const bool stable : {true, false}) {
    Series frequency, decay;
    for (const LimitCycle& cycle : prediction.limit_cycles[b]) {
      if (cycle.stable != stable || cycle.at.outside) continue;
      frequency.x.push_back(2 * cycle.at.amplitude);
      frequency.y.push_back(cycle.at.frequency * to_hz);
    }
    if (frequency.x.empty()) continue;
    frequency.name = stable ? "limit cycle, stable" : "limit cycle, unstable";
    frequency.style = SeriesStyle::points;
    frequency.role = SeriesRole::alternative;
    decay = frequency;
    std::fill(decay.y.begin(), decay.y.end(), 0);
    figure.panels[0].series.push_back(std::move(frequency));
    figure.panels[1].series.push_back(std::move(decay));
    figure.panels[1].zero_line = true;
  }
}

Figure backbone_figure(const Prediction& prediction, std::size_t b) {
  const auto& [name, points] = prediction.backbones[b];
  Figure figure;
  figure.title = "Backbone of " + name;
  figure.x = {"Peak amplitude of " + name, unit_of_coordinates(prediction), false, {}};
  Series frequency, decay;
  for (const BackbonePoint& at : points) {
    frequency.x.push_back(2 * at.amplitude);
    frequency.y.push_back(at.frequency * to_hz);
    decay.x.push_back(2 * at.amplitude);
    decay.y.push_back(-at.growth);
  }
  const auto add = [&](const report::Axis& axis, Series& line, auto spread) {
    std::vector<Series> series;
    if (!prediction.backbone_spread.empty())
      series.push_back(backbone_band(line, points, prediction.backbone_spread[b], spread));
    Series outside;
    split_outside(points, 0, line, outside);
    series.push_back(line);
    figure.panels.push_back({"", axis, std::move(series)});
    if (std::any_of(points.begin(), points.end(), [](const BackbonePoint& at) { return at.outside; }))
      figure.panels.back().series.push_back(std::move(outside));
  };
  add({"Frequency", "Hz", false, {}}, frequency, [](const BackboneSpread& at) { return at.frequency * to_hz; });
  add({"Decay rate", "1/s", false, {}}, decay, [](const BackboneSpread& at) { return at.growth; });
  mark_limit_cycles(figure, prediction, b);
  return figure;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return number + (unit.empty() ? "" : " " + unit);
}

std::string with_unit(double value, const std::string& unit) {
  return with_unit(report::format_number(value, 6), unit);
}

void add_special_points(report::HtmlReport& page, const Prediction& prediction) {
  Table table;
  table.columns = {{"Point", Column::Kind::text, ""},
                   {prediction.vary->name, Column::Kind::number, prediction.axis_unit}};
  for (const std::size_t mode : moving_modes(prediction))
    table.columns.push_back({"Amplitude of " + std::string(prediction.model->coordinates[mode]),
                             Column::Kind::number, prediction.coordinate_unit});
  table.columns.push_back({"Branch", Column::Kind::number, ""});
  for (std::size_t b = 0; b < prediction.diagram.branches.size(); ++b)
    for (const ResponseSpecial& special : prediction.diagram.branches[b].special) {
      std::vector<std::string> row{special_name(special), special_place(prediction, special)};
      for (const std::size_t mode : moving_modes(prediction))
        row.push_back(special_amplitude(prediction, special, mode));
      row.push_back(std::to_string(b + 1));
      table.rows.push_back(std::move(row));
    }
  if (!table.rows.empty()) page.table(table);
  Table ends;
  ends.columns = {{"Branch", Column::Kind::number, ""},
                  {"Points", Column::Kind::number, ""},
                  {"Begins", Column::Kind::text, ""},
                  {"Ends", Column::Kind::text, ""}};
  for (std::size_t b = 0; b < prediction.diagram.branches.size(); ++b) {
    const ResponseBranch& branch = prediction.diagram.branches[b];
    ends.rows.push_back({std::to_string(b + 1), std::to_string(branch.points.size()), branch.first_end.reason,
                         branch.last_end.reason});
  }
  if (!ends.rows.empty()) page.details("How each branch ends", [&] { page.table(ends); });
}

void add_jumps(report::HtmlReport& page, const Prediction& prediction) {
  Table table;
  table.columns = {{"Sweep", Column::Kind::text, ""},
                   {"Mode", Column::Kind::text, ""},
                   {"Between", Column::Kind::number, prediction.axis_unit},
                   {"and", Column::Kind::number, prediction.axis_unit},
                   {"Amplitude before", Column::Kind::number, prediction.coordinate_unit},
                   {"after", Column::Kind::number, prediction.coordinate_unit}};
  for (const PredictedSweep& sweep : prediction.sweeps)
    for (const PredictedSweep::Jump& jump : sweep.jumps)
      table.rows.push_back({sweep.direction, std::string(prediction.model->coordinates[jump.mode]),
                            report::format_number(jump.from / prediction.axis, 6),
                            report::format_number(jump.to / prediction.axis, 6),
                            report::format_number(jump.amplitude_before, 4),
                            report::format_number(jump.amplitude_after, 4)});
  if (table.rows.empty())
    page.paragraph("The simulated sweeps do not jump.");
  else
    page.table(table);
}

// "Limit cycles: x stable at ..., y unstable at ...", as a sentence; empty where there is none.
std::string sentence_of_cycles(const Prediction& prediction) {
  std::string sentence;
  for (std::size_t k = 0; k < prediction.limit_cycles.size(); ++k)
    for (std::size_t c = 0; c < prediction.limit_cycles[k].size(); ++c) {
      const LimitCycle& cycle = prediction.limit_cycles[k][c];
      sentence += fmt::format("{} of {} with a peak amplitude of {} at {} Hz{}",
                              sentence.empty() ? (cycle.stable ? "A stable limit cycle" : "An unstable limit cycle")
                                               : (cycle.stable ? ", a stable one" : ", an unstable one"),
                              prediction.backbones[k].first, cycle_amplitude(prediction, k, c),
                              cycle_frequency(prediction, k, c),
                              cycle.at.outside ? " (outside of the expansion's range)" : "");
    }
  return sentence.empty() ? "" : sentence + " was found. ";
}

void add_limit_cycles(report::HtmlReport& page, const Prediction& prediction) {
  Table table;
  table.columns = {{"Limit cycle of", Column::Kind::text, ""},
                   {"Peak amplitude", Column::Kind::number, prediction.coordinate_unit},
                   {"Frequency", Column::Kind::number, "Hz"},
                   {"Stability", Column::Kind::text, ""}};
  for (std::size_t k = 0; k < prediction.backbones.size(); ++k)
    for (std::size_t c = 0; c < prediction.limit_cycles[k].size(); ++c)
      table.rows.push_back({prediction.backbones[k].first, cycle_amplitude(prediction, k, c),
                            cycle_frequency(prediction, k, c),
                            prediction.limit_cycles[k][c].stable ? "stable" : "unstable"});
  if (!table.rows.empty()) page.table(table);
}

// What its first sentence says of the largest stable response.
std::string sentence_of_largest(const Prediction& prediction, const LargestResponse& largest,
                                const std::string& range) {
  std::optional<double> place_sd = largest.parameter_sd;
  if (place_sd) *place_sd /= prediction.axis;
  const char* end = "";
  if (largest.kind == LargestAt::range_end) end = ", where the range ends";
  if (largest.kind == LargestAt::stability_end) end = ", where it ceases to be stable";
  if (largest.kind == LargestAt::search_end) end = ", beyond which it was not followed";
  return fmt::format(
      "Over {} the stable response of {} is largest at {}{}, with a peak amplitude of {}", range,
      prediction.model->coordinates[largest.mode],
      with_unit(uncertain_number(largest.parameter / prediction.axis, place_sd, 6), prediction.axis_unit), end,
      with_unit(uncertain_number(largest.amplitude, largest.amplitude_sd, 3), prediction.coordinate_unit));
}

std::string verdict_of(const Prediction& prediction) {
  if (!prediction.backbones.empty()) {
    const auto& [name, points] = prediction.backbones.front();
    return sentence_of_cycles(prediction) + fmt::format(
                                                "As the peak amplitude of {} rises from 0 to {}, its frequency "
                                                "goes from {} to {} Hz and its decay rate "
                                                "from {} "
                                                "to {} 1/s.",
                                                name, report::format_number(2 * points.back().amplitude, 3),
                                                report::format_number(points.front().frequency * to_hz, 5),
                                                report::format_number(points.back().frequency * to_hz, 5),
                                                report::format_number(-points.front().growth, 3),
                                                report::format_number(-points.back().growth, 3));
  }
  const std::string unit = prediction.axis_unit.empty() ? "" : " " + prediction.axis_unit;
  const std::string range =
      fmt::format("{} = {:.6g} to {:.6g}{}", prediction.vary->name, prediction.vary->from / prediction.axis,
                  prediction.vary->to / prediction.axis, unit);
  if (prediction.against)
    return fmt::format(
        "Over {}, {} {} found against {}.", range, prediction.curves.size(),
        prediction.curves.size() == 1 ? "curve of special points was" : "curves of special points were",
        prediction.against->name);
  const std::size_t mode = moving_modes(prediction).front();
  double least_beyond = std::numeric_limits<double>::infinity();
  std::size_t changes = 0;
  for (const ResponseBranch& branch : prediction.diagram.branches) {
    changes += branch.special.size();
    for (const ResponsePoint& at : branch.points)
      if (at.unstable == 0 && !at.at_rest && at.outside)
        least_beyond = std::min(least_beyond, peak_amplitude(at.modes, mode));
  }
  const std::string name(prediction.model->coordinates[mode]);
  const std::string change = changes == 0
                                 ? "its stability does not change"
                                 : "responses appear, vanish or change their stability at the marked points";
  if (!prediction.largest.empty() && prediction.largest.front().mode == mode)
    return sentence_of_largest(prediction, prediction.largest.front(), range) + "; " + change + ".";
  if (std::isfinite(least_beyond))
    return fmt::format(
        "Over {} every stable response of {} but rest lies outside of the range of the expansion (peak amplitudes "
        "of {} and more), where its numbers are not to be relied upon; {}.",
        range, name, report::format_number(least_beyond, 3), change);
  return fmt::format("Over {} no stable response of {} but rest was found; {}.", range, name, change);
}

std::string caption_of_band(const Prediction& prediction) {
  return prediction.uncertain.empty()
             ? ""
             : " Shaded: two standard deviations on both sides, by the error bars of the "
               "parameters alone; a band thinner than the line is under it, and none is drawn "
               "where it would be wider than the curve's radius.";
}

// What each parameter is: a number with its error bar; a frequency that follows others by its relation.
void add_parameters(report::HtmlReport& page, const Prediction& prediction) {
  const CompiledModel& model = *prediction.model;
  const LockedExcitations locked(model, *prediction.resonance);
  Table table;
  table.columns = {
      {"Symbol", Column::Kind::text, ""}, {"Value", Column::Kind::number, ""}, {"Unit", Column::Kind::text, ""}};
  for (std::size_t p = 0; p < prediction.names.size(); ++p) {
    const std::string& name = prediction.names[p];
    if ((prediction.vary && prediction.vary->name == name) ||
        (prediction.against && prediction.against->name == name))
      continue;
    const auto place = static_cast<Eigen::Index>(p);
    const std::size_t frequency = p - model.symbols.size();
    if (p >= model.symbols.size() && frequency < model.excitations.size() && locked.follows(frequency)) {
      table.rows.push_back({name, "follows: " + locked.text(frequency), ""});
      continue;
    }
    const double sd = prediction.uncertain.empty() ? 0 : prediction.directions.row(place).norm();
    table.rows.push_back(
        {name, uncertain_number(prediction.parameters(place), sd, 6), report::pretty_unit(prediction.units[p])});
  }
  page.table(table);
}

}  // namespace

std::vector<report::NamedFigure> prediction_figures(const Prediction& prediction) {
  std::vector<report::NamedFigure> figures;
  if (!prediction.backbones.empty()) {
    for (std::size_t b = 0; b < prediction.backbones.size(); ++b)
      figures.push_back({"backbone_" + prediction.backbones[b].first, backbone_figure(prediction, b),
                         "Frequency and decay rate of a free decay of this mode alone against its amplitude." +
                             caption_of_band(prediction)});
  } else if (prediction.against) {
    if (prediction.curves.empty()) return figures;
    figures.push_back({"plane", parameter_plane(prediction),
                       of_peaks(prediction) ? "Where the amplitude is largest over " + prediction.vary->name + "."
                                            : "Where steady responses appear, vanish or change their stability."});
    figures.push_back(
        {"amplitude", amplitude_diagram(prediction), "The same curves: amplitude of the response on them."});
  } else {
    figures.push_back({"response", response_figure(prediction),
                       "Solid: stable; dashed: unstable. Marked: points where stability changes or branches meet." +
                           caption_of_band(prediction)});
    if (Figure phases = phase_figure(prediction); !phases.panels.empty())
      figures.push_back({"phases", std::move(phases), "Phases at the time when the excitation is at its peak."});
  }
  return figures;
}

std::string prediction_report(const Prediction& prediction, const std::vector<report::NamedFigure>& figures,
                              const std::string& command) {
  report::HtmlReport page("Prediction of " + std::string(prediction.model->name),
                          "Case " + std::string(prediction.resonance->name));
  for (const std::string& warning : prediction.warnings) page.warn(warning);
  page.verdict(verdict_of(prediction));
  const auto draw = [&] {
    for (const report::NamedFigure& figure : figures) page.figure(figure.figure, figure.caption);
  };
  if (!prediction.backbones.empty()) {
    page.section("Backbones");
    draw();
    add_limit_cycles(page, prediction);
  } else if (prediction.against) {
    for (const ResponseCurve& curve : prediction.curves)
      for (const auto& [kind, at] : curve.special)
        page.card({kind == CodimensionTwo::cusp ? "Cusp" : "Double zero eigenvalue",
                   with_unit(at.first / prediction.axis, prediction.axis_unit),
                   prediction.against->name + " = " +
                       with_unit(at.second / prediction.against_axis, prediction.against_unit),
                   report::Tone::neutral});
    page.section("Curves");
    draw();
  } else {
    std::vector<std::string> said;  // solutions that differ in phase alone are one
    for (const ResponseBranch& branch : prediction.diagram.branches)
      for (const ResponseSpecial& special : branch.special) {
        const bool fold = special.kind == SpecialKind::saddle_node;
        const std::string where = with_unit(special_place(prediction, special), prediction.axis_unit);
        if ((!branch.at_rest && !fold) || said.size() == 4 ||
            std::find(said.begin(), said.end(), where) != said.end())
          continue;
        said.push_back(where);
        page.card({fold ? "Saddle-node" : "Threshold", where,
                   fold ? "two responses meet and vanish" : "the state of rest changes its stability",
                   report::Tone::neutral});
      }
    page.section("Response");
    draw();
    page.section("Special points");
    add_special_points(page, prediction);
    if (!prediction.sweeps.empty()) {
      page.section("Jumps of the simulated sweeps");
      add_jumps(page, prediction);
    }
  }
  page.section("How it was computed");
  page.paragraph(
      "Steady states of the modulation equations, by pseudo-arclength continuation from searches at several places "
      "of the range. The search is heuristic: a branch that no start and no crossing leads to would be missed.");
  page.bullets(prediction.diagram.notes);
  page.paragraph(prediction.uncertain.empty()
                     ? "No bands are drawn: " + prediction.no_spread_because + "."
                     : "Bands and numbers in brackets are the error bars of the estimated parameters, carried over "
                       "to first order. What the expansion leaves out is not among them.");
  page.details("Parameters", [&] { add_parameters(page, prediction); });
  page.provenance({command, report::program_version, {"model source: " + std::string(prediction.model->source)}});
  return page.html();
}

}  // namespace secular
