#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/formats/data_file.hpp"

namespace secular {

/// A WAV file as variables: "t" in seconds and "channel 1", ... as fractions of full scale. PCM of 8, 16, 24 and 32
/// bits, floating point of 32 and 64, also in the extensible form and in RF64. What full scale is in a unit, the
/// file does not say. At most `limit` values of each. Throws InputError.
DataFile read_wav(const std::filesystem::path& path, const std::vector<std::string>& wanted,
                  std::size_t limit = all_values);

/// True if the file begins like a WAV file.
bool looks_like_wav(const std::filesystem::path& path);

}  // namespace secular
