#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "blind/sealed_campaign.hpp"

namespace secular::blind {

/// The model file of a campaign: what it knows, in the words of the contract's section 1.
std::string model_text(const Specimen& specimen, std::uint64_t nominal_seed);

/// Makes `folder` with model.toml, campaign/ and, where the campaign has numbers, parameters.json: whole or not at
/// all. The caller holds the lock of its parent.
void write_sealed(const SealedCampaign& sealed, std::uint64_t seed, const std::filesystem::path& folder);

/// Where a campaign keeps its dwell `index`: "records/0001.csv".
std::string dwell_file(std::size_t index);

/// A dwell that was not in a campaign's programme.
struct FurtherDwell {
  std::size_t like = 0;    ///< dwell of the programme whose motion it begins with
  double level = 1;        ///< times that dwell's excitation
  double frequency = 0;    ///< rad/s
  std::size_t length = 1;  ///< times as many ensembles as that dwell
};

/// A copy of `campaign` in `target` (which must not exist) with one dwell more, recorded on the structure as it
/// really is, after all others.
void write_extended_campaign(const SealedCampaign& sealed, std::uint64_t seed, const FurtherDwell& further,
                             const std::filesystem::path& campaign, const std::filesystem::path& target);

/// What the campaign really is, for labels.json.
nlohmann::ordered_json label_of(const SealedCampaign& sealed);

/// With its parents. Throws InputError where it cannot be made.
void make_folder(const std::filesystem::path& folder);

/// Writes a file as a whole: a temporary one beside it, then a rename. Throws InputError.
void write_text(const std::filesystem::path& path, const std::string& text);
/// The whole file. Throws InputError.
std::string read_text(const std::filesystem::path& path);

}  // namespace secular::blind
