#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "measure/data/watched_reader.hpp"
#include "measure/disturbances/disturbance.hpp"

namespace secular {

/// Finds what the records of a campaign hold beside the motion while they are read. The campaign must live as long.
class DisturbanceWatch {
 public:
  explicit DisturbanceWatch(const Campaign& campaign) : campaign_(campaign) {}

  /// For WatchedReader; this must live as long as the reader.
  WatchedReader::Look look();

  /// In all records that were read, in the campaign's order.
  std::vector<Disturbance> found() const;
  std::size_t records() const;

 private:
  const Campaign& campaign_;
  mutable std::mutex mutex_;
  std::map<std::size_t, std::vector<Disturbance>> found_;  // by record
};

/// One line for each kind, the worst first: "foreign_tone: in 12 of 18 records, worst in base of records/0003.csv
/// (4.1 % of its rms): a steady tone ...". `records`: that were looked at.
std::vector<std::string> disturbance_lines(const std::vector<Disturbance>& found, const Campaign& campaign,
                                           std::size_t records);

/// The worst finding of each kind, the worst first.
std::vector<const Disturbance*> worst_of_kinds(const std::vector<Disturbance>& found);

/// Records in which a kind was found.
std::size_t records_with(const std::vector<Disturbance>& found, std::string_view kind);

}  // namespace secular
