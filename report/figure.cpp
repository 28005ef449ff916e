#include "report/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "input/markup.hpp"
#include "report/axis_ticks.hpp"
#include "report/figure_points.hpp"
#include "report/gnuplot.hpp"
#include "report/number_format.hpp"
#include "report/series_look.hpp"
#include "report/svg_cleanup.hpp"

namespace secular::report {
namespace {

// Sizes in pixels. All positions are computed here, so that panels align and gnuplot has nothing to estimate.
constexpr double font_px = 13, title_px = 16, character_width = 0.53;
constexpr double right_margin = 22, legend_row = 21, line_sample = 30, marker_sample = 14, legend_gap = 20,
                 tick_length = 5;

struct Range {
  double low = 0, high = 1;
};

struct Box {  // of a plot area, y downwards from the top edge
  double left = 0, right = 0, top = 0, bottom = 0;
};

double text_width(std::string_view text, double size_px) {
  return static_cast<double>(code_points(text)) * character_width * size_px;
}

void check_range(const Axis& axis) {
  if (!axis.range) return;
  const auto [low, high] = *axis.range;
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high) || (axis.logarithmic && low <= 0))
    throw std::invalid_argument(
        fmt::format("figure: axis range [{}, {}] is empty, not finite or not positive", low, high));
}

void check(const Figure& figure, std::string_view id) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto part_of_id = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '-'; };
  if (id.empty() || !letter(id.front()) || !std::all_of(id.begin(), id.end(), part_of_id))
    throw std::invalid_argument(fmt::format("figure: id '{}' is not letters, digits and '-'", id));
  if (figure.panels.empty()) throw std::invalid_argument("figure: no panel");
  if (figure.width_px < 300)
    throw std::invalid_argument(fmt::format("figure: width {} px < 300 px", figure.width_px));
  check_range(figure.x);
  for (const Panel& panel : figure.panels) {
    check_range(panel.y);
    for (const Series& series : panel.series) {
      const bool has_errors = series.style == SeriesStyle::error_bars || series.style == SeriesStyle::band;
      if (series.x.size() != series.y.size() || series.y_error.size() != (has_errors ? series.y.size() : 0))
        throw std::invalid_argument(fmt::format("figure: series '{}' has {} x, {} y and {} y errors", series.name,
                                                series.x.size(), series.y.size(), series.y_error.size()));
    }
  }
}

bool drawable(double value, const Axis& axis) {
  return std::isfinite(value) && (!axis.logarithmic || value > 0);
}

bool drawable(const Series& series, std::size_t i, const Axis& x, const Axis& y) {
  return drawable(series.x[i], x) && drawable(series.y[i], y) &&
         (series.y_error.empty() || (std::isfinite(series.y_error[i]) && series.y_error[i] >= 0));
}

