#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace secular {

/// A node of a universal file (data sets 15, 781, 2411), in the file's unit of length. Its coordinates are taken as
/// those of the structure: local coordinate systems are not.
struct UffNode {
  long long label = 0;
  std::array<double, 3> at{};
};

struct UffGeometry {
  std::vector<UffNode> nodes;                       ///< every label once, in file order; of two the last one
  std::vector<std::vector<long long>> trace_lines;  ///< data set 82: labels along each stroke, two or more
};

/// The nodes and trace lines of a universal file; other data sets are skipped. Throws InputError with the line for
/// what is not as the format says.
UffGeometry read_uff_geometry(const std::filesystem::path& path);

}  // namespace secular
