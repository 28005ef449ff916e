#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "measure/data/hdf5_object.hpp"

namespace secular {

/// The bytes of a chunk as they are stored.
struct Hdf5Chunk {
  std::uint64_t begin = 0;  ///< along the long dimension
  std::string_view stored;
  std::uint64_t filter_mask = 0;
  std::uint64_t address = 0;
};

/// The dimension that a data set is long in (the first of more than one; 0 if there is none).
std::size_t hdf5_long_dimension(const std::vector<std::uint64_t>& shape);

/// The chunks of a data set that is long in one dimension, in the order of the file's index: a version 1 B-tree,
/// and for files of later versions a single chunk, chunks one behind the other, a fixed or an extensible array
/// (HDF5 file format specification 3.0, III.A.1 and VI to VII). Chunks that were never written are not among them,
/// and none behind the first of those in an array. `fault`: why they are not read although the file is not damaged.
/// Throws Hdf5Damage.
std::vector<Hdf5Chunk> hdf5_chunks(const Hdf5Bytes& file, const Hdf5Object& data_set, std::string& fault);

}  // namespace secular
