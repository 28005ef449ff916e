#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "measure/data/time_span.hpp"
#include "measure/data/watched_reader.hpp"
#include "measure/disturbances/disturbance.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// Indices of the records that a window chooses.
std::set<std::size_t> records_within(const Campaign& campaign, const Window& window);

/// Throws InputError where no record's file matches, with those that there are.
void require_match(const Campaign& campaign, const Window& window);

/// From when to when.
TimeSpan span_of(const Window& window);

/// Throws InputError where records are chosen of what is a single file.
void require_any_record(const std::string& file, const Window& window);

/// Throws InputError for a band that goes beyond half the sample rate (0: there is none).
void require_sampled(const Window& window, double sample_rate_hz);

/// Says of clipping among these that it was left out (SelectedRecords::leave_clipped_out).
void list_clipped_as_left_out(std::vector<Disturbance>& found);

/// The records of a campaign that a window chooses, filtered to its band, and what is wrong with their samples. May
/// be read by several threads. The campaign must live as long.
class SelectedRecords {
 public:
  /// `look`: what else looks at what the window leaves of records. Throws InputError as the two above do, and where
  /// no record has a sample in the window.
  SelectedRecords(const Campaign& campaign, const Window& window, WatchedReader::Look look = {});

  /// As WatchedReader::read(), filtered to the band.
  Record read(std::size_t record);
  std::vector<std::string> warnings() const { return reader_.warnings(); }
  /// WatchedReader::leave_clipped_out
  void leave_clipped_out() { reader_.leave_clipped_out(); }
  /// WatchedReader::clipped_records
  std::size_t clipped_records() const { return reader_.clipped_records(); }

 private:
  const Campaign& campaign_;
  Window window_;
  WatchedReader reader_;
};

}  // namespace secular
