#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/data/noise_floor.hpp"
#include "measure/disturbances/rows.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

// Unquantised values lie on a lattice of their smallest gap by chance: one gap in ten does within the tolerance of
// ValueGrid, which wants 95 % of them.
bool is_lattice(const ValueGrid& grid, double level) {
  if (!grid.visited || grid.levels < 4) return false;
  const auto gaps = static_cast<double>(grid.levels - 2);  // beside the smallest, which defines the step
  return binomial_upper_tail(std::ceil(0.95 * gaps), gaps, 0.1) < level;
}

// Amplitude of a line that a quantiser makes of a motion with noise of that sd before it: it repeats from turn to
// turn, and no mean over turns removes it.
double repeated_line(double step, double noise) {
  const double ratio = std::numbers::pi * noise / step;
  return step / std::numbers::pi * std::exp(-2 * ratio * ratio);
}

}  // namespace

void find_converter_steps(const SearchedRecord& record, std::vector<Disturbance>& found) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const SearchedChannel& channel = record.channels[c];
    if (channel.samples.empty() || !is_lattice(channel.values->grid, record.level)) continue;
    const double step = *channel.values->grid.step;
    const std::optional<double> all_noise = noise_floor(channel.samples);
    if (!all_noise) continue;
    const double noise = std::sqrt(std::max(0.0, *all_noise * *all_noise - step * step / 12));
    const double line_sd = *all_noise * std::sqrt(2 / static_cast<double>(channel.samples.size()));
    if (!(repeated_line(step, noise) > line_sd)) continue;
    Disturbance coarse = record.found("converter_step", c, step);
    coarse.text = fmt::format(
        "values are multiples of {:.3g} {}, {} the noise before the converter: lines of up to {:.2g} {} that "
        "repeat",
        step, coarse.unit, noise > 0.01 * step ? fmt::format("{:.2g} times", step / noise) : "more than 100 times",
        repeated_line(step, noise), coarse.unit);
    found.push_back(std::move(coarse));
  }
}

}  // namespace secular