/// The smallest range that holds every value it was shown, then widened by a margin.
class RangeFinder {
 public:
  explicit RangeFinder(const Axis& axis) : axis_(axis) {}
  void show(double value) {
    if (!drawable(value, axis_)) return;
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  Range range() const {
    if (axis_.range) return {axis_.range->first, axis_.range->second};
    if (low_ > high_) return axis_.logarithmic ? Range{0.1, 10} : Range{0, 1};
    if (axis_.logarithmic) {
      const double margin = std::max(0.04 * std::log10(high_ / low_), 0.05);
      return {low_ * std::pow(10.0, -margin), high_ * std::pow(10.0, margin)};
    }
    // A span below rounding of the values themselves is no span.
    const double size = std::max(std::abs(low_), std::abs(high_));
    const bool flat = high_ - low_ <= 1e-12 * size;
    const double margin = size == 0 ? 1 : flat ? 0.1 * size : 0.04 * (high_ - low_);
    // No sliver of negative numbers below data that begin at or near zero.
    const bool starts_at_zero = !flat && low_ >= 0 && low_ < margin,
               ends_at_zero = !flat && high_ <= 0 && -high_ < margin;
    return {starts_at_zero ? 0 : low_ - margin, ends_at_zero ? 0 : high_ + margin};
  }

 private:
  const Axis& axis_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

Range x_range(const Figure& figure) {
  RangeFinder finder(figure.x);
  for (const Panel& panel : figure.panels)
    for (const Series& series : panel.series)
      for (std::size_t i = 0; i < series.x.size(); ++i)
        if (drawable(series, i, figure.x, panel.y)) finder.show(series.x[i]);
  return finder.range();
}

Range y_range(const Panel& panel, const Axis& x) {
  RangeFinder finder(panel.y);
  if (panel.zero_line) finder.show(0);
  for (const Series& series : panel.series)
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (!drawable(series, i, x, panel.y)) continue;
      finder.show(series.y[i]);
      if (series.y_error.empty()) continue;
      finder.show(series.y[i] - series.y_error[i]);
      finder.show(series.y[i] + series.y_error[i]);
    }
  return finder.range();
}

AxisTicks ticks_of(const Axis& axis, Range range, int count) {
  return axis.logarithmic ? logarithmic_ticks(range.low, range.high, count)
                          : linear_ticks(range.low, range.high, count);
}

std::string axis_text(const Axis& axis, int power_of_ten) {
  const std::string unit = pretty_unit(axis.unit);
  std::string scale = power_of_ten == 0 ? "" : "10" + superscript(power_of_ten);
  if (!scale.empty() && !unit.empty()) scale += " ";
  return scale.empty() && unit.empty() ? axis.label : fmt::format("{} ({}{})", axis.label, scale, unit);
}

/// A long line keeps of every run of neighbouring points the first, the last and the extremes: more cannot be seen.
std::vector<std::size_t> visible_points(const Series& series, std::size_t begin, std::size_t end,
                                        std::size_t runs) {
  std::vector<std::size_t> kept;
  const std::size_t length = std::max<std::size_t>(1, (end - begin + runs - 1) / runs);
  for (std::size_t run = begin; run < end; run += length) {
    const std::size_t stop = std::min(end, run + length);
    std::vector<std::size_t> of_run;
    if (length <= 6) {
      for (std::size_t i = run; i < stop; ++i) of_run.push_back(i);
    } else {
      of_run = {run, stop - 1};
      for (const std::vector<double>* values : {&series.x, &series.y}) {
        const auto first = values->begin() + static_cast<std::ptrdiff_t>(run);
        const auto [low, high] = std::minmax_element(first, values->begin() + static_cast<std::ptrdiff_t>(stop));
        of_run.push_back(static_cast<std::size_t>(low - values->begin()));
        of_run.push_back(static_cast<std::size_t>(high - values->begin()));
      }
      std::sort(of_run.begin(), of_run.end());
      of_run.erase(std::unique(of_run.begin(), of_run.end()), of_run.end());
    }
    kept.insert(kept.end(), of_run.begin(), of_run.end());
  }
  return kept;
}

bool joined_by_a_line(SeriesStyle style) {
  return style == SeriesStyle::line || style == SeriesStyle::line_and_points || is_filled(style);
}

/// Lines "x y low high" of a gnuplot data block; an empty line where a line or band is interrupted.
std::string data_block(const Series& series, const Axis& x, const Axis& y, Range shown, int width_px) {
  std::string block;
  const auto append = [&](std::size_t i) {
    const double error = series.y_error.empty() ? 0 : series.y_error[i];
    const double low = y.logarithmic ? std::max(series.y[i] - error, shown.low) : series.y[i] - error;
    block += fmt::format("{:.12g} {:.12g} {:.12g} {:.12g}\n", series.x[i], series.y[i], low, series.y[i] + error);
  };
  for (std::size_t i = 0; i < series.x.size();) {
    if (!drawable(series, i, x, y)) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < series.x.size() && drawable(series, end, x, y)) ++end;
    if (series.style == SeriesStyle::line) {
      for (const std::size_t point : visible_points(series, i, end, static_cast<std::size_t>(width_px)))
        append(point);
    } else {
      for (std::size_t point = i; point < end; ++point) append(point);
    }
    if (joined_by_a_line(series.style)) block += '\n';
    i = end;
  }
  return block;
}

double sample_width(SeriesStyle style) {
  return style == SeriesStyle::points || style == SeriesStyle::error_bars ? marker_sample : line_sample;
}

struct LegendEntry {
  std::size_t series = 0;
  double x = 0;
  int row = 0;
};

/// Left to right in rows of the plot area's width; series that look and are called alike appear once.
std::vector<LegendEntry> lay_out_legend(const std::vector<Series>& series, double left, double right) {
  std::vector<LegendEntry> entries;
  double x = left;
  int row = 0;
  for (std::size_t s = 0; s < series.size(); ++s) {
    const auto looks_alike = [&](const LegendEntry& entry) {
      const Series& other = series[entry.series];
      return other.name == series[s].name && other.role == series[s].role && other.group == series[s].group &&
             other.style == series[s].style;
    };
    if (series[s].name.empty() || std::any_of(entries.begin(), entries.end(), looks_alike)) continue;
    const double width = sample_width(series[s].style) + 6 + text_width(series[s].name, font_px);
    if (x > left && x + width > right) {
      x = left;
      ++row;
    }
    entries.push_back({s, x, row});
    x += width + legend_gap;
  }
  return entries;
}

