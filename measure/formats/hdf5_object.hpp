#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measure/formats/hdf5_bytes.hpp"

namespace secular {

enum class Hdf5Class {
  integer = 0,
  floating_point = 1,
  text = 3,
  compound = 6,
  reference = 7,
  long_text = 9,
  other = 15
};

struct Hdf5Type {
  Hdf5Class kind = Hdf5Class::other;
  std::uint64_t size = 0;
  ByteOrder order = ByteOrder::little;
  bool is_signed = false;
  bool usual = false;  ///< an integer that fills its bytes, an IEEE 754 number, an object's address
};

enum class Hdf5Storage { compact, contiguous, chunked, other };

/// How the chunks of a data set are found.
enum class Hdf5ChunkIndex { tree = 0, single = 1, contiguous = 2, fixed_array = 3, extensible_array = 4 };

struct Hdf5Layout {
  Hdf5Storage storage = Hdf5Storage::other;
  std::string_view compact;          ///< the data themselves
  std::uint64_t address = 0;         ///< of contiguous data, or of the index of chunks
  std::uint64_t size = 0;            ///< bytes of contiguous data, or of a single chunk that went through filters
  std::vector<std::uint64_t> chunk;  ///< shape of a chunk
  Hdf5ChunkIndex index = Hdf5ChunkIndex::tree;
  std::uint64_t filter_mask = 0;  ///< of a single chunk
};

struct Hdf5Link {
  std::string name;
  std::uint64_t address = 0;               ///< of the object
  std::optional<std::uint64_t> created{};  ///< number in order of creation, where the group keeps it
  std::string target{};  ///< of a symbolic link: the path that it leads to, in place of an address
};

struct Hdf5SymbolTable {
  std::uint64_t tree = 0, heap = 0;
};

/// Links outside of the header: a fractal heap and its index by name (a version 2 B-tree).
struct Hdf5DenseLinks {
  std::uint64_t heap = 0, index = 0;
};

/// What the header of an object says: a data set if it has shape and type, else a group.
struct Hdf5Object {
  std::optional<std::vector<std::uint64_t>> shape;
  std::vector<std::uint64_t> limits;  ///< what the shape may grow to, where that is more
  std::optional<Hdf5Type> type;
  Hdf5Layout layout;
  std::vector<std::uint64_t> filters;  ///< 1 deflate, 2 shuffle, 3 Fletcher check sum, ...
  bool filters_known = true;
  std::vector<Hdf5Link> links;  ///< those in the header itself
  std::optional<Hdf5SymbolTable> symbol_table;
  std::optional<Hdf5DenseLinks> dense_links;      ///< as soon as a group has more than some members
  std::map<std::string, std::string> attributes;  ///< texts; empty for attributes of other types
  std::map<std::string, double> numbers;          ///< of attributes that are a single number
};

/// An element that is a usual integer or floating-point number.
double hdf5_number(std::string_view bytes, const Hdf5Type& type);

/// Reads the header at this address (versions 1 and 2). Throws Hdf5Damage.
Hdf5Object read_hdf5_object(const Hdf5Bytes& file, std::uint64_t address);

/// The link that a message or an object of a heap describes; none if it leads out of the file.
std::optional<Hdf5Link> read_hdf5_link(Hdf5Cursor cursor);

/// The members of a group: in order of creation where the group keeps it, else in stored order, which is that of
/// the names except in small groups. `fault`: why they cannot be read although the file is not damaged. Throws
/// Hdf5Damage.
std::vector<Hdf5Link> hdf5_members(const Hdf5Bytes& file, const Hdf5Object& group, std::string& fault);

}  // namespace secular
