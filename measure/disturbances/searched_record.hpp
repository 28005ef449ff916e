#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/watched_reader.hpp"
#include "measure/disturbances/disturbance.hpp"
#include "measure/disturbances/lines.hpp"
#include "measure/disturbances/wrong_samples.hpp"

namespace secular {

/// One channel of a record, with what several rows of the catalogue need. It may be moved, not copied.
struct SearchedChannel {
  /// Of the longest stretch in which no channel lacks a sample, or `mended` in its place.
  std::span<const double> samples;
  const ChannelValues* values = nullptr;  ///< of them, as the file holds them
  std::size_t missing = 0;                ///< samples of the record that are no finite numbers
  std::size_t filled = 0;                 ///< that are none in its file, and follow from what is around them
  double rms = 0;                         ///< about the mean
  std::vector<Line> lines;                ///< that stand out of the spectrum around them
  std::vector<double> powers;             ///< of that spectrum
  WrongSamples wrong;
  bool is_held = false, has_spikes = false, has_knocks = false;  ///< and none of these is the motion's own
  std::vector<std::size_t> masked;                               ///< what is replaced, rising
  std::vector<double> mended;                                    ///< empty where nothing is
  bool is_broken = false;  ///< some of the masked stay as they are, since nothing around tells them
  /// The longest stretch of `samples` without such ones: all of them where none is. Lines and powers are its.
  std::span<const double> intact;

  /// The sample that it begins with.
  std::size_t intact_from() const { return static_cast<std::size_t>(intact.data() - samples.data()); }

  /// Disturbance::treated of wrong samples.
  std::string_view treated_as() const { return is_broken ? "left_out" : "masked"; }
};

/// A record as the rows of the catalogue look at it. Campaign, samples and values must live as long.
struct SearchedRecord {
  const Campaign* campaign = nullptr;
  std::size_t index = 0;
  std::size_t total = 0;                       ///< samples of the record, with those cut off
  std::size_t lost_rows = 0;                   ///< of them, rows that its file does not hold
  std::vector<Unrecorded> unrecorded;          ///< of them, where nothing was recorded
  double start_s = 0, rate = 0, jitter_s = 0;  ///< of the stretch; Hz
  double level = 0;  ///< false alarm of one row on one channel: that per campaign over records x channels
  std::vector<SearchedChannel> channels;
  std::vector<std::size_t> doubled;  ///< rows that the file holds twice, rising: doubled_rows()

  const RecordEntry& entry() const { return campaign->records[index]; }
  const Channel& channel(std::size_t c) const { return campaign->channels[c]; }
  bool is_excitation(std::size_t c) const { return channel(c).role == ChannelRole::excitation; }
  std::size_t samples() const { return channels.empty() ? 0 : channels.front().samples.size(); }
  double time_s(std::size_t sample) const { return start_s + static_cast<double>(sample) / rate; }

  /// Something of that size all over one channel, in the channel's unit.
  Disturbance found(std::string_view kind, std::size_t channel, double size) const;
  /// The same over what is intact of it.
  Disturbance found_in_intact(std::string_view kind, std::size_t channel, double size) const;
};

/// Of accelerations and velocities of a bounded motion the mean is zero, as that of an excitation; quadratic terms
/// give a displacement one.
bool has_no_mean(const Channel& channel);

/// Values are those of each channel's longest stretch in which no channel lacks a sample.
SearchedRecord searched(const Campaign& campaign, std::size_t index, const Record& record,
                        const std::vector<ChannelValues>& values);

/// The longest stretch of a record in which no channel lacks a sample, by channel.
std::vector<std::span<const double>> complete_stretch(const Record& record);

}  // namespace secular
