#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "blind/measured_sets.hpp"
#include "blind/run_set.hpp"

namespace secular::blind {

/// What the program made of a measured set.
struct MeasuredResult {
  enum class Outcome { diagnosed, refused, failed };
  Outcome outcome = Outcome::failed;
  std::string reason;                        ///< what it said where there is no diagnosis
  double seconds = 0;                        ///< wall time of both commands
  nlohmann::json diagnosis;                  ///< diagnosis.json; null where there is none
  std::map<std::string, std::string> units;  ///< of the campaign's channels
};

NLOHMANN_JSON_SERIALIZE_ENUM(MeasuredResult::Outcome, {{MeasuredResult::Outcome::failed, "failed"},
                                                       {MeasuredResult::Outcome::refused, "refused"},
                                                       {MeasuredResult::Outcome::diagnosed, "diagnosed"}})

/// The two commands of a set with the folders that they read and write, as lists of arguments: import, diagnose.
struct MeasuredCommands {
  std::vector<std::string> import, diagnose;
};
MeasuredCommands commands_of(const MeasuredSet& set, const std::filesystem::path& models,
                             const std::filesystem::path& data, const std::filesystem::path& place);

struct MeasuredRun {
  std::vector<MeasuredResult> results;  ///< of every set of the list
  std::size_t kept = 0;                 ///< had a result of the same commands before
};

struct MeasuredPlaces {
  std::filesystem::path data, work;
};

/// Imports and diagnoses set after set, each in WORK/NAME. A set that has a result of the same commands there keeps
/// it, a refusal too, unless `again`; one whose time ran out is run again with a longer limit.
MeasuredRun run_measured(const MeasuredList& list, const MeasuredPlaces& places, const RunOptions& options,
                         bool again, const Progress& progress);

}  // namespace secular::blind
