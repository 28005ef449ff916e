#include "measure/data/channel_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "input/input_error.hpp"
#include "measure/data/time_axis.hpp"
#include "measure/thresholds.hpp"

namespace secular {
namespace {

constexpr auto& same_sample = measure_thresholds().same_sample;  // of a step
constexpr double digits_of_start = 1e-5;                         // UFF prints six digits

// The time that belongs to one channel; empty if there is none.
std::string own_time(const DataFile& data, const std::string& channel) {
  const auto& shape = data.variables[data.index_of(channel)].shape;
  const auto count = [](const std::vector<std::size_t>& lengths) {
    return std::accumulate(lengths.begin(), lengths.end(), std::size_t{1}, std::multiplies<>());
  };
  const std::size_t point = channel.rfind('.');
  for (const DataVariable& variable : data.variables) {
    if (!variable.fault.empty() || count(variable.shape) != count(shape)) continue;
    const std::string& name = variable.name;
    if (name == channel + ".t") return name;
    if (point != std::string::npos && name != channel && name.rfind('.') == point &&
        name.compare(0, point, channel, 0, point) == 0 && is_called_time(name))
      return name;
  }
  return {};
}

}  // namespace

std::vector<std::optional<std::ptrdiff_t>> channel_delays(const DataFile& data, const std::string& time,
                                                          const std::vector<std::string>& channels,
                                                          const std::vector<double>& stamps_s) {
  std::vector<std::optional<std::ptrdiff_t>> delays(channels.size());
  std::optional<TimeAxis> reference;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::string own = own_time(data, channels[c]);
    if (own.empty() || own == time) continue;
    if (!reference && !stamps_s.empty()) reference = even_time_axis(stamps_s, data.file, data.place);
    DataFile read =
        read_data_file(data.file, {own}, MissingNumbers::refuse, all_values, DecimalMark::by_dialect, data.segment);
    DataVariable& stamps = read.vector(own);
    convert_to_seconds(stamps, data.file);
    const TimeAxis begun = even_time_axis(stamps.values, data.file, data.place,
                                          reference ? std::optional(reference->sample_rate_hz) : std::nullopt);
    if (!reference) reference = begun;
    const std::string place = "variable " + channels[c];
    const double drift =
        (begun.sample_rate_hz / reference->sample_rate_hz - 1) * static_cast<double>(stamps.values.size());
    if (!(std::abs(drift) <= same_sample))
      throw InputError(data.file, place,
                       fmt::format("is sampled at {} Hz by its own time {}, others at {} Hz", begun.sample_rate_hz,
                                   own, reference->sample_rate_hz),
                       "import channels of one rate together, or resample it first");
    const double steps = (begun.start_s - reference->start_s) * reference->sample_rate_hz;
    const double largest = std::max(std::abs(begun.start_s), std::abs(reference->start_s));
    const double allowed = std::min(same_sample, 1e-6 + digits_of_start * largest * reference->sample_rate_hz);
    if (!(std::abs(steps - std::round(steps)) <= allowed) || std::abs(steps) > 1e15)
      throw InputError(
          data.file, place,
          fmt::format("begins at {} s by its own time {}, {:.4g} steps from the begin of the others at {} s: "
                      "its samples lie between theirs",
                      begun.start_s, own, steps, reference->start_s),
          "resample it to the instants of the others first, or import it by itself");
    delays[c] = std::lround(steps);
  }
  return delays;
}

std::ptrdiff_t align_channels(std::vector<std::vector<double>>& channels,
                              const std::vector<std::optional<std::ptrdiff_t>>& delays) {
  std::ptrdiff_t begin = std::numeric_limits<std::ptrdiff_t>::min(),
                 end = std::numeric_limits<std::ptrdiff_t>::max();
  for (std::size_t c = 0; c < channels.size(); ++c) {
    begin = std::max(begin, delays[c].value_or(0));
    end = std::min(end, delays[c].value_or(0) + static_cast<std::ptrdiff_t>(channels[c].size()));
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    std::vector<double>& samples = channels[c];
    const std::ptrdiff_t delay = delays[c].value_or(0);
    samples.resize(static_cast<std::size_t>(std::max(begin, end) - delay));
    samples.erase(samples.begin(), samples.begin() + (begin - delay));
  }
  return begin;
}

}  // namespace secular
