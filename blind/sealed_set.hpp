#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "blind/sealed_campaign.hpp"

namespace secular::blind {

using Progress = std::function<void(std::size_t done, std::size_t total)>;

/// Makes FOLDER/case_0001/ ... and seals their labels: labels.json and the hash of its bytes in labels.sha256. The
/// same options give the same bytes for any number of threads. Campaigns that are complete are kept. Throws
/// InputError where the folder holds another set.
void generate_set(const std::filesystem::path& folder, const SetOptions& options, const Progress& progress);

/// The labels of a set. Throws InputError where they are not the ones that were sealed.
nlohmann::json read_labels(const std::filesystem::path& folder);

/// What a set is made with, as set.json says it, and back. Throws InputError, which names `folder`, where it is
/// none.
nlohmann::ordered_json heading(const SetOptions& options);
SetOptions options_of_heading(const nlohmann::json& heading, const std::filesystem::path& folder);

/// What a sealed set was made with; its labels stay closed. Throws InputError where the folder holds none.
SetOptions options_of(const std::filesystem::path& folder);

/// FOLDER/case_0001
std::filesystem::path sealed_folder(const std::filesystem::path& folder, std::size_t number);

/// Calls `work` for 0 .. count - 1 on several threads; the first exception is thrown again here.
void in_parallel(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace secular::blind
