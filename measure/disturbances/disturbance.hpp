#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace secular {

/// Something that a record holds beside the motion.
struct Disturbance {
  std::string_view kind;  ///< the name of its row in the catalogue
  std::size_t record = 0;
  std::optional<std::size_t> channel;   ///< none: the record as a whole
  double from_s = 0, to_s = 0;          ///< where it is, in the record's time
  double size = 0;                      ///< what the row measures
  std::string unit;                     ///< of the size
  double share = 0;                     ///< the size over the channel's rms, or the share of samples
  std::optional<double> frequency_hz;   ///< of tones
  std::string text;                     ///< for people, without record and channel
  std::string_view treated = "listed";  ///< or "fitted", as an unknown beside the motion, "masked", "removed", or
                                        ///< "left_out" of what counts
};

}  // namespace secular
