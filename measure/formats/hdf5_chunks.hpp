#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "measure/formats/hdf5_object.hpp"

namespace secular {

/// The bytes of a chunk as they are stored.
struct Hdf5Chunk {
  std::vector<std::uint64_t> begin;  ///< by dimension
  std::string_view stored;
  std::uint64_t filter_mask = 0;
  std::uint64_t address = 0;
};

/// The chunks of a data set, in the order of the file's index: a version 1 B-tree, and for files of later versions
/// a single chunk, chunks one behind the other, a fixed or an extensible array (HDF5 file format specification 3.0,
/// III.A.1 and VI to VII). Chunks that were never written are not among them. Throws Hdf5Damage.
std::vector<Hdf5Chunk> hdf5_chunks(const Hdf5Bytes& file, const Hdf5Object& data_set);

}  // namespace secular
