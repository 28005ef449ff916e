#include "measure/disturbances/catalogue.hpp"

#include <array>

#include "measure/disturbances/rows.hpp"

namespace secular {

std::span<const DisturbanceKind> disturbance_catalogue() {
  static constexpr std::array kinds = {
      DisturbanceKind{"foreign_tone",
                      "a steady line that neither the excitation nor harmonics of the response make: mains hum, "
                      "a neighbouring machine",
                      "peak amplitude, in the channel's unit",
                      "line over the noise beside it, of any colour (F law), and of one size in both halves",
                      "is taken for motion where it falls on a line of the motion, and for noise elsewhere",
                      find_foreign_tones},
      DisturbanceKind{
          "converter_step", "values on a lattice that the noise does not blur",
          "step of the lattice, in the channel's unit",
          "gaps between values that are multiples of the smallest (binomial law); the lines that such a "
          "converter makes are above the noise of a line over the record",
          "makes harmonics that repeat from turn to turn: they look like a law of the structure",
          find_converter_steps},
  };
  return kinds;
}

std::vector<Disturbance> find_disturbances(const Campaign& campaign, std::size_t index, const Record& record,
                                           const std::vector<ChannelValues>& values) {
  std::vector<Disturbance> found;
  const SearchedRecord look = searched(campaign, index, record, values);
  for (const DisturbanceKind& kind : disturbance_catalogue())
    if (kind.find != nullptr) kind.find(look, found);
  return found;
}

std::vector<Disturbance> find_disturbances(const Campaign& campaign, std::size_t index, const Record& record) {
  std::vector<ChannelValues> values;
  for (const std::span<const double> samples : complete_stretch(record)) values.push_back(values_of(samples));
  return find_disturbances(campaign, index, record, values);
}

}  // namespace secular
