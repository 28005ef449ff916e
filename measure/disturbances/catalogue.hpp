#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measure/disturbances/searched_record.hpp"

namespace secular {

/// One kind of thing that a measured record holds beside the motion.
struct DisturbanceKind {
  std::string_view name;
  std::string_view looked_for;
  std::string_view size;    ///< what the size of a finding is, and its unit
  std::string_view test;    ///< against what noise, by which law
  std::string_view effect;  ///< on results
  /// Adds what it finds; none: found by another stage, which `test` names.
  void (*find)(const SearchedRecord&, std::vector<Disturbance>&) = nullptr;
};

/// All kinds.
std::span<const DisturbanceKind> disturbance_catalogue();

/// What a record holds, by the order of the catalogue. Missing samples are NaN. `values`: of every channel of a
/// record without missing samples, if they are known.
std::vector<Disturbance> find_disturbances(const Campaign& campaign, std::size_t index, const Record& record);
std::vector<Disturbance> find_disturbances(const Campaign& campaign, std::size_t index, const Record& record,
                                           const std::vector<ChannelValues>& values);

}  // namespace secular
