#include "measure/data/delayed_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "measure/data/all_pass_delay.hpp"

namespace secular {
namespace {

/// Samples on either side of an instant, fewer next to the ends of a record.
constexpr std::ptrdiff_t half_width = 16;

// Weights of Lagrange's polynomial through 2m samples at `share` of the way from the m-th to the next.
std::vector<double> weights_of(std::ptrdiff_t m, double share) {
  std::vector<double> weights(static_cast<std::size_t>(2 * m), 1.0);
  for (std::ptrdiff_t j = 0; j < 2 * m; ++j)
    for (std::ptrdiff_t k = 0; k < 2 * m; ++k)
      if (k != j)
        weights[static_cast<std::size_t>(j)] *=
            (share + static_cast<double>(m - 1 - k)) / static_cast<double>(j - k);
  return weights;
}

// `count` samples of a channel from `place` (in samples from its begin) on, by polynomials.
std::vector<double> interpolated_from(const std::vector<double>& samples, double place, std::size_t count) {
  const auto first = static_cast<std::ptrdiff_t>(std::floor(place)),
             all = static_cast<std::ptrdiff_t>(samples.size());
  const double share = place - static_cast<double>(first);
  const std::vector<double> inside = weights_of(half_width, share);
  std::vector<double> moved(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::ptrdiff_t base = first + static_cast<std::ptrdiff_t>(i);
    const std::ptrdiff_t m = share == 0 ? 0 : std::min({half_width, base + 1, all - 1 - base});
    if (m == 0) {
      moved[i] = samples[static_cast<std::size_t>(base)];
      continue;
    }
    const std::vector<double> weights = m == half_width ? inside : weights_of(m, share);
    moved[i] = std::inner_product(weights.begin(), weights.end(), samples.begin() + (base - m + 1), 0.0);
  }
  return moved;
}

// The same: by an all-pass, which leaves noise as it is, where samples before and behind suffice.
std::vector<double> samples_from(const std::vector<double>& samples, double place, std::size_t count) {
  std::vector<double> moved = interpolated_from(samples, place, count);
  const double whole = std::round(place);
  if (place == whole) return moved;
  const AllPassDelay delay(whole - place);
  const std::vector<double> delayed = delay(samples);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = static_cast<std::size_t>(whole) + i + AllPassDelay::order;
    if (at >= delay.settled() && at < delayed.size()) moved[i] = delayed[at];
  }
  return moved;
}

// Rows whose interpolation takes an unusable one, after `first` rows have been cut off.
std::vector<std::size_t> unusable_after(const Record& record, double earliest, double latest, std::size_t first,
                                        std::size_t count) {
  std::set<std::size_t> rows;
  for (const std::size_t row : record.unusable) {
    const auto at = static_cast<std::ptrdiff_t>(row) - static_cast<std::ptrdiff_t>(first);
    const std::ptrdiff_t from = at - static_cast<std::ptrdiff_t>(std::ceil(latest)) - half_width,
                         to = at - static_cast<std::ptrdiff_t>(std::floor(earliest)) + half_width;
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, from); i <= to && i < static_cast<std::ptrdiff_t>(count);
         ++i)
      rows.insert(static_cast<std::size_t>(i));
  }
  return {rows.begin(), rows.end()};
}

}  // namespace

Record without_delays(const Campaign& campaign, Record record, const std::string& file) {
  double earliest = 0, latest = 0;  // in samples
  std::string later, earlier;       // the channels that are
  for (const Channel& channel : campaign.channels) {
    const double late = channel.delay_s * record.sample_rate_hz;
    if (late < earliest) earlier = channel.name;
    if (late > latest) later = channel.name;
    earliest = std::min(earliest, late);
    latest = std::max(latest, late);
  }
  if (earliest == 0 && latest == 0) return record;
  const std::size_t all = record.samples();
  const double cut = std::ceil(-earliest) + std::ceil(latest);
  if (!(cut < 0.5 * static_cast<double>(all)))
    throw InputError((campaign.folder / "campaign.toml").string(),
                     fmt::format("delay_s of {}", later.empty() || -earliest > latest ? earlier : later),
                     fmt::format("leaves less than half of {}, which is {:.4g} s long", file,
                                 static_cast<double>(all) / record.sample_rate_hz),
                     "a delay in seconds was expected");
  const auto first = static_cast<std::size_t>(std::ceil(-earliest));
  const std::size_t count = all - static_cast<std::size_t>(cut);
  // An all-pass would carry an unusable sample far along the record.
  const auto& moved = record.unusable.empty() ? samples_from : interpolated_from;
  record.unusable = unusable_after(record, earliest, latest, first, count);
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const double late = campaign.channels[c].delay_s * record.sample_rate_hz;
    record.channels[c] = moved(record.channels[c], static_cast<double>(first) + late, count);
  }
  record.start_s += static_cast<double>(first) / record.sample_rate_hz;
  record.cut_for_delay = all - count;
  record.lost.clear();
  record.no_numbers.clear();
  return record;
}

LineRow without_delays(const Campaign& campaign, LineRow row) {
  for (TableLine& line : row.lines)
    line.amplitude *= std::polar(
        1.0, 2 * std::numbers::pi * line.number.of(row.frequency_hz) * campaign.channels[line.channel].delay_s);
  return row;
}

}  // namespace secular