/// Writes the gnuplot script of one figure.
class ScriptWriter {
 public:
  ScriptWriter(const Figure& figure, PlaceHolders& texts)
      : figure_(figure), texts_(texts), x_range_(x_range(figure)) {
    lay_out();
  }
  int height() const { return height_; }

  /// Where the panels are, for values under the pointer.
  std::vector<PlotArea> areas() const {
    std::vector<PlotArea> areas;
    for (std::size_t p = 0; p < panels_.size(); ++p) {
      const auto& [box, y, y_ticks, legend, title_baseline, legend_middle] = panels_[p];
      areas.push_back({box.left, box.right, box.top, box.bottom, x_range_.low, x_range_.high, y.low, y.high});
    }
    return areas;
  }

  std::string script() {
    text_ = fmt::format(
        "set terminal svg size {},{} dynamic noenhanced font 'sans-serif,{}' fontscale 1 butt\n"
        "set border 3 back lc rgb '{}' lw 1\nset key off\n"
        "set grid xtics ytics back lt 1 lw 1 lc rgb '{}'\n",
        figure_.width_px, height_, font_px, ink_color, grid_color);
    write_data_blocks();
    text_ += "set multiplot\n";
    for (std::size_t p = 0; p < figure_.panels.size(); ++p) write_panel(p);
    text_ += "unset multiplot\n";
    return text_;
  }

 private:
  struct PanelLayout {
    Box box;
    Range y;
    AxisTicks y_ticks;
    std::vector<LegendEntry> legend;
    double title_baseline = 0, legend_middle = 0;  ///< of its first row
  };

  void lay_out() {
    const std::size_t count = figure_.panels.size();
    const int plot_height = figure_.panel_height_px > 0 ? figure_.panel_height_px
                            : count == 1                ? 360
                            : count == 2                ? 230
                                                        : 180;
    const int y_tick_count = std::max(2, plot_height / 55);
    double widest_label = 0;
    for (const Panel& panel : figure_.panels) {
      PanelLayout layout;
      layout.y = y_range(panel, figure_.x);
      layout.y_ticks = ticks_of(panel.y, layout.y, y_tick_count);
      for (const Tick& tick : layout.y_ticks.ticks)
        widest_label = std::max(widest_label, text_width(tick.label, font_px));
      panels_.push_back(std::move(layout));
    }
    const double left = 40 + widest_label + tick_length + 8, right = figure_.width_px - right_margin;
    x_ticks_ = ticks_of(figure_.x, x_range_, static_cast<int>((right - left) / 85));

    double y = 14;
    if (!figure_.title.empty()) {
      title_baseline_ = y + 12;
      y += 30;
    }
    for (std::size_t p = 0; p < count; ++p) {
      PanelLayout& layout = panels_[p];
      if (!figure_.panels[p].title.empty()) {
        layout.title_baseline = y + 10;
        y += 22;
      }
      layout.legend = lay_out_legend(figure_.panels[p].series, left, right);
      const int rows = layout.legend.empty() ? 0 : layout.legend.back().row + 1;
      layout.legend_middle = y + legend_row / 2;
      y += rows * legend_row + (rows > 0 ? 6 : 2);
      layout.box = {left, right, y, y + plot_height};
      y += plot_height + (p + 1 < count ? 16 : 0);
    }
    height_ = static_cast<int>(std::ceil(y + 52));
  }

  /// Screen coordinates "x,y" of a pixel.
  std::string at(double x, double y) const {
    return fmt::format("screen {:.6f},{:.6f}", x / figure_.width_px, 1 - y / height_);
  }

  void write_data_blocks() {
    for (std::size_t p = 0; p < figure_.panels.size(); ++p)
      for (std::size_t s = 0; s < figure_.panels[p].series.size(); ++s) {
        const Panel& panel = figure_.panels[p];
        const std::string block = data_block(panel.series[s], figure_.x, panel.y, panels_[p].y, figure_.width_px);
        if (!block.empty()) text_ += fmt::format("$data_{}_{} << END_OF_DATA\n{}END_OF_DATA\n", p, s, block);
        has_data_.push_back(!block.empty());
      }
  }

