#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace secular::blind {

/// What would be right of a measured set; every condition that is given must hold.
struct Aim {
  std::vector<std::vector<std::string>> named = {};  ///< of each list one effect is named
  std::vector<std::string> never_named = {};
  std::vector<std::string> verdicts = {};      ///< the verdict is one of these; empty: any
  std::string same_verdict_as = {};            ///< a set whose verdict and first effect are the same; empty: none
  std::optional<double> closed_at_least = {};  ///< share of the gap
  std::vector<std::string> disturbances = {};  ///< kinds that are listed
  bool every_record = false;                   ///< none is left out
};

/// Records that somebody else measured, how they are imported and diagnosed, and what is known of them.
struct MeasuredSet {
  std::string name, title, known;
  std::vector<std::string> files;     ///< in the data folder
  std::vector<std::string> import;    ///< arguments besides the files
  std::filesystem::path model;        ///< as the list names it
  bool model_is_data = false;         ///< in the data folder; else beside the list
  std::vector<std::string> diagnose;  ///< further arguments, --band with them
  std::vector<Aim> aims;              ///< one of them is to be met
};

struct MeasuredList {
  std::filesystem::path folder;  ///< of the file that it was read from
  std::vector<MeasuredSet> sets;
};

/// Reads a list as models/measured/sets.toml describes it. Throws InputError.
MeasuredList read_measured_list(const std::filesystem::path& file);

/// The sets of these names, all of them where none is given. Throws InputError for a name that the list lacks.
MeasuredList only_sets(MeasuredList list, const std::vector<std::string>& names);

/// Throws one InputError that names every file that the list's sets need and `data` lacks.
void require_data(const MeasuredList& list, const std::filesystem::path& data);

}  // namespace secular::blind
