#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "blind/sealed_case.hpp"

namespace secular::blind {

/// The model file of a case: what it knows, in the words of the contract's section 1.
std::string model_text(const Specimen& specimen, std::uint64_t nominal_seed);

/// Makes `folder` with model.toml, campaign/ and, where the case has numbers, parameters.json: whole or not at all.
void write_case(const SealedCase& sealed, std::uint64_t seed, const std::filesystem::path& folder);

/// What the case really is, for labels.json.
nlohmann::ordered_json label_of(const SealedCase& sealed);

/// Writes a file as a whole: a temporary one beside it, then a rename. Throws InputError.
void write_text(const std::filesystem::path& path, const std::string& text);
/// The whole file. Throws InputError.
std::string read_text(const std::filesystem::path& path);

}  // namespace secular::blind
