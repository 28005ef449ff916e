#include "measure/disturbances/doubled_rows.hpp"

#include <algorithm>
#include <cmath>

#include "measure/data/resolution.hpp"
#include "measure/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/median.hpp"

namespace secular {
namespace {

// Samples to either side that tell the scatter of differences.
std::size_t about() {
  return 2 * measure_thresholds().local_samples;
}

// What a sample's difference from the one before is beyond a third of that from two before to one behind it.
double beyond_neighbours(double before, double first, double second, double behind) {
  return second - first - (behind - before) / 3;
}

// Standard deviation of that about a run, from `begin` to before `end`.
double scatter_about(std::span<const double> x, std::size_t begin, std::size_t end) {
  std::vector<double> beyond;
  const std::size_t first = begin - std::min(begin - 2, about()), last = std::min(x.size() - 1, end + about());
  for (std::size_t i = std::max<std::size_t>(first, 2); i < last; ++i)
    if (x[i] != x[i - 1] && x[i + 1] != x[i] && x[i - 1] != x[i - 2])
      beyond.push_back(std::abs(beyond_neighbours(x[i - 2], x[i - 1], x[i], x[i + 1])));
  return beyond.empty() ? 0.0 : sd_of_median * upper_median(std::move(beyond));
}

// docs/inference.md (75): squares of D and H over those of their standard deviations.
struct Misfits {
  double doubled = 0, held = 0;
  std::size_t count = 0;

  void add(std::span<const double> x, const HeldSamples::Run& run) {
    const double sd = scatter_about(x, run.begin, run.end);
    if (!(sd > 0)) return;
    const auto n = static_cast<double>(run.end - run.begin);
    const double share = (n + 1) / (n + 3), across = x[run.end + 1] - x[run.begin - 2];
    doubled += std::pow(beyond_neighbours(x[run.begin - 2], x[run.begin - 1], x[run.end], x[run.end + 1]) / sd, 2);
    held +=
        std::pow((x[run.end] - x[run.begin - 1] - share * across) / sd, 2) * (1 + 1.0 / 9) / (1 + share * share);
    ++count;
  }
};

bool repeats(std::span<const double> x, const ChannelValues& values, const HeldSamples::Run& run) {
  const SameValue same(values.sorted);
  for (std::size_t i = run.begin; i < run.end; ++i)
    if (!same(x[i], x[i - 1])) return false;
  return true;
}

}  // namespace

std::vector<std::size_t> doubled_rows(const SearchedRecord& record,
                                      const std::vector<std::span<const double>>& samples) {
  std::vector<HeldSamples::Run> runs;
  for (const SearchedChannel& channel : record.channels)
    if (channel.values->clipping.found()) return {};
  for (std::size_t c = 0; c < record.channels.size(); ++c)
    for (const HeldSamples::Run& run : record.channels[c].wrong.held.runs)
      if (run.begin >= 2 && run.end + 1 < samples[c].size()) runs.push_back(run);
  for (std::size_t c = 0; c < record.channels.size(); ++c)
    std::erase_if(
        runs, [&](const HeldSamples::Run& run) { return !repeats(samples[c], *record.channels[c].values, run); });
  std::sort(runs.begin(), runs.end(),
            [](const HeldSamples::Run& a, const HeldSamples::Run& b) { return a.begin < b.begin; });
  std::vector<std::size_t> rows;
  Misfits misfits;
  for (const HeldSamples::Run& run : runs) {
    if (!rows.empty() && run.begin <= rows.back()) continue;  // of another channel
    for (const std::span<const double> x : samples) misfits.add(x, run);
    for (std::size_t i = run.begin; i < run.end; ++i) rows.push_back(i);
  }
  const bool doubled = misfits.held - misfits.doubled > -2 * std::log(record.level) &&
                       chi_squared_upper_tail(misfits.doubled, static_cast<double>(misfits.count)) > record.level;
  return doubled ? rows : std::vector<std::size_t>();
}

std::vector<std::size_t> beside_doubled(const std::vector<std::size_t>& places,
                                        const std::vector<std::size_t>& doubled) {
  std::vector<std::size_t> beside;
  for (const std::size_t place : places)
    if (!std::binary_search(doubled.begin(), doubled.end(), place) &&
        !std::binary_search(doubled.begin(), doubled.end(), place + 1))
      beside.push_back(place);
  return beside;
}

}  // namespace secular
