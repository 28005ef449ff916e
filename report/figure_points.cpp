#include "report/figure_points.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/number_format.hpp"

namespace secular::report {
namespace {

std::string json_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return quoted + '"';
}

std::string json_axis(const Axis& axis, double low, double high) {
  return fmt::format("[{},{},{:.9g},{:.9g},{}]", json_text(axis.label), json_text(pretty_unit(axis.unit)), low,
                     high, axis.logarithmic ? 1 : 0);
}

std::string json_series(const Series& series) {
  constexpr std::size_t most = 600;
  const std::size_t stride = (series.x.size() + most - 1) / most;
  std::string points;
  for (std::size_t i = 0; i < series.x.size(); i += stride)
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i]))
      points += fmt::format("{}{:.6g},{:.5g}", points.empty() ? "" : ",", series.x[i], series.y[i]);
  return fmt::format("[{},[{}]]", json_text(series.name), points);
}

}  // namespace

std::string figure_points(const Figure& figure, const std::vector<PlotArea>& areas) {
  std::string panels;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const Panel& panel = figure.panels[p];
    const PlotArea& area = areas[p];
    std::string series;
    for (const Series& s : panel.series)
      if (!is_filled(s.style)) series += (series.empty() ? "" : ",") + json_series(s);
    panels += fmt::format("{}{{\"box\":[{:.0f},{:.0f},{:.0f},{:.0f}],\"x\":{},\"y\":{},\"series\":[{}]}}",
                          panels.empty() ? "" : ",", area.left, area.right, area.top, area.bottom,
                          json_axis(figure.x, area.x_low, area.x_high), json_axis(panel.y, area.y_low, area.y_high),
                          series);
  }
  return "[" + panels + "]";
}

}  // namespace secular::report
