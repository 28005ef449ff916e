#include "measure/formats/hdf5_heap.hpp"

#include <algorithm>
#include <bit>

namespace secular {
namespace {

constexpr std::uint64_t heap_header_size = 142;  // without filters and check sum
constexpr int deepest_heap = 64;
enum ObjectKind : std::uint64_t { managed_object = 0, huge_object = 1 };

std::uint64_t log2_of(std::uint64_t power) {
  return static_cast<std::uint64_t>(std::countr_zero(power));
}

}  // namespace

Hdf5Heap::Hdf5Heap(const Hdf5Bytes& file, std::uint64_t address)
    : file_(file), address_(address), bytes_left_(file.size()) {
  Hdf5Cursor header(file.at(address, heap_header_size), address);
  if (header.take(4) != "FRHP" || header.number(1) != 0) header.fail("the heap of a group is missing");
  identifier_size_ = header.number(2);
  filtered_ = header.number(2) != 0;
  check_sums_ = (header.number(1) & 2) != 0;
  const std::uint64_t largest_managed = header.number(4);
  header.skip(8);  // next number of a huge object
  huge_tree_ = header.number(8);
  header.skip(80);  // free space, numbers and sizes of objects
  width_ = header.number(2);
  first_size_ = header.number(8);
  largest_direct_ = header.number(8);
  const std::uint64_t offset_bits = header.number(2);
  header.skip(2);  // rows at the begin
  root_ = header.number(8);
  root_rows_ = header.number(2);
  if (!std::has_single_bit(width_) || !std::has_single_bit(first_size_) || !std::has_single_bit(largest_direct_) ||
      largest_direct_ < first_size_ || offset_bits == 0 || offset_bits > 64 || largest_managed == 0)
    header.fail("the heap of a group has impossible sizes");
  offset_size_ = (offset_bits + 7) / 8;
  length_size_ = std::min((log2_of(largest_direct_) + 7) / 8,
                          (static_cast<std::uint64_t>(std::bit_width(largest_managed)) + 7) / 8);
}

Hdf5Record Hdf5Heap::object(Hdf5Cursor identifier) {
  const std::uint64_t flags = identifier.number(1);
  if (flags >> 6 != 0 || identifier.left() + 1 != identifier_size_)
    identifier.fail("an object of a group's heap has an unknown form");
  Hdf5Record found;
  if ((flags >> 4 & 3) == managed_object) {
    const std::uint64_t offset = identifier.number(offset_size_);
    found = managed(offset, identifier.number(length_size_));
  } else if ((flags >> 4 & 3) == huge_object) {
    found = huge(identifier.number(std::min<std::uint64_t>(identifier.left(), 8)));
  } else {
    identifier.fail("an object of a group's heap is too short for a link");
  }
  // Objects that share their bytes would make much out of a small file.
  if (found.bytes.size() > bytes_left_) identifier.fail("the objects of a group's heap lie upon each other");
  bytes_left_ -= found.bytes.size();
  return found;
}

// Rows 0 and 1 of an indirect block have blocks of the first size, each further row of twice the size; blocks above
// the largest direct size are indirect themselves.
Hdf5Record Hdf5Heap::managed(std::uint64_t offset, std::uint64_t size) const {
  if (root_rows_ == 0) return inside(root_, 0, first_size_, offset, size);
  std::uint64_t block = root_, begin = 0, rows = root_rows_;
  for (int level = 0; level < deepest_heap; ++level) {
    const std::uint64_t entries = check_block("FHIB", block, begin);
    const std::uint64_t in_first_sizes = (offset - begin) / first_size_ / width_;
    const auto row = static_cast<std::uint64_t>(std::bit_width(in_first_sizes));
    if (row >= rows) break;
    // row <= 64 - log2(first_size * width), hence no shift loses bits.
    const std::uint64_t block_size = row == 0 ? first_size_ : first_size_ << (row - 1);
    const std::uint64_t row_begin = begin + (row == 0 ? 0 : block_size * width_);
    const std::uint64_t column = (offset - row_begin) / block_size;
    const std::uint64_t entry = entries + 8 * (row * width_ + column);
    block = Hdf5Cursor(file_.at(entry, 8), entry).number(8);
    begin = row_begin + column * block_size;
    if (block_size <= largest_direct_) return inside(block, begin, block_size, offset, size);
    const std::uint64_t first_row = log2_of(first_size_) + log2_of(width_);
    if (log2_of(block_size) < first_row) break;
    rows = log2_of(block_size) - first_row + 1;
  }
  throw Hdf5Damage{"an object stands outside of its group's heap", address_};
}

Hdf5Record Hdf5Heap::inside(std::uint64_t block, std::uint64_t begin, std::uint64_t block_size,
                            std::uint64_t offset, std::uint64_t size) const {
  const std::uint64_t content = check_block("FHDB", block, begin) + (check_sums_ ? hdf5_check_sum_size : 0);
  const std::uint64_t head = content - block, within = offset - begin;
  if (within < head || within > block_size || size > block_size - within)
    throw Hdf5Damage{"an object stands outside of its block", block};
  return {file_.at(block + within, size), block + within};
}

// Returns where the block goes on behind what is common to both kinds of blocks.
std::uint64_t Hdf5Heap::check_block(std::string_view signature, std::uint64_t block, std::uint64_t begin) const {
  Hdf5Cursor head(file_.at(block, 13 + offset_size_), block);
  if (head.take(4) != signature || head.number(1) != 0 || head.number(8) != address_ ||
      head.number(offset_size_) != begin)
    throw Hdf5Damage{"a block of a group's heap is damaged", block};
  return head.address();
}

Hdf5Record Hdf5Heap::huge(std::uint64_t number) {
  if (huge_.empty() && huge_tree_ != hdf5_nowhere)
    for (const Hdf5Record& record : hdf5_tree_records(file_, huge_tree_, Hdf5TreeKind::huge_objects)) {
      Hdf5Cursor cursor(record.bytes, record.address);
      const std::uint64_t at = cursor.number(8), size = cursor.number(8);
      huge_[cursor.number(8)] = {file_.at(at, size), at};
    }
  const auto found = huge_.find(number);
  if (found == huge_.end()) throw Hdf5Damage{"a long object of a group's heap is missing", address_};
  return found->second;
}

}  // namespace secular
