#pragma once

#include <cstdint>
#include <map>
#include <string_view>

#include "measure/formats/hdf5_bytes.hpp"
#include "measure/formats/hdf5_tree.hpp"

namespace secular {

/// A fractal heap (HDF5 file format specification 3.0, III.G): where a group with many members keeps its links.
/// Objects of up to a few KiB stand in direct blocks, which a table of doubling rows (indirect blocks) places in
/// one space of offsets; longer ones stand on their own.
class Hdf5Heap {
 public:
  /// Reads the header. Throws Hdf5Damage.
  Hdf5Heap(const Hdf5Bytes& file, std::uint64_t address);

  /// Blocks run through filters are not read: then there are no objects.
  bool filtered() const { return filtered_; }

  /// The object with this identifier (as the records of an index have it). All objects together have at most the
  /// bytes of the file: Hdf5Damage else.
  Hdf5Record object(Hdf5Cursor identifier);

 private:
  Hdf5Record managed(std::uint64_t offset, std::uint64_t size) const;
  Hdf5Record inside(std::uint64_t block, std::uint64_t begin, std::uint64_t block_size, std::uint64_t offset,
                    std::uint64_t size) const;
  std::uint64_t check_block(std::string_view signature, std::uint64_t block, std::uint64_t begin) const;
  Hdf5Record huge(std::uint64_t number);

  const Hdf5Bytes& file_;
  std::uint64_t address_;
  bool filtered_ = false, check_sums_ = false;
  std::uint64_t identifier_size_ = 0, offset_size_ = 0, length_size_ = 0;
  std::uint64_t width_ = 0, first_size_ = 0, largest_direct_ = 0, root_ = 0, root_rows_ = 0;
  std::uint64_t huge_tree_ = hdf5_nowhere, bytes_left_ = 0;
  std::map<std::uint64_t, Hdf5Record> huge_;
};

}  // namespace secular
