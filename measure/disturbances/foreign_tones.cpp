#include <fmt/format.h>

#include <cmath>

#include "measure/disturbances/motion_tones.hpp"
#include "measure/disturbances/rows.hpp"

namespace secular {
namespace {

// Mains keep their frequency within 1 % (EN 50160, 99.5 % of a year): the harmonic of a line, and of which mains.
std::string mains_name(double frequency_hz) {
  for (const double mains : {50.0, 60.0}) {
    const double order = std::round(frequency_hz / mains);
    if (order >= 1 && order <= 7 && std::abs(frequency_hz / (order * mains) - 1) < 0.01)
      return order == 1 ? fmt::format(", as of {:g} Hz mains", mains)
                        : fmt::format(", as {:g} times {:g} Hz mains", order, mains);
  }
  return "";
}

// Lines off the excitation's own multiples, of all channels: what a line may have a partner among.
std::vector<double> lines_of_all(const SearchedRecord& record, const MotionTones& motion) {
  std::vector<double> lines;
  for (const SearchedChannel& channel : record.channels)
    for (const Line& line : channel.lines)
      if (!motion.is_harmonic(line.frequency_hz)) lines.push_back(line.frequency_hz);
  return lines;
}

}  // namespace

void find_foreign_tones(const SearchedRecord& record, std::vector<Disturbance>& found) {
  const MotionTones motion(record);
  const std::vector<double> others = lines_of_all(record, motion);
  for (std::size_t c = 0; c < record.channels.size(); ++c)
    for (const Line& line : record.channels[c].lines) {
      if (!line.steady) continue;
      if (motion.make(line.frequency_hz, others) && !motion.is_outlasted_by(line)) continue;
      Disturbance tone = record.found_in_intact("foreign_tone", c, line.amplitude);
      tone.frequency_hz = line.frequency_hz;
      tone.text = fmt::format("a steady tone of {:.5g} Hz and {:.3g} {} that excitation and motion do not make{}",
                              line.frequency_hz, line.amplitude, tone.unit, mains_name(line.frequency_hz));
      found.push_back(std::move(tone));
    }
}

}  // namespace secular
