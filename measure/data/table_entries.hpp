#pragma once

#include <vector>

#include "input/toml_table.hpp"
#include "measure/data/campaign.hpp"

namespace secular {

/// Keys of a [[record]] of kind `lines`, beside file, kind, group and variables: what its numbers mean.
inline constexpr std::string_view table_keys[] = {"amplitudes",       "phases",         "phase_sign",
                                                  "phase_offset_deg", "per_excitation", "frequency_unit"};

/// A record for each row of the table of lines that `table`, a [[record]] of campaign.toml, names; `entry` is what
/// it says of any record. Throws InputError, also where a row is damaged.
std::vector<RecordEntry> table_entries(const TomlTable& table, const Campaign& campaign, const RecordEntry& entry);

/// What each row is known by: "records/a.csv:12".
std::string row_name(const std::string& table, const std::string& place);

}  // namespace secular
