#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "blind/motion.hpp"
#include "blind/random.hpp"
#include "blind/structure.hpp"

namespace secular::blind {

/// How one record differs from the others.
struct RecordLot {
  double frequency_factor = 1;  ///< of every natural frequency
  double late_s = 0;            ///< of the responses behind the excitation
};

/// What disturbs the records of a campaign and is no cause of a gap, by the names of docs/simulating.md. A size of
/// 0: it is not there. Sizes by channel are in the channel's unit.
struct Disturbances {
  std::vector<std::string> kinds;  ///< of those that are there, in the order of `disturbance_kinds`
  std::vector<double> hum;         ///< foreign_tone: amplitude at `hum_hz`, a third of it at 3 times that
  double hum_hz = 50;              ///< of mains, off by up to 0.05 Hz
  std::vector<double> step;        ///< converter_step
  std::vector<double> coloured;    ///< coloured_noise: standard deviation of noise of first order
  double correlation_s = 1;        ///< its correlation time
  std::vector<double> ringing;     ///< neighbour_mode: amplitude at a record's begin, response channels alone
  double ringing_hz = 1, ringing_rate = 1;  ///< its frequency, and its decay rate in 1/s
  std::vector<double> spike;                ///< spikes: their height
  std::size_t spikes_per_record = 0;
  double held_share = 0;            ///< held_samples: share of samples that repeat the one before
  std::size_t lost_per_record = 0;  ///< lost_samples: rows that a file does not hold
  double latest_s = 0;              ///< late_record: responses of a record are late by 0 up to this
  double frequency_scatter = 0;     ///< record_scatter: standard deviation of natural frequencies, relative
  std::vector<RecordLot> records;   ///< by record; empty: all alike
  std::vector<double> wander;       ///< offset_wander: standard deviation of a random walk at a record's end

  RecordLot of_record(std::size_t record) const { return records.empty() ? RecordLot{} : records.at(record); }
  /// Standard deviation of white noise with the density that coloured noise has at `hz`.
  double coloured_as_white(std::size_t channel, double hz) const;
};

/// Names of all kinds.
const std::vector<std::string>& disturbance_kinds();

/// What the sizes of disturbances are counted in.
struct DisturbedCampaign {
  std::vector<double> rms, peak;  ///< by channel
  double highest_natural_hz = 1;
  std::size_t records = 0;
};

/// Draws one to three kinds and their sizes.
Disturbances draw_disturbances(const DisturbedCampaign& campaign, Random& random);

/// Disturbs the samples of one record, channel 0 the excitation; not yet its converter (noise comes before it).
void disturb_samples(const Disturbances& disturbances, Random& random, std::vector<std::vector<double>>& channels);

/// What comes after noise and saturation: the converter's steps and samples that are held.
void convert_samples(const Disturbances& disturbances, Random& random, std::vector<std::vector<double>>& channels);

/// Rows that the file of a record of `samples` rows does not hold, in rising order: never the first nor the last.
std::vector<std::size_t> lost_rows(const Disturbances& disturbances, std::size_t samples, Random& random);

}  // namespace secular::blind
