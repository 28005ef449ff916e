#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/toml_table.hpp"
#include "measure/data/campaign.hpp"

namespace secular {

/// Samples of one record as they were measured: channels[c][i] at start_s + i / Campaign::sample_rate_hz, in
/// channel units. What was not measured is NaN.
struct MeasuredSamples {
  double start_s = 0;
  std::vector<std::vector<double>> channels;  ///< by Campaign::channels
};

/// A campaign whose samples are in memory. `text`: its campaign.toml, in which the files of records are names
/// alone; `records`: by [[record]]. It is judged and mended as files are (read_record), and a CampaignWriter makes
/// a folder of it that reads the same. Throws InputError, by the campaign's name and the line of `text`.
Campaign held_campaign(const std::string& text, std::vector<MeasuredSamples> records);

/// Writes a campaign with its records to a folder, see CampaignWriter. `replace`: as there.
/// Throws InputError.
void write_campaign(const Campaign& campaign, const std::filesystem::path& folder, bool replace);

/// What the text of a campaign.toml says. `in_memory`: files are names alone.
Campaign described_campaign(const TomlTable& root, const std::filesystem::path& folder, bool in_memory);

}  // namespace secular
