#pragma once

#include <string>
#include <vector>

#include "measure/formats/hdf5_object.hpp"

namespace secular {

/// No stream of deflate becomes longer by a larger factor when it is inflated.
inline constexpr std::uint64_t hdf5_deflate_limit = 1040;

/// Which elements of a data set: those along one dimension, at places of another one; first ones of all others.
struct Hdf5Lines {
  std::size_t along = 0, across = 0;
  std::vector<std::uint64_t> places = {0};
};

/// The only line of a data set that is at most long in one dimension.
Hdf5Lines hdf5_only_line(const std::vector<std::uint64_t>& shape);

/// The first numbers (at most `limit`) of these lines, contiguous or in chunks, compressed (deflate, shuffle) or
/// not. A line ends where nothing more was written; NaN fills what was left out before. `fault`: why they cannot be
/// read although the file is not damaged. Throws Hdf5Damage. What is allocated is never more than twice what the
/// stored bytes can hold.
std::vector<std::vector<double>> hdf5_numbers(const Hdf5Bytes& file, const Hdf5Object& data_set,
                                              const Hdf5Lines& lines, std::string& fault, std::uint64_t limit);

/// The same for addresses of objects.
std::vector<std::uint64_t> hdf5_references(const Hdf5Bytes& file, const Hdf5Object& data_set, std::string& fault);

/// Product of a shape; throws Hdf5Damage if it is out of all proportion.
std::uint64_t hdf5_count(const std::vector<std::uint64_t>& shape);

}  // namespace secular
