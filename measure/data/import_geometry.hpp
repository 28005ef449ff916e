#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "measure/data/geometry.hpp"
#include "measure/data/import_channels.hpp"

namespace secular {

/// The nodes and trace lines of a universal file as points and lines, and the responses whose files say at which
/// node they measure as its sensors. `named`: the file that --geometry names, which must be a universal file with
/// nodes; empty: the first file that is imported, where it is one and says where a channel of it measures. Throws
/// InputError. What is left out is said in `warnings`.
std::optional<Geometry> import_geometry(const std::filesystem::path& named, const std::filesystem::path& first_file,
                                        const std::vector<DescribedChannel>& channels, const Variables& variables,
                                        std::vector<std::string>& warnings);

}  // namespace secular
