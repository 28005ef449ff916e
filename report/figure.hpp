#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// A figure as data: what is plotted, not how. `render_figure` draws it with gnuplot.
namespace secular::report {

struct Axis {
  std::string label;  ///< "Response amplitude"
  std::string
      unit;  ///< "m/s^2"; printed as "Response amplitude (m/s²)", with a power of ten where numbers need one
  bool logarithmic = false;
  std::optional<std::pair<double, double>> range = {};  ///< low < high; without it the data and a small margin
};

enum class SeriesStyle {
  points,
  line,
  line_and_points,
  error_bars,  ///< points with y ± y_error
  band,        ///< filled between y - y_error and y + y_error
  region       ///< filled inside of closed outlines, one after the other with a gap between them
};

/// Whether an area is drawn, behind lines and points.
constexpr bool is_filled(SeriesStyle style) {
  return style == SeriesStyle::band || style == SeriesStyle::region;
}

/// What a series is to the reader. Fixes its colour, and whether a line is dashed and a marker hollow, the same in
/// every figure of the program.
enum class SeriesRole {
  data,         ///< measured, used by the fit: blue, filled markers
  held_out,     ///< measured, kept out of the fit: green, hollow markers
  model,        ///< computed; a stable branch: vermilion
  unstable,     ///< an unstable branch of the model: vermilion, dashed
  hopf,         ///< a branch unstable through a Hopf bifurcation: purple, dotted
  alternative,  ///< another model: brown
  reference     ///< a level or line to compare with: grey, thin
};

struct Series {
  std::string name;  ///< in the legend; empty: not in the legend
  SeriesStyle style = SeriesStyle::line;
  SeriesRole role = SeriesRole::model;
  std::vector<double> x, y;
  std::vector<double> y_error;  ///< error_bars and band: half width, same length as y; otherwise empty
  /// Series of the same condition (a data set and the model's curve through it) share a group, hence a colour and a
  /// marker shape. Without a group the role alone decides; several series of one role then get colours in turn.
  std::optional<int> group;
};

/// One pair of axes. Values that are not finite (or not positive on a logarithmic axis) interrupt a line.
struct Panel {
  std::string title;  ///< optional
  Axis y;
  std::vector<Series> series;
  bool zero_line = false;  ///< a thin line at y = 0, which the range then holds: for residuals
};

struct Figure {
  std::string title;  ///< optional; also the accessible name
  Axis x;             ///< shared by all panels, which are stacked from the top
  std::vector<Panel> panels;
  int width_px = 800;
  int panel_height_px = 0;  ///< of one panel's plot area; 0: chosen from the number of panels
};

/// A figure of a report.
struct NamedFigure {
  std::string name;  ///< of its file, without .svg
  Figure figure;
  std::string caption;
};

enum class FigureUse {
  inline_html,  ///< colours follow the page (light, dark, print); no background
  standalone    ///< a file of its own: dark text on white
};

/// A drawn figure. Where gnuplot is missing or fails, `svg` is a box that says so and `problem` is not empty.
struct RenderedFigure {
  std::string svg;      ///< one <svg> element, UTF-8, without XML declaration
  std::string points;   ///< JSON for values under the pointer (figure_points.hpp); empty where nothing is drawn
  std::string problem;  ///< for the report's warnings
};

/// Draws the figure. `id` prefixes every id inside the SVG, so that several fit into one page: ASCII letters,
/// digits and '-', starting with a letter. The bytes depend on the figure, the id and gnuplot's version alone.
///
/// No text of the figure reaches gnuplot: it gets place holders, which are replaced in its SVG by the escaped text.
/// gnuplot is started without a shell and without its start-up files. The environment variable SECULAR_GNUPLOT
/// names another gnuplot than the one on the PATH. Throws std::invalid_argument where lengths of x, y and y_error
/// differ, a range is empty or not finite, the figure has no panel, or the id is not of that form.
RenderedFigure render_figure(const Figure& figure, const std::string& id, FigureUse use = FigureUse::inline_html);

}  // namespace secular::report
