#include "measure/disturbances/catalogue.hpp"

#include <algorithm>
#include <array>

#include "measure/disturbances/rows.hpp"

namespace secular {

// A table, as long as there are kinds of disturbances: one row each.
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
      DisturbanceKind{"offset",
                      "a mean where the motion has none: of accelerations, velocities and excitations, and of "
                      "displacements in a decay",
                      "mean, in the channel's unit",
                      "means of blocks longer than four turns against their scatter (Student's t)",
                      "a force or a spring of even order seems to act", find_offsets},
      DisturbanceKind{
          "offset_wander", "a zero that moves slower than all motion", "rms about its mean, in the channel's unit",
          "four slow cosines against what the means of blocks scatter beside them, coloured as it is "
          "(F law); what follows the square of the motion is the motion's own",
          "looks like a stiffness or a position of rest that changes; leaks into slow lines", find_wander},
      DisturbanceKind{
          "neighbour_mode", "in a dwell: a line that has gone in the second half, of another mode or of the start",
          "amplitude at the begin, in the channel's unit",
          "the first block's line over that of 8 to 32 late ones (F law), blocks of many lengths",
          "early ensembles differ from late ones; a mode outside of the model seems to be driven", find_ringing},
      DisturbanceKind{
          "coloured_noise", "noise of a response whose correlation falls exponentially, beside white noise",
          "standard deviation, in the channel's unit",
          "by diagnose, from what the model leaves between multiples of the motion (likelihood ratio of "
          "Whittle's)",
          "slow rows scatter more than fast ones: a law of the structure seems to act"},
      DisturbanceKind{"spikes", "single samples that neighbours do not go with",
                      "the largest, in the channel's unit",
                      "a gap between the largest and the tail of all (spacings of ordered values, F law), or the "
                      "tail that most of them have; putting the one sample right puts its neighbours right",
                      "white noise of the spikes' energy in every line", find_spikes},
      DisturbanceKind{"knock", "a few samples that stand out together: a blow beside the test, a loose contact",
                      "the largest, in the channel's unit", "as spikes, but neighbours stand out too",
                      "the motion starts anew: what follows rings", find_knocks},
      DisturbanceKind{"held_samples", "samples that repeat the one before although the signal goes on",
                      "number of samples",
                      "equal neighbours against what chance makes at that slope, noise and step (Poisson law)",
                      "noise that follows the slope: amplitudes are lost, phases delayed", find_held_samples},
      DisturbanceKind{"lost_samples",
                      "rows that are not in the file, samples that are no numbers, or that are one and the same "
                      "number wherever the signal stood, or where nothing was recorded at either end",
                      "number of samples",
                      "they are counted; a number that stands for lost samples is met more often than others "
                      "(Poisson law) and is come to from far, or is that of spikes",
                      "up to 16 in a row are replaced; ends of a record are cut off; a longer gap is refused",
                      find_lost_samples},
      DisturbanceKind{"clipping", "samples stuck at the ends of the range", "number of samples",
                      "more peaks end at one value than smooth peaks do (binomial law, one in a million)",
                      "amplitudes are too small, and harmonics appear that the motion has not", find_clipped},
      DisturbanceKind{"uneven_time", "time stamps that scatter about even ones", "rms, s",
                      "beyond the rounding of the stamps", "noise of 2 pi f times the scatter in a tone of f Hz",
                      find_time_scatter},
      DisturbanceKind{"late_record", "responses late against their excitation, by record", "s",
                      "by identify, from a case's equations with and without phases of their own (F law)",
                      "phases tell neither damping nor force: the fit does without them"},
      DisturbanceKind{"blow_mismatch", "a blow that does not do what its excitation says, by record",
                      "strength over the mean of all blows, less one",
                      "by diagnose, where nothing is left of what follows blows: each is fitted with a strength of "
                      "its own (chi-squared of what strengths differ by, and of what is left)",
                      "an effect of the excitation seems to act: what drives blows does not count"},
      DisturbanceKind{
          "record_scatter", "a natural frequency that differs from record to record",
          "distance from the mean of all records, rad/s (in a diagnosis relative)",
          "by identify, from what decays show beyond what their stretches scatter (F law); by diagnose, from "
          "what the explanation leaves of each record's frequency",
          "stretches of one decay are no independent conditions: error bars know it"},
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
  const std::vector<std::span<const double>> stretch = complete_stretch(record);
  for (std::size_t c = 0; c < stretch.size(); ++c) values.push_back(values_of(record, c, stretch[c]));
  return find_disturbances(campaign, index, record, values);
}

}  // namespace secular