  void write_label(std::string_view text, double x, double y, std::string_view alignment, std::string_view font) {
    text_ += fmt::format("set label '{}' at {} {} font '{}' tc rgb '{}'\n", texts_.add(text), at(x, y), alignment,
                         font, ink_color);
  }

  void write_axis(std::string_view name, const Axis& axis, Range range, const AxisTicks& ticks, bool labelled) {
    text_ += fmt::format("{} logscale {}\nset {}range [{:.15g}:{:.15g}]\n", axis.logarithmic ? "set" : "unset",
                         name, name, range.low, range.high);
    std::string list;
    for (const Tick& tick : ticks.ticks) {
      const bool minor = tick.label.empty();
      list += fmt::format("{}'{}' {:.15g}{}", list.empty() ? "" : ", ",
                          labelled && !minor ? texts_.add(tick.label) : std::string(), tick.position,
                          minor ? " 1" : "");
    }
    text_ += fmt::format("set {}tics out nomirror scale 0.5,0.3 offset {} tc rgb '{}' ({})\n", name,
                         name == "x" ? "0,0.35" : "0.5,0", ink_color, list);
  }

  void write_panel(std::size_t p) {
    const Panel& panel = figure_.panels[p];
    const PanelLayout& layout = panels_[p];
    const Box& box = layout.box;
    const bool last = p + 1 == figure_.panels.size();
    text_ += "unset label\nunset arrow\nunset object\n";
    text_ += fmt::format(
        "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n"
        "set bmargin at screen {:.6f}\n",
        box.left / figure_.width_px, box.right / figure_.width_px, 1 - box.top / height_, 1 - box.bottom / height_);
    write_axis("x", figure_.x, x_range_, x_ticks_, last);
    write_axis("y", panel.y, layout.y, layout.y_ticks, true);
    const std::string plain = fmt::format("sans-serif,{}", font_px);
    if (p == 0 && !figure_.title.empty())
      write_label(figure_.title, box.left, title_baseline_, "left", fmt::format("secular-bold,{}", title_px));
    if (!panel.title.empty()) write_label(panel.title, box.left, layout.title_baseline, "left", "secular-bold,13");
    const double middle_x = (box.left + box.right) / 2, middle_y = (box.top + box.bottom) / 2;
    if (last) write_label(axis_text(figure_.x, x_ticks_.power_of_ten), middle_x, box.bottom + 42, "center", plain);
    write_label(axis_text(panel.y, layout.y_ticks.power_of_ten), 18, middle_y, "center rotate by 90", plain);
    if (panel.zero_line && layout.y.low < 0 && layout.y.high > 0)
      text_ += fmt::format("set arrow from graph 0,first 0 to graph 1,first 0 nohead back lc rgb '{}' lw 1\n",
                           ink_color);
    write_legend(panel, layout);
    write_plot(p, middle_x, middle_y);
  }

  void write_legend(const Panel& panel, const PanelLayout& layout) {
    const std::vector<SeriesLook> looks = series_looks(panel.series);
    for (const LegendEntry& entry : layout.legend) {
      const Series& series = panel.series[entry.series];
      const SeriesLook& look = looks[entry.series];
      const double y = layout.legend_middle + entry.row * legend_row;
      const double right = entry.x + sample_width(series.style), middle = (entry.x + right) / 2;
      // gnuplot joins neighbouring arrows of one colour and width into one path, with the dashes of the first: no
      // two samples have exactly the same width.
      const auto line = [&](double x1, double y1, double x2, double y2, double width, std::string_view dash) {
        text_ += fmt::format("set arrow from {} to {} nohead lc rgb '{}' lw {} dt {}\n", at(x1, y1), at(x2, y2),
                             look.color, width + 0.001 * static_cast<double>(entry.series), dash);
      };
      if (is_filled(series.style))
        text_ += fmt::format("set object rectangle from {} to {} fc rgb '{}' fs solid 0.22 noborder\n",
                             at(entry.x, y + 6), at(right, y - 6), look.color);
      if (series.style == SeriesStyle::line || series.style == SeriesStyle::line_and_points)
        line(entry.x, y, right, y, look.line_width, look.dash);
      if (series.style == SeriesStyle::error_bars) line(middle, y - 7, middle, y + 7, 1, "solid");
      if (series.style == SeriesStyle::points || series.style == SeriesStyle::line_and_points ||
          series.style == SeriesStyle::error_bars)
        text_ += fmt::format("set label '' at {} point pt {} ps {} lc rgb '{}'\n", at(middle, y), look.point_type,
                             look.point_size, look.color);
      write_label(series.name, right + 6, y, "left", fmt::format("sans-serif,{}", font_px));
    }
  }

