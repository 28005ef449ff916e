#pragma once

#include <string>
#include <vector>

#include "estimator/campaign/campaign.hpp"
#include "estimator/campaign/number_table.hpp"
#include "estimator/campaign/time_axis.hpp"

namespace secular {

/// One record as its file gives it, before its time stamps are checked.
struct RecordData {
  std::string file;
  RowPlace place;
  std::vector<double> stamps_s;
  std::vector<std::vector<double>> channels;  ///< by Campaign::channels, each as long as stamps_s
};

/// Reads the variables that the campaign's channels (and "t") name in the record's file; `entry.variables` renames
/// them. Throws InputError as read_record does, for everything but time.
RecordData read_record_data(const Campaign& campaign, const RecordEntry& entry, MissingNumbers missing);

}  // namespace secular
