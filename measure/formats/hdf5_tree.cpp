#include "measure/formats/hdf5_tree.hpp"

#include <algorithm>
#include <bit>

namespace secular {
namespace {

constexpr std::uint64_t deepest_index = 16;
constexpr std::uint64_t node_overhead = 10;  // signature, version, kind, check sum
constexpr std::uint64_t tree_header_size = 38;

std::uint64_t record_size(Hdf5TreeKind kind) {
  switch (kind) {
    case Hdf5TreeKind::links_by_name:
      return 4 + 7;
    case Hdf5TreeKind::attributes_by_name:
      return 8 + 1 + 4 + 4;
    case Hdf5TreeKind::huge_objects:
      break;
  }
  return 8 + 8 + 8;
}

// Bytes that a number up to `largest` takes in a node.
std::uint64_t bytes_for(std::uint64_t largest) {
  return (static_cast<std::uint64_t>(std::bit_width(std::max<std::uint64_t>(largest, 1))) + 7) / 8;
}

class Tree {
 public:
  Tree(const Hdf5Bytes& file, std::uint64_t address, Hdf5TreeKind kind) : file_(file), bytes_left_(file.size()) {
    Hdf5Cursor header(file.at(address, tree_header_size), address);
    if (header.take(4) != "BTHD" || header.number(1) != 0) header.fail("the index of a group is missing");
    kind_ = header.number(1);
    node_size_ = header.number(4);
    record_size_ = header.number(2);
    const std::uint64_t depth = header.number(2);
    header.skip(2);  // when nodes are split and merged
    const std::uint64_t root = header.number(8), root_records = header.number(2), total = header.number(8);
    if (kind_ != static_cast<std::uint64_t>(kind) || record_size_ != record_size(kind))
      header.fail("the index of a group has records of another kind");
    if (depth > deepest_index) header.fail("the index of a group is too deep");
    if (node_size_ < node_overhead + record_size_) header.fail("the index of a group has impossible nodes");
    measure(depth, address);
    if (root != hdf5_nowhere && total > 0) read_node(root, root_records, depth);
    if (records.size() != total) throw Hdf5Damage{"the index of a group has other records than it says", address};
  }

  std::vector<Hdf5Record> records;

 private:
  // How wide the pointers of each level are follows from how many records its nodes can have: of a pointer's two
  // counts, the first (the child's own records) has the width of a leaf's, the second (all below) the child's.
  void measure(std::uint64_t depth, std::uint64_t address) {
    std::uint64_t all_records = (node_size_ - node_overhead) / record_size_;
    count_width_ = bytes_for(all_records);
    all_width_ = {0};
    for (std::uint64_t level = 1; level <= depth; ++level) {
      const std::uint64_t pointer = pointer_size(level);
      if (node_size_ < node_overhead + pointer + record_size_)
        throw Hdf5Damage{"the index of a group has impossible nodes", address};
      const std::uint64_t own = (node_size_ - node_overhead - pointer) / (record_size_ + pointer);
      // More than a file can hold needs no more digits than that.
      all_records = all_records > (std::uint64_t{1} << 56) / (own + 1) ? std::uint64_t{1} << 56
                                                                       : (own + 1) * all_records + own;
      all_width_.push_back(bytes_for(all_records));
    }
  }

  std::uint64_t pointer_size(std::uint64_t level) const { return 8 + count_width_ + all_width_[level - 1]; }

  void read_node(std::uint64_t address, std::uint64_t count, std::uint64_t level) {
    // Nodes that share their bytes would make much out of a small file.
    if (node_size_ > bytes_left_) throw Hdf5Damage{"the index of a group goes round in circles", address};
    bytes_left_ -= node_size_;
    Hdf5Cursor node(file_.at(address, node_size_), address);
    if (node.take(4) != (level > 0 ? "BTIN" : "BTLF") || node.number(1) != 0 || node.number(1) != kind_)
      node.fail("the index of a group is damaged");
    const std::uint64_t pointers = level > 0 ? (count + 1) * pointer_size(level) : 0;
    if (count * record_size_ + pointers + node_overhead > node_size_)
      node.fail("a node of a group's index has more records than room");
    if (level == 0) {
      for (std::uint64_t i = 0; i < count; ++i) take_record(node);
      return;
    }
    Hdf5Cursor children(file_.at(node.address() + count * record_size_, pointers),
                        node.address() + count * record_size_);
    for (std::uint64_t i = 0; i <= count; ++i) {
      const std::uint64_t child = children.number(8), child_count = children.number(count_width_);
      children.skip(all_width_[level - 1]);
      read_node(child, child_count, level - 1);
      if (i < count) take_record(node);
    }
  }

  void take_record(Hdf5Cursor& node) {
    const std::uint64_t address = node.address();
    records.push_back({node.take(record_size_), address});
  }

  const Hdf5Bytes& file_;
  std::uint64_t bytes_left_;
  std::uint64_t kind_ = 0, node_size_ = 0, record_size_ = 0, count_width_ = 0;
  std::vector<std::uint64_t> all_width_;  // by level; leaves have none below
};

}  // namespace

std::vector<Hdf5Record> hdf5_tree_records(const Hdf5Bytes& file, std::uint64_t address, Hdf5TreeKind kind) {
  return Tree(file, address, kind).records;
}

}  // namespace secular
