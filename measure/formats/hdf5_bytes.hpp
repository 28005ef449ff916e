#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "measure/formats/stored_numbers.hpp"

namespace secular {

/// A fault of an HDF5 file's structure; becomes an InputError where the file is known.
struct Hdf5Damage {
  std::string what;
  std::uint64_t at = 0;  ///< address in the file
};

/// Bytes of the sum that ends every structure of the newer kind.
inline constexpr std::uint64_t hdf5_check_sum_size = 4;

/// Levels of a B-tree of the older kind: more than a file of any size needs.
inline constexpr int hdf5_deepest_tree = 16;

/// The address that says "nowhere".
inline constexpr std::uint64_t hdf5_nowhere = std::numeric_limits<std::uint64_t>::max();

/// A whole HDF5 file: nothing outside of it can be reached. Addresses count from the base (behind a user block).
class Hdf5Bytes {
 public:
  Hdf5Bytes(std::string_view file, std::uint64_t base) : file_(file.substr(base)), base_(base) {}

  std::uint64_t size() const { return file_.size(); }

  std::string_view at(std::uint64_t address, std::uint64_t count) const {
    if (address > file_.size() || count > file_.size() - address)
      throw Hdf5Damage{"something is said to stand behind the end of the file", base_ + address};
    return file_.substr(address, count);
  }

 private:
  std::string_view file_;
  std::uint64_t base_;
};

/// Takes numbers off a stretch of an HDF5 file, all of them little-endian.
class Hdf5Cursor {
 public:
  Hdf5Cursor(std::string_view bytes, std::uint64_t address) : bytes_(bytes), address_(address) {}

  std::uint64_t left() const { return bytes_.size() - next_; }
  std::uint64_t address() const { return address_ + next_; }

  std::string_view take(std::uint64_t count) {
    if (count > left()) fail("something is longer than the space it stands in");
    const std::string_view taken = bytes_.substr(next_, count);
    next_ += count;
    return taken;
  }
  void skip(std::uint64_t count) { take(count); }
  std::uint64_t number(std::uint64_t size) { return unsigned_at(take(size), 0, size, ByteOrder::little); }
  [[noreturn]] void fail(const std::string& what) const { throw Hdf5Damage{what, address()}; }

 private:
  std::string_view bytes_;
  std::uint64_t address_, next_ = 0;
};

}  // namespace secular
