#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "blind/measured_run.hpp"
#include "blind/measured_sets.hpp"

namespace secular::blind {

/// How the page came about, for it to say.
struct MeasuredPageHead {
  std::string command;                     ///< that made it
  std::filesystem::path list, data, work;  ///< as they were given
};

/// measured.json: commands, what the program said and which aims are met.
nlohmann::ordered_json measured_json(const MeasuredPageHead& head, const MeasuredList& list,
                                     const std::vector<MeasuredResult>& results);

/// measured.md, made from measured.json alone.
std::string measured_markdown(const nlohmann::ordered_json& page);

/// Both files in a folder. Throws InputError where they cannot be written.
void write_measured(const nlohmann::ordered_json& page, const std::filesystem::path& folder);

}  // namespace secular::blind
