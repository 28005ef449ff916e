#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "measure/data/data_quality.hpp"
#include "measure/data/time_axis.hpp"
#include "measure/data/time_span.hpp"

namespace secular {

/// What one record of a campaign holds. A record that cannot be used says so in `faults` instead of failing.
struct RecordInspection {
  std::size_t samples = 0;               ///< in the file; estimated where `estimated`
  std::size_t judged = 0;                ///< the first of them, which axis, faults and channels speak of
  bool estimated = false;                ///< a CSV of which not every line was read, whose end tells no time
  std::optional<TimeAxis> axis;          ///< absent where time is faulty
  std::vector<DataFault> faults;         ///< of the record as a whole: time, unreadable
  std::vector<ChannelQuality> channels;  ///< by Campaign::channels; empty where the record is unreadable
};

/// How much of large data is judged. Records and files up to this size are read whole; beyond it the first samples
/// of every channel are, so that the answer comes at once whatever the size.
struct InspectionLimit {
  std::size_t whole_bytes = std::size_t{64} << 20;   ///< of all files together
  std::size_t values = std::size_t{1} << 20;         ///< read of all channels and records together, about
  std::size_t least_samples = std::size_t{1} << 12;  ///< of a channel
  TimeSpan span{};  ///< of every record; where it is not all of it, everything in it is read
};

/// What else looks at every record that has a time axis; missing samples are NaN.
using RecordLook = std::function<void(std::size_t, const Record&)>;

/// Reads and judges every record of a campaign, one at a time: [record].
std::vector<RecordInspection> inspect_records(const Campaign& campaign, const InspectionLimit& limit = {},
                                              const RecordLook& look = {});

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
  bool partial = false;      ///< qualities, axis and faults are of the first values
  bool estimated = false;    ///< and the lengths of a CSV are estimated
  std::size_t segments = 1;  ///< that the file holds one behind the other; what is inspected is the first
};

/// What else looks at a file that has a time axis: as a campaign of one record, a free decay, whose responses are
/// the variables beside the time, but for forces, which
/// drive: with one it is an impact. Displacements, where the file does not say what they
/// are; missing samples are NaN.
using FileLook = std::function<void(const Campaign&, const Record&)>;

/// Throws InputError as read_data_file does.
FileInspection inspect_file(const std::filesystem::path& path, const InspectionLimit& limit = {},
                            const FileLook& look = {});

}  // namespace secular
