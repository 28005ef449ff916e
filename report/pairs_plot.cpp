#include "report/pairs_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "input/markup.hpp"
#include "report/number_format.hpp"
#include "report/svg_cleanup.hpp"

namespace secular::report {
namespace {

constexpr double pair_cell = 118, pair_gap = 10, pairs_left = 96, pairs_top = 44, pairs_bottom = 66, shown_sd = 3;
/// Radii, in standard deviations, within which a normal distribution of two numbers has 68 % and 95 %:
/// sqrt(-2 ln(1 - p)).
constexpr double radius_68 = 1.510, radius_95 = 2.448;

constexpr std::string_view tick_font = "font-size=\"10\"";

struct Corner {
  double x = 0, y = 0;
};

Corner corner_of(std::size_t row, std::size_t column) {
  return {pairs_left + static_cast<double>(column) * (pair_cell + pair_gap),
          pairs_top + static_cast<double>(row) * (pair_cell + pair_gap)};
}

std::string frame_of(Corner at) {
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"currentColor\" "
      "stroke-opacity=\"0.35\"/>\n",
      at.x, at.y, pair_cell, pair_cell);
}

/// Of two numbers of unit variance the ellipse's axes lie along the diagonals, sqrt(1 +- r) long.
std::string ellipses_of(Corner at, double r) {
  const double unit = pair_cell / (2 * shown_sd);
  std::string text;
  for (const auto& [radius, opacity] : {std::pair(radius_95, 0.15), std::pair(radius_68, 0.35)})
    text += fmt::format(
        "<ellipse rx=\"{:.2f}\" ry=\"{:.2f}\" transform=\"translate({:.1f},{:.1f}) rotate(-45)\" "
        "fill=\"var(--blue)\" "
        "fill-opacity=\"{}\" stroke=\"var(--blue)\" stroke-width=\"1.5\"/>\n",
        radius * unit * std::sqrt(std::max(0.0, 1 + r)), radius * unit * std::sqrt(std::max(0.0, 1 - r)),
        at.x + pair_cell / 2, at.y + pair_cell / 2, opacity);
  return text;
}

std::string offset_of(double sd, double times) {
  return (times < 0 ? "\u2212" : "+") + format_number(std::abs(times) * sd, 2);
}

}  // namespace

std::string pairs_plot(const JointValues& joint, const std::string& title) {
  const std::size_t n = joint.names.size();
  if (joint.units.size() != n || joint.values.size() != n || joint.sd.size() != n ||
      joint.correlation.size() != n ||
      std::any_of(joint.correlation.begin(), joint.correlation.end(),
                  [n](const std::vector<double>& row) { return row.size() != n; }))
    throw std::invalid_argument("pairs plot: sizes differ");
  const int side = static_cast<int>(static_cast<double>(n) * (pair_cell + pair_gap));
  const int width = static_cast<int>(pairs_left) + side + 10,
            height = static_cast<int>(pairs_top + pairs_bottom) + side;
  std::string svg = svg_head({title, width, height, FigureUse::inline_html});
  svg.insert(std::string_view("<svg").size(), " class=\"fine\"");  // small letters: phones scroll it
  svg += fmt::format(
      "<g font-size=\"12\">\n<text x=\"{}\" y=\"24\" font-size=\"16\" font-weight=\"600\" "
      "fill=\"currentColor\">{}</text>\n",
      pairs_left, escape_markup_line(title));
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column) {
      const Corner at = corner_of(row, column);
      const double middle = at.x + pair_cell / 2, r = joint.correlation[row][column];
      if (row == column) {
        svg += svg_text(middle, at.y + pair_cell / 2 - 6, joint.names[row], "middle",
                        "font-size=\"15\" font-weight=\"600\"") +
               svg_text(middle, at.y + pair_cell / 2 + 14, format_uncertain(joint.values[row], joint.sd[row])) +
               svg_text(middle, at.y + pair_cell / 2 + 32, pretty_unit(joint.units[row]));
      } else if (row > column) {
        svg += frame_of(at) + ellipses_of(at, r);
      } else {
        svg += svg_text(middle, at.y + pair_cell / 2 + 6, format_fixed(r, 2), "middle",
                        fmt::format("font-size=\"{:.0f}\"", 13 + 9 * std::abs(r)));
      }
    }
  for (std::size_t i = 0; i < n; ++i) {
    const std::string unit = pretty_unit(joint.units[i]);
    const std::string label = joint.names[i] + (unit.empty() ? "" : " (" + unit + ")");
    const Corner below = corner_of(n, i), beside = corner_of(i, 0);
    if (i + 1 < n)
      svg += svg_text(below.x, below.y + 4, offset_of(joint.sd[i], -2), "start", tick_font) +
             svg_text(below.x + pair_cell, below.y + 4, offset_of(joint.sd[i], 2), "end", tick_font) +
             svg_text(below.x + pair_cell / 2, below.y + 22, label);
    if (i > 0)
      svg +=
          svg_text(pairs_left - 34, beside.y + pair_cell / 6 + 4, offset_of(joint.sd[i], 2), "middle", tick_font) +
          svg_text(pairs_left - 34, beside.y + pair_cell * 5 / 6 + 4, offset_of(joint.sd[i], -2), "middle",
                   tick_font) +
          svg_text(
              pairs_left - 72, beside.y + pair_cell / 2, label, "middle",
              fmt::format("transform=\"rotate(-90 {:.1f} {:.1f})\"", pairs_left - 72, beside.y + pair_cell / 2));
  }
  return svg + "</g>\n</svg>\n";
}

}  // namespace secular::report
