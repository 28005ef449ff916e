#pragma once

#include <string>
#include <vector>

#include "measure/data/hdf5_object.hpp"

namespace secular {

/// No stream of deflate becomes longer by a larger factor when it is inflated.
inline constexpr std::uint64_t hdf5_deflate_limit = 1040;

/// The first numbers (at most `limit`) of a data set that is at most long in one dimension, contiguous or in
/// chunks, compressed (deflate, shuffle) or not. `fault`: why they cannot be read although the file is not damaged.
/// Throws Hdf5Damage. What is allocated is never more than the stored bytes can hold.
std::vector<double> hdf5_numbers(const Hdf5Bytes& file, const Hdf5Object& data_set, std::string& fault,
                                 std::uint64_t limit);

/// The same for addresses of objects.
std::vector<std::uint64_t> hdf5_references(const Hdf5Bytes& file, const Hdf5Object& data_set, std::string& fault);

/// Product of a shape; throws Hdf5Damage if it is out of all proportion.
std::uint64_t hdf5_count(const std::vector<std::uint64_t>& shape);

}  // namespace secular
