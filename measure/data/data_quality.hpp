#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace secular {

/// Something wrong or doubtful in data, for the person who has to decide about it.
struct DataFault {
  std::string kind;  ///< missing | fill_value | constant | range | clipping | offset | coarse | time | unreadable
  std::string text;  ///< "6 of 1000 samples are missing, first at line 12"
};

/// Levels of one channel over one record, in the channel's unit, and what is doubtful about it.
struct ChannelQuality {
  std::size_t samples = 0, missing = 0;
  double mean = 0;
  double rms = 0;   ///< about the mean
  double peak = 0;  ///< largest absolute value
  double minimum = 0, maximum = 0;
  std::optional<double> noise;       ///< rms, see noise_floor
  std::optional<double> resolution;  ///< the quantum the samples are multiples of
  std::vector<DataFault> faults;
};

/// Judges the samples of a channel; missing ones are NaN (or infinite). Offset: the mean differs from zero by more
/// than 4 standard errors (from the means of 16 blocks) and 5 % of the rms. Clipping: see find_clipping. Coarse:
/// the range has fewer than 64 quanta.
ChannelQuality check_channel(std::span<const double> samples);

}  // namespace secular
