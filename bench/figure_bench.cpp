#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "report/figure.hpp"

namespace secular::report {
namespace {

/// A response curve of a long record: what a report's figure costs as its number of points grows.
void draw_line(benchmark::State& state) {
  Figure figure;
  figure.x = {"Time", "s", false, {}};
  Series line;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    line.x.push_back(static_cast<double>(i) / 256);
    line.y.push_back(std::sin(0.37 * static_cast<double>(i)));
  }
  Panel panel;
  panel.series = {line};
  figure.panels = {panel};
  std::size_t bytes = 0;
  for (auto _ : state) bytes = render_figure(figure, "figure").svg.size();
  state.counters["svg_bytes"] = static_cast<double>(bytes);
}
BENCHMARK(draw_line)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace secular::report
