#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "measure/formats/hdf5_bytes.hpp"

namespace secular {

/// What the records of a version 2 B-tree are.
enum class Hdf5TreeKind : std::uint64_t {
  huge_objects = 1,        ///< of a fractal heap: address, length, number
  attributes_by_name = 8,  ///< of an object: place in its heap of attributes, flags, order, hash
  links_by_name = 5,       ///< of a group: hash of the name, place in the group's heap
};

struct Hdf5Record {
  std::string_view bytes;
  std::uint64_t address = 0;
};

/// All records of the version 2 B-tree at this address, in the tree's order (HDF5 file format specification 3.0,
/// III.A.2). Nodes that lie upon each other or lead in circles, and numbers of records that do not agree, are
/// damage: Hdf5Damage.
std::vector<Hdf5Record> hdf5_tree_records(const Hdf5Bytes& file, std::uint64_t address, Hdf5TreeKind kind);

}  // namespace secular
