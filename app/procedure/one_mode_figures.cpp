#include "app/procedure/one_mode_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numerics/hertz.hpp"

namespace secular::app {

using Eigen::Index;
using report::Figure;
using report::Series;
using report::SeriesRole;
using report::SeriesStyle;

Figure saddle_node_figure(const ProcedureData& test, const std::vector<const DwellMean*>& points,
                          const SaddleNodeFit& right, const SaddleNodeFit& printed, bool cubic) {
  Figure figure;
  figure.title =
      cubic ? "Saddle-node diagram, linear and cubic damping" : "Saddle-node diagram, linear and quadratic damping";
  figure.x = {"Excitation amplitude", "m/s^2", false, {}};
  Series data, line, other;
  data.name = "measured";
  data.style = SeriesStyle::error_bars;
  data.role = SeriesRole::data;
  line.name = "saddle-node";
  other.name = "as printed";
  other.role = SeriesRole::alternative;
  const double w0 = 0.5 * test.centre;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const DwellMean& c = *points[i];
    const double a = c.amplitude, y = cubic ? a * a : a;
    data.x.push_back(c.forcing);
    data.y.push_back(y);
    data.y_error.push_back(2 * (cubic ? 2 * a : 1) * c.amplitude_sd);
    const auto at = static_cast<Index>(i);
    // The force of the line is lowered in proportion to its own factor, 1 as printed.
    const auto lowered = [&](const SaddleNodeFit& fit) {
      const double nonlinear =
          fit.nonlinear * (cubic ? 0.375 * std::pow(w0, 3) * a * a : 4 * w0 * w0 / (3 * std::numbers::pi) * a);
      const double factor = fit.fitted(at) / (w0 * fit.linear + nonlinear);
      return factor * (w0 * fit.lowered_linear + nonlinear);
    };
    line.x.push_back(lowered(right));
    line.y.push_back(y);
    other.x.push_back(lowered(printed));
    other.y.push_back(y);
  }
  figure.panels.push_back(
      {"",
       {cubic ? "Amplitude squared" : "Peak amplitude", cubic ? "kg m^2" : test.unit, false, {}},
       {data, line, other}});
  return figure;
}

Figure response_figure(const ProcedureData& test, const SaddleNodeFit& damping,
                       const FrequencyResponseFit& response, NonlinearDamping law) {
  const double w0 = 0.5 * test.centre;
  std::vector<double> levels;
  for (const DwellMean& c : test.dwells) levels.push_back(c.forcing);
  std::sort(levels.begin(), levels.end());
  double level = levels.front();
  std::ptrdiff_t most = 0;
  for (const double l : levels) {
    const auto near =
        std::count_if(levels.begin(), levels.end(), [&](double o) { return std::abs(o / l - 1) < same_level; });
    if (near > most) {
      most = near;
      level = l;
    }
  }
  Figure figure;
  figure.title = fmt::format("Frequency response at F = {:.4g}", level);
  figure.x = {"Excitation frequency", "Hz", false, {}};
  Series data, upper, lower;
  data.name = "measured";
  data.style = SeriesStyle::error_bars;
  data.role = SeriesRole::data;
  for (const DwellMean& c : test.dwells) {
    if (std::abs(c.forcing / level - 1) > same_level) continue;
    data.x.push_back(c.frequency * to_hz);
    data.y.push_back(c.amplitude);
    data.y_error.push_back(2 * c.amplitude_sd);
  }
  upper.name = "Eq. (5.25), side of the measured points";
  lower.name = "Eq. (5.25), beyond the peak";
  lower.role = SeriesRole::unstable;
  const double eta = std::abs(response.excitation);
  // The amplitude where the radicand vanishes, by doubling and bisection.
  const auto radicand = [&](double a) {
    const double d =
        w0 * damping.lowered_linear + damping.nonlinear * (law == NonlinearDamping::cubic
                                                               ? 0.375 * std::pow(w0, 3) * a * a
                                                               : 4 * w0 * w0 / (3 * std::numbers::pi) * a);
    return level * level - d * d;
  };
  double high = data.y.empty() ? 1e-3 : *std::max_element(data.y.begin(), data.y.end());
  for (int i = 0; i < 40 && radicand(high) > 0; ++i) high *= 1.2;
  double low = 0;
  for (int i = 0; i < 60; ++i) (radicand(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  const double softening = response.stiffness < 0 ? 1 : -1;
  for (int i = 0; i <= 200; ++i) {
    const double a = low * i / 200, root = eta * std::sqrt(std::max(0.0, radicand(a)));
    const auto frequency = [&](double side) {
      return (2 * w0 + 2 / w0 * (response.stiffness * a * a + side * root)) * to_hz;
    };
    upper.x.push_back(frequency(softening));
    upper.y.push_back(a);
    lower.x.push_back(frequency(-softening));
    lower.y.push_back(a);
  }
  figure.panels.push_back({"", {"Peak amplitude", test.unit, false, {}}, {data, upper, lower}});
  return figure;
}

}  // namespace secular::app