  void write_plot(std::size_t p, double middle_x, double middle_y) {
    const Panel& panel = figure_.panels[p];
    const std::vector<SeriesLook> looks = series_looks(panel.series);
    std::size_t first_series = 0;
    for (std::size_t earlier = 0; earlier < p; ++earlier) first_series += figure_.panels[earlier].series.size();
    std::string behind, in_front;
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
      if (!has_data_[first_series + s]) continue;
      const SeriesLook& look = looks[s];
      const std::string data = fmt::format("$data_{}_{}", p, s);
      const std::string line = fmt::format(", {} using 1:2 with lines lc rgb '{}' lw {} dt {}", data, look.color,
                                           look.line_width, look.dash);
      const std::string points = fmt::format(", {} using 1:2 with points pt {} ps {} lw 1.5 lc rgb '{}'", data,
                                             look.point_type, look.point_size, look.color);
      switch (panel.series[s].style) {
        case SeriesStyle::band:
          behind += fmt::format(", {} using 1:3:4 with filledcurves fs solid 0.22 noborder fc rgb '{}'", data,
                                look.color);
          break;
        case SeriesStyle::region:
          behind += fmt::format(", {} using 1:2 with filledcurves closed fs solid 0.22 noborder fc rgb '{}'", data,
                                look.color);
          break;
        case SeriesStyle::line:
          (panel.series[s].role == SeriesRole::reference ? behind : in_front) += line;
          break;
        case SeriesStyle::points:
          in_front += points;
          break;
        case SeriesStyle::line_and_points:
          in_front += line + points;
          break;
        case SeriesStyle::error_bars:
          in_front +=
              fmt::format(", {} using 1:3:(0):($4-$3) with vectors nohead lc rgb '{}' lw 1", data, look.color);
          in_front += points;
          break;
      }
    }
    const std::string commands = behind + in_front;
    if (!commands.empty()) {
      text_ += "plot " + commands.substr(2) + "\n";
      return;
    }
    write_label("no data", middle_x, middle_y, "center", fmt::format("sans-serif,{}", font_px));
    const Range y = panels_[p].y;  // gnuplot draws axes only along with something: a point outside of them
    text_ += fmt::format("$nothing << END_OF_DATA\n{:.15g} {:.15g}\nEND_OF_DATA\nplot $nothing with dots\n",
                         x_range_.high * 2 + 1, y.high * 2 + 1);
  }

  const Figure& figure_;
  PlaceHolders& texts_;
  Range x_range_;
  AxisTicks x_ticks_;
  std::vector<PanelLayout> panels_;
  std::vector<bool> has_data_;  ///< series of all panels in turn
  double title_baseline_ = 0;
  int height_ = 0;
  std::string text_;
};

std::string box_with_message(const Figure& figure, const std::string& message, FigureUse use) {
  constexpr int height = 120;
  return svg_head({figure.title, figure.width_px, height, use}) +
         fmt::format(
             "<rect x=\"1\" y=\"1\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"currentColor\" "
             "stroke-dasharray=\"6,4\"/>\n"
             "<text x=\"20\" y=\"50\" font-size=\"14\" fill=\"currentColor\">{}</text>\n"
             "<text x=\"20\" y=\"78\" font-size=\"13\" fill=\"currentColor\">{}</text>\n</svg>\n",
             figure.width_px - 2, height - 2, escape_markup_line("This figure could not be drawn: " + figure.title),
             escape_markup_line(message));
}

}  // namespace

RenderedFigure render_figure(const Figure& figure, const std::string& id, FigureUse use) {
  check(figure, id);
  PlaceHolders texts;
  ScriptWriter writer(figure, texts);
  const GnuplotOutput drawn = run_gnuplot(writer.script());
  if (!drawn.problem.empty()) return {box_with_message(figure, drawn.problem, use), "", drawn.problem};
  return {clean_svg(drawn.svg, texts, id, {figure.title, figure.width_px, writer.height(), use}),
          figure_points(figure, writer.areas()), ""};
}

}  // namespace secular::report
