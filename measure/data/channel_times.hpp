#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "measure/formats/data_file.hpp"

namespace secular {

/// Whole steps by which each channel begins after the first of `stamps_s`, where the file keeps times of their own
/// for channels: "tip.t" of a UFF channel "tip", or a time beside the channel in its struct or group ("run.t" of
/// "run.tip"). Nothing for others. `time` is the variable that the stamps come from; without stamps, the first
/// channel's own time is the reference. Throws InputError for another rate, and for a begin between two samples:
/// that would be a delay between channels.
std::vector<std::optional<std::ptrdiff_t>> channel_delays(const DataFile& data, const std::string& time,
                                                          const std::vector<std::string>& channels,
                                                          const std::vector<double>& stamps_s);

/// Shifts channels to one axis by their delays (none: zero), and cuts them to the stretch that all of them have;
/// how many samples after the axis that begins.
std::ptrdiff_t align_channels(std::vector<std::vector<double>>& channels,
                              const std::vector<std::optional<std::ptrdiff_t>>& delays);

}  // namespace secular
