#pragma once

#include <filesystem>
#include <vector>

#include "measure/formats/number_table.hpp"
#include "measure/formats/uff_function.hpp"

namespace secular {

/// The data sets 58 and 58b of a universal file, in file order, with the first `limit` values of each; other data
/// sets are skipped. Accepts CRLF, trailing
/// blanks, Fortran's D exponents and numbers that are not aligned to their columns. Throws InputError with the line
/// (behind binary data: the byte) for everything that is not as the format says and for a file that is cut short.
std::vector<UffFunction> read_uff(const std::filesystem::path& path, std::size_t limit = all_values);

/// True if the file begins with the delimiter of a universal file: -1 in columns 5 and 6, nothing else.
bool looks_like_uff(const std::filesystem::path& path);

}  // namespace secular
