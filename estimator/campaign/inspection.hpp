#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "estimator/campaign/campaign.hpp"
#include "estimator/campaign/data_quality.hpp"
#include "estimator/campaign/time_axis.hpp"

namespace secular {

/// What one record of a campaign holds. A record that cannot be used says so in `faults` instead of failing.
struct RecordInspection {
  std::size_t samples = 0;
  std::optional<TimeAxis> axis;          ///< absent where time is faulty
  std::vector<DataFault> faults;         ///< of the record as a whole: time, unreadable
  std::vector<ChannelQuality> channels;  ///< by Campaign::channels; empty where the record is unreadable
};

/// Reads and judges every record of a campaign: [record].
std::vector<RecordInspection> inspect_records(const Campaign& campaign);

struct VariableInspection {
  std::string name;
  std::vector<std::size_t> shape;
  std::string type;
  std::string unit;                       ///< SI, where the file says quantity and unit
  std::string stated_unit;                ///< as the file spells it
  std::string fault;                      ///< why it is no channel
  std::optional<ChannelQuality> quality;  ///< of vectors of numbers
};

/// What a data file holds, before anybody said what it means.
struct FileInspection {
  std::string format;
  std::vector<VariableInspection> variables;
  std::string time;              ///< variable that increases evenly ("t" or "time" in any case), if there is one
  std::optional<TimeAxis> axis;  ///< of it
  std::vector<DataFault> faults;
};

/// Throws InputError as read_data_file does.
FileInspection inspect_file(const std::filesystem::path& path);

}  // namespace secular
