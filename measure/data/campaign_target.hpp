#pragma once

#include <filesystem>
#include <string>

namespace secular {

/// Why a folder that stands must not be replaced by a campaign: it is none, holds other files too, or was not
/// written by a command. Empty: it may be.
std::string fault_of_replaced(const std::filesystem::path& folder);

/// How what is to be written stands to what is read, links followed: "is", "lies inside", "contains"; empty: apart.
std::string overlap(const std::filesystem::path& target, const std::filesystem::path& source);

/// Throws InputError where they are not apart; `what`: "the campaign", "the file".
void check_apart(const std::filesystem::path& target, const std::filesystem::path& source, const std::string& what);

}  // namespace secular
