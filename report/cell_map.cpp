#include "report/cell_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "input/markup.hpp"
#include "report/number_format.hpp"
#include "report/palette.hpp"
#include "report/svg_cleanup.hpp"

namespace secular::report {
namespace {

constexpr double map_top = 62, row_height = 30, letter_px = 7.2;

double widest(const std::vector<std::string>& texts) {
  std::size_t most = 8;
  for (const std::string& text : texts) most = std::max(most, code_points(text));
  return letter_px * static_cast<double>(most) + 16;
}

std::string heading(const std::string& title, double x) {
  return svg_text(x, 20, title, "start", "font-size=\"16\" font-weight=\"600\"");
}

void check_sizes(std::size_t rows, std::size_t columns, const std::vector<std::vector<double>>& values) {
  if (values.size() != rows || std::any_of(values.begin(), values.end(),
                                           [&](const std::vector<double>& row) { return row.size() != columns; }))
    throw std::invalid_argument("cell map or bars: sizes differ");
}

}  // namespace

std::string cell_map(const CellMap& map, double full) {
  check_sizes(map.rows.size(), map.columns.size(), map.values);
  const double left = widest(map.rows), cell = std::max(58.0, widest(map.columns));
  const double right = left + cell * static_cast<double>(map.columns.size());
  const double bottom = map_top + row_height * static_cast<double>(map.rows.size());
  std::string svg = svg_head({map.title, static_cast<int>(std::max(right, 420.0)) + 16,
                              static_cast<int>(bottom) + 52, FigureUse::inline_html});
  svg += "<g font-size=\"13\">\n" + heading(map.title, 8) + svg_text(8, 42, map.values_are, "start");
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    const double y = map_top + row_height * static_cast<double>(r);
    svg += svg_text(left - 8, y + 20, map.rows[r], "end");
    for (std::size_t c = 0; c < map.columns.size(); ++c) {
      const double x = left + cell * static_cast<double>(c), value = map.values[r][c];
      const double shade =
          std::isfinite(value) && value > 1 ? std::min(1.0, std::log(value) / std::log(full)) * 0.45 : 0;
      svg += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"var(--{})\" "
          "fill-opacity=\"{:.2f}\" "
          "stroke=\"currentColor\" stroke-opacity=\"0.2\"/>\n",
          x, y, cell, row_height, vermilion.name, shade);
      if (std::isfinite(value)) svg += svg_text(x + cell / 2, y + 20, format_number(value, 2), "middle");
    }
  }
  for (std::size_t c = 0; c < map.columns.size(); ++c)
    svg += svg_text(left + cell * (static_cast<double>(c) + 0.5), bottom + 18, map.columns[c], "middle");
  svg += svg_text((left + right) / 2, bottom + 40, map.columns_are, "middle");
  return svg + "</g>\n</svg>\n";
}

std::string share_bars(const ShareBars& bars) {
  check_sizes(bars.rows.size(), bars.names.size(), bars.values);
  const double left = widest(bars.rows), length = 420;
  const double bar = 13, step = bar * static_cast<double>(bars.names.size()) + 9;
  const double bottom = map_top + step * static_cast<double>(bars.rows.size());
  const PaletteColor colors[] = {blue, brown};
  std::string svg = svg_head(
      {bars.title, static_cast<int>(left + length) + 76, static_cast<int>(bottom) + 46, FigureUse::inline_html});
  svg += "<g font-size=\"13\">\n" + heading(bars.title, 8);
  double key = left;
  for (std::size_t b = 0; b < bars.names.size(); ++b) {
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"35\" width=\"12\" height=\"12\" fill=\"var(--{})\"/>\n", key,
                       colors[b % 2].name) +
           svg_text(key + 18, 46, bars.names[b], "start");
    key += widest({bars.names[b]}) + 30;
  }
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    svg += fmt::format("<path d=\"M{0:.1f},{1:.1f} V{2:.1f}\" stroke=\"currentColor\" stroke-opacity=\"0.2\"/>\n",
                       left + share * length, map_top - 6, bottom) +
           svg_text(left + share * length, bottom + 16, fmt::format("{:.0f}", 100 * share), "middle");
  svg += svg_text(left + length / 2, bottom + 36, "Share (%)", "middle");
  for (std::size_t r = 0; r < bars.rows.size(); ++r) {
    const double y = map_top + step * static_cast<double>(r);
    svg += svg_text(left - 8, y + step / 2, bars.rows[r], "end");
    for (std::size_t b = 0; b < bars.names.size(); ++b) {
      const double value = bars.values[r][b], at = y + bar * static_cast<double>(b);
      const double shown = std::isfinite(value) ? std::clamp(value, 0.0, 1.0) * length : 0;
      svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"var(--{})\"/>\n",
                         left, at, std::max(shown, 0.5), bar - 2, colors[b % 2].name);
      if (std::isfinite(value))
        svg += svg_text(left + shown + 6, at + bar - 3, format_percent(value), "start", "font-size=\"11\"");
    }
  }
  return svg + "</g>\n</svg>\n";
}

}  // namespace secular::report
