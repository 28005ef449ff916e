#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/clipping.hpp"

namespace secular {

/// Reads the records of a campaign and keeps in mind which channels are clipped and where time stamps scatter, for
/// whoever uses them. Responses that are absolute become relative to the base. Records may be read by several
/// threads, and more than once. The campaign must live as long.
class WatchedReader {
 public:
  explicit WatchedReader(const Campaign& campaign) : campaign_(campaign) {}

  /// As read_record does, relative to the base.
  Record read(std::size_t record);

  /// One line for each channel that is clipped in some of the records that were read, and one for the time stamps
  /// that scatter most.
  std::vector<std::string> warnings() const;

 private:
  const Campaign& campaign_;
  mutable std::mutex mutex_;
  struct Seen {
    std::vector<Clipping> clipping;  // by channel
    double jitter_of_step = 0;
    std::string jitter;  // in words
  };
  std::map<std::size_t, Seen> seen_;  // by record, whatever the order of reading
};

}  // namespace secular
