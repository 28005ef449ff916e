#pragma once

#include <string>

namespace secular {

/// What every MAT file of the program begins with.
inline constexpr const char* mat_heading = "MATLAB 5.0 MAT-file, written by secular";

/// The bytes of a MAT file (version 5) with one variable `name`, which is what `json` holds, as MATLAB's jsondecode
/// has it: an object is a struct, a list of numbers a column (null: NaN), a list of such lists of one length a
/// matrix of as many rows, any other list a column of cells; null is empty. A list of objects is a column of
/// structs with the fields of all, empty where one has none. Names become identifiers: other characters are "_", an
/// "x" goes before what is no letter, they end after 63. The same text gives the same bytes. Throws InputError, by
/// `file`, for what is no JSON.
std::string mat_of_json(const std::string& json, const std::string& name, const std::string& file);

}  // namespace secular
