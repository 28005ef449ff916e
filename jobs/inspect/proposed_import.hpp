#pragma once

#include <filesystem>
#include <string>

#include "measure/data/inspection.hpp"

namespace secular {

/// The command that imports the file's records, with its variables by name. What nobody can know but who measured
/// stands there in capitals, and the second line says what belongs there. Empty where no variable can be a channel.
std::string proposed_import(const std::filesystem::path& path, const FileInspection& file);

}  // namespace secular
