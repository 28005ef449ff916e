#pragma once

#include <filesystem>
#include <string>

#include "measure/data/inspection.hpp"

namespace secular {

/// The command that imports the file's records, with its variables by name. What nobody can know but who measured
/// stands there in capitals, and the second line says what belongs there. Empty where no variable can be a channel.
std::string proposed_import(const std::filesystem::path& path, const FileInspection& file);

/// The command that imports a file that looks like a table of lines: one with a column of frequencies, or frequency
/// response functions. Else empty. A phase is taken for that of the channel before it, and where none is a force
/// the first channel without a phase for the excitation.
std::string table_import(const std::filesystem::path& path, const FileInspection& file);

}  // namespace secular
