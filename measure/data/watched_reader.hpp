#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/clipping.hpp"
#include "measure/data/resolution.hpp"

namespace secular {

/// The values of one channel of a record, whatever their order in time.
struct ChannelValues {
  std::vector<double> sorted;
  ValueGrid grid;
  Clipping clipping;
};

/// All samples must be finite.
ChannelValues values_of(std::span<const double> samples);

/// Those of a stretch of a channel without the samples that its file does not hold: what takes their place lies on
/// no converter's lattice.
ChannelValues values_of(const Record& record, std::size_t channel, std::span<const double> stretch);

/// What mends a record each time that it is read.
struct Treatment {
  /// Samples, by channel and rising, that are replaced by what those around them tell (fill_gaps).
  std::vector<std::vector<std::size_t>> masked;
  std::function<void(Record&)> then;  ///< what is done after that; none: nothing
};

/// Reads the records of a campaign and keeps in mind which channels are clipped and where time stamps scatter, for
/// whoever uses them. Channels that are late come in step, and responses that are absolute become relative to the
/// base. Records may be read by several
/// threads, and more than once. The campaign must live as long.
class WatchedReader {
 public:
  /// What else looks at every record, once, when it is read for the first time: in any thread.
  using Look = std::function<void(std::size_t, const Record&, const std::vector<ChannelValues>&)>;

  /// What mends a record, found once, when it is read for the first time: in any thread.
  using Treat = std::function<Treatment(std::size_t, const Record&, const std::vector<ChannelValues>&)>;

  explicit WatchedReader(const Campaign& campaign, Look look = {}, Treat treat = {})
      : campaign_(campaign), look_(std::move(look)), treat_(std::move(treat)) {}

  /// As read_record does, mended, relative to the base. What cannot be mended is unusable (Record::unusable).
  Record read(std::size_t record);

  /// From now on samples at an end of their channel's range (clipping) are unusable, too.
  void leave_clipped_out();

  /// Of the records that were read, those with such samples in a channel that a model sees.
  std::size_t clipped_records() const;

  /// One line for each channel that is clipped in some of the records that were read, one for each record with
  /// samples that could not be replaced, and one for the time stamps that scatter most.
  /// `left`: what becomes of the latter.
  enum class WhatIsLeft {
    left_out,  ///< the stretch between them counts
    used,      ///< they are used as they are
  };
  std::vector<std::string> warnings(WhatIsLeft left = WhatIsLeft::left_out) const;

 private:
  const Campaign& campaign_;
  Look look_;
  Treat treat_;
  mutable std::mutex mutex_;
  struct Seen {
    std::vector<Clipping> clipping;  // by channel
    double jitter_of_step = 0;
    std::string jitter;  // in words
    Treatment treatment;
    std::size_t not_replaced = 0;  // rows of its masked samples
  };
  std::map<std::size_t, Seen> seen_;  // by record, whatever the order of reading
  bool leaves_clipped_out_ = false;
};

}  // namespace secular
