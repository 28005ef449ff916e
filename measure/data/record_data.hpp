#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/time_axis.hpp"
#include "measure/formats/number_table.hpp"

namespace secular {

/// One record as its file gives it, before its time stamps are checked.
struct RecordData {
  std::string file;
  RowPlace place;
  std::vector<double> stamps_s;
  std::vector<std::vector<double>> channels;  ///< by Campaign::channels, each as long as stamps_s
  std::size_t total = 0;  ///< samples in the file: more than those here where only the first were asked for
  bool partial = false;   ///< the file has more
  bool csv = false;       ///< whose length is estimated where `partial`
  std::optional<double> last_stamp_s{};  ///< of a CSV read in part, where its end is not damaged
};

/// Rows of a record as its own file has them, times first: without those that it lost, and NaN where a channel
/// holds no number. What was put in for them was not measured.
std::vector<std::vector<double>> measured_columns(const Record& record, std::size_t first, std::size_t count);

/// Reads the variables that the campaign's channels (and "t") name in the record's file; `entry.variables` renames
/// them; the first `limit` samples. Samples in memory (RecordEntry::held) are all given. Throws InputError as
/// read_record does, for everything but time.
RecordData read_record_data(const Campaign& campaign, const RecordEntry& entry, MissingNumbers missing,
                            std::size_t limit = all_values);

}  // namespace secular
