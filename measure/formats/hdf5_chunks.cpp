#include "measure/formats/hdf5_chunks.hpp"

#include <algorithm>
#include <bit>
#include <optional>

#include "measure/formats/hdf5_data.hpp"

namespace secular {
namespace {

/// Takes chunks as they are found.
class ChunkList {
 public:
  explicit ChunkList(const Hdf5Bytes& file) : file_(file) {}

  // Chunks that share their bytes would make much out of a small file.
  void add(Hdf5Chunk chunk, std::uint64_t size) {
    chunk.stored = file_.at(chunk.address, size);
    stored_ += size;
    if (stored_ > file_.size()) throw Hdf5Damage{"chunks lie upon each other", chunk.address};
    chunks.push_back(std::move(chunk));
  }

  std::vector<Hdf5Chunk> chunks;

 private:
  const Hdf5Bytes& file_;
  std::uint64_t stored_ = 0;
};

class ChunkTree {
 public:
  ChunkTree(const Hdf5Bytes& file, const Hdf5Object& data_set, ChunkList& list)
      : file_(file), list_(list), rank_(data_set.shape->size()), nodes_left_(file.size() / 24) {
    read_node(data_set.layout.address, hdf5_deepest_tree);
  }

 private:
  void read_node(std::uint64_t address, int levels) {
    Hdf5Cursor node(file_.at(address, 24), address);
    if (nodes_left_-- == 0 || levels == 0) node.fail("the list of chunks goes round in circles");
    if (node.take(4) != "TREE" || node.number(1) != 1) node.fail("the list of chunks is damaged");
    const std::uint64_t level = node.number(1), children = node.number(2);
    const std::uint64_t entry_size = 8 + 8 * (rank_ + 1) + 8;
    Hdf5Cursor entries(file_.at(address + 24, entry_size * children), address + 24);
    for (std::uint64_t i = 0; i < children; ++i) {
      Hdf5Chunk chunk;
      const std::uint64_t size = entries.number(4);
      chunk.filter_mask = entries.number(4);
      for (std::uint64_t d = 0; d < rank_; ++d) chunk.begin.push_back(entries.number(8));
      entries.skip(8);  // place within an element
      chunk.address = entries.number(8);
      if (level > 0)
        read_node(chunk.address, levels - 1);
      else
        list_.add(std::move(chunk), size);
    }
  }

  const Hdf5Bytes& file_;
  ChunkList& list_;
  std::uint64_t rank_;
  std::uint64_t nodes_left_;
};

/// What both kinds of arrays of chunks have in common: entries of an address each, with filters also of size and
/// filter mask.
class ChunkArray {
 public:
  ChunkArray(const Hdf5Bytes& file, std::uint64_t address) : file_(file), address_(address) {}
  virtual ~ChunkArray() = default;

  // Where the entry stands; none if that part of the array was never written.
  virtual std::optional<std::uint64_t> place(std::uint64_t index) const = 0;

  // The entry as a chunk, with the size of its bytes; none if it was never written.
  std::optional<std::pair<Hdf5Chunk, std::uint64_t>> entry(std::uint64_t index, std::uint64_t plain_size) const {
    const std::optional<std::uint64_t> at = place(index);
    if (!at) return std::nullopt;
    Hdf5Cursor cursor(file_.at(*at, entry_size_), *at);
    Hdf5Chunk chunk;
    chunk.address = cursor.number(8);
    if (chunk.address == hdf5_nowhere) return std::nullopt;
    if (!filtered_) return std::pair{chunk, plain_size};
    const std::uint64_t size = cursor.number(entry_size_ - 12);
    chunk.filter_mask = cursor.number(4);
    return std::pair{chunk, size};
  }

 protected:
  void read_kind(Hdf5Cursor& header, std::string_view signature) {
    if (header.take(4) != signature || header.number(1) != 0) header.fail("the list of chunks is missing");
    filtered_ = header.number(1) == 1;
    entry_size_ = header.number(1);
    const bool right = filtered_ ? entry_size_ > 12 && entry_size_ <= 20 : entry_size_ == 8;
    if (!right) header.fail("the list of chunks has impossible entries");
  }

  // The place behind what every block of an array begins with: signature, version, kind, address of the header.
  std::uint64_t begin_of(std::uint64_t block, std::string_view signature) const {
    Hdf5Cursor cursor(file_.at(block, 14), block);
    if (cursor.take(4) != signature || cursor.number(1) != 0 || cursor.number(1) != (filtered_ ? 1 : 0) ||
        cursor.number(8) != address_)
      throw Hdf5Damage{"the list of chunks is damaged", block};
    return cursor.address();
  }

  std::uint64_t number_at(std::uint64_t at, std::uint64_t size) const {
    return Hdf5Cursor(file_.at(at, size), at).number(size);
  }

  // Bits count from the highest of every byte.
  bool bit(std::uint64_t from, std::uint64_t index) const {
    return (number_at(from + index / 8, 1) & 0x80u >> index % 8) != 0;
  }

  // Entry of a block whose entries come in pages with a check sum each.
  std::uint64_t in_page(std::uint64_t first_page, std::uint64_t index, std::uint64_t page) const {
    return first_page + index / page * (page * entry_size_ + hdf5_check_sum_size) + index % page * entry_size_;
  }

  const Hdf5Bytes& file_;
  std::uint64_t address_, entry_size_ = 8;
  bool filtered_ = false;
};

class FixedArray : public ChunkArray {
 public:
  FixedArray(const Hdf5Bytes& file, std::uint64_t address) : ChunkArray(file, address) {
    Hdf5Cursor header(file.at(address, 28), address);
    read_kind(header, "FAHD");
    const std::uint64_t page_bits = header.number(1);
    count_ = header.number(8);
    const std::uint64_t block = header.number(8);
    if (page_bits > 32 || count_ > file.size()) header.fail("the list of chunks has impossible sizes");
    page_ = std::uint64_t{1} << page_bits;
    if (block == hdf5_nowhere) {
      count_ = 0;
      return;
    }
    entries_ = begin_of(block, "FADB");
  }

  std::optional<std::uint64_t> place(std::uint64_t index) const override {
    if (index >= count_) return std::nullopt;
    if (count_ <= page_) return entries_ + index * entry_size_;
    if (!bit(entries_, index / page_)) return std::nullopt;
    const std::uint64_t pages = (count_ + page_ - 1) / page_;
    return in_page(entries_ + (pages + 7) / 8 + hdf5_check_sum_size, index, page_);
  }

 private:
  std::uint64_t count_ = 0, page_ = 1, entries_ = 0;
};

// The index block holds the first entries, then the addresses of data blocks, then those of super blocks, which
// hold addresses of data blocks. Super block u has 2^(u/2) data blocks of 2^((u+1)/2) times the least number of
// entries; the data blocks of the first ones stand in the index block itself.
class ExtensibleArray : public ChunkArray {
 public:
  ExtensibleArray(const Hdf5Bytes& file, std::uint64_t address) : ChunkArray(file, address) {
    Hdf5Cursor header(file.at(address, 68), address);
    read_kind(header, "EAHD");
    const std::uint64_t bits = header.number(1);
    in_index_ = header.number(1);
    least_ = header.number(1);
    const std::uint64_t pointers = header.number(1), page_bits = header.number(1);
    header.skip(48);  // numbers and sizes of blocks and entries
    const std::uint64_t index = header.number(8);
    if (bits > 64 || bits == 0 || page_bits > 32 || !std::has_single_bit(least_) || !std::has_single_bit(pointers))
      header.fail("the list of chunks has impossible sizes");
    offset_size_ = (bits + 7) / 8;
    page_ = std::uint64_t{1} << page_bits;
    direct_supers_ = 2 * static_cast<std::uint64_t>(std::countr_zero(pointers));
    direct_blocks_ = 2 * (pointers - 1);
    supers_ = bits + 1 - std::min(bits, static_cast<std::uint64_t>(std::countr_zero(least_)));
    if (index != hdf5_nowhere) index_ = begin_of(index, "EAIB");
  }

  std::optional<std::uint64_t> place(std::uint64_t index) const override {
    if (!index_) return std::nullopt;
    if (index < in_index_) return *index_ + index * entry_size_;
    index -= in_index_;
    const std::uint64_t super = static_cast<std::uint64_t>(std::bit_width(index / least_ + 1)) - 1;
    if (super >= supers_) return std::nullopt;
    const std::uint64_t before = ((std::uint64_t{1} << super) - 1) * least_;
    const std::uint64_t blocks = std::uint64_t{1} << super / 2,
                        size = (std::uint64_t{1} << (super + 1) / 2) * least_;
    const std::uint64_t block = (index - before) / size, element = (index - before) % size;
    const std::uint64_t pages = size > page_ ? size / page_ : 0;
    const std::uint64_t addresses = *index_ + in_index_ * entry_size_;
    // As the library counts, blocks in the index block begin behind all those before them of their own size.
    std::uint64_t data = hdf5_nowhere, begin = before + block * size;
    if (super < direct_supers_) {
      if (pages > 0) throw Hdf5Damage{"the list of chunks has impossible sizes", address_};
      // Of the super blocks before: 1 + 1 + 2 + 2 + 4 + ... data blocks.
      const std::uint64_t first = 2 * (blocks - 1) + (super % 2 == 1 ? blocks : 0);
      data = number_at(addresses + 8 * (first + block), 8);
      begin += first * size;
    } else {
      const std::uint64_t at = number_at(addresses + 8 * (direct_blocks_ + super - direct_supers_), 8);
      if (at == hdf5_nowhere) return std::nullopt;
      const std::uint64_t bits = behind_offset(begin_of(at, "EASB"), before);
      if (pages > 0 && !bit(bits, block * pages + element / page_)) return std::nullopt;
      data = number_at(bits + blocks * ((pages + 7) / 8) + 8 * block, 8);
    }
    if (data == hdf5_nowhere) return std::nullopt;
    const std::uint64_t entries = behind_offset(begin_of(data, "EADB"), begin);
    return pages > 0 ? in_page(entries + hdf5_check_sum_size, element, page_) : entries + element * entry_size_;
  }

 private:
  // Blocks say which entry they begin with: none stands for two parts of the array.
  std::uint64_t behind_offset(std::uint64_t at, std::uint64_t expected) const {
    if (number_at(at, offset_size_) != expected)
      throw Hdf5Damage{"a part of the list of chunks stands at the wrong place", at};
    return at + offset_size_;
  }

  std::uint64_t in_index_ = 0, least_ = 1, offset_size_ = 0, page_ = 1;
  std::uint64_t direct_supers_ = 0, direct_blocks_ = 0, supers_ = 0;
  std::optional<std::uint64_t> index_;
};

/// The chunks that a shape is cut into, one after the other as a list of them counts: row by row, by the numbers of
/// chunks that the shape may grow to; the dimension without limit, of which a list has but one, counts first.
class ChunkGrid {
 public:
  explicit ChunkGrid(const Hdf5Object& data_set) : chunk_(data_set.layout.chunk), at_(chunk_.size(), 0) {
    const std::vector<std::uint64_t>& shape = *data_set.shape;
    std::vector<std::uint64_t> most;
    std::uint64_t all = 1;
    for (std::size_t d = 0; d < chunk_.size(); ++d) {
      const auto chunks = [&](std::uint64_t length) {
        return length / chunk_[d] + (length % chunk_[d] != 0 ? 1 : 0);
      };
      here_.push_back(chunks(shape[d]));
      const bool may_grow = d < data_set.limits.size();
      const bool endless = may_grow && data_set.limits[d] == hdf5_nowhere;
      most.push_back(endless ? 0 : chunks(may_grow ? data_set.limits[d] : shape[d]));
      if (here_[d] != 0 && all > most_chunks / here_[d])
        throw Hdf5Damage{"a shape has more chunks than are read", 0};
      all *= here_[d];
    }
    end_ = all == 0;
    std::vector<std::size_t> order;
    for (std::size_t d = 0; d < most.size(); ++d) order.insert(most[d] == 0 ? order.begin() : order.end(), d);
    stride_.resize(most.size());
    std::uint64_t stride = 1;
    for (std::size_t i = order.size(); i-- > 0;) {
      stride_[order[i]] = stride;
      stride *= std::max<std::uint64_t>(1, most[order[i]]);
    }
  }

  bool at_end() const { return end_; }
  std::uint64_t index() const {
    std::uint64_t sum = 0;
    for (std::size_t d = 0; d < at_.size(); ++d) sum += at_[d] * stride_[d];
    return sum;
  }
  std::vector<std::uint64_t> begin() const {
    std::vector<std::uint64_t> begin;
    for (std::size_t d = 0; d < at_.size(); ++d) begin.push_back(at_[d] * chunk_[d]);
    return begin;
  }
  void next() {
    for (std::size_t d = at_.size(); d-- > 0;) {
      if (++at_[d] < here_[d]) return;
      at_[d] = 0;
    }
    end_ = true;
  }

 private:
  /// A guard: each is looked up, written or not.
  static constexpr std::uint64_t most_chunks = std::uint64_t{1} << 24;

  const std::vector<std::uint64_t>& chunk_;
  std::vector<std::uint64_t> at_, here_, stride_;
  bool end_ = false;
};

void take_all(const ChunkArray& array, const Hdf5Object& data_set, std::uint64_t plain_size, ChunkList& list) {
  for (ChunkGrid grid(data_set); !grid.at_end(); grid.next()) {
    auto found = array.entry(grid.index(), plain_size);
    if (!found) continue;
    found->first.begin = grid.begin();
    list.add(std::move(found->first), found->second);
  }
}

}  // namespace

std::vector<Hdf5Chunk> hdf5_chunks(const Hdf5Bytes& file, const Hdf5Object& data_set) {
  const Hdf5Layout& layout = data_set.layout;
  const std::uint64_t size = hdf5_count(layout.chunk) * data_set.type->size;
  ChunkList list(file);
  if (layout.address == hdf5_nowhere) return {};
  const std::vector<std::uint64_t> origin(layout.chunk.size(), 0);
  switch (layout.index) {
    case Hdf5ChunkIndex::tree:
      ChunkTree(file, data_set, list);
      break;
    case Hdf5ChunkIndex::single:
      list.add({origin, {}, layout.filter_mask, layout.address}, layout.size > 0 ? layout.size : size);
      break;
    case Hdf5ChunkIndex::contiguous:
      for (ChunkGrid grid(data_set); !grid.at_end(); grid.next())
        list.add({grid.begin(), {}, 0, layout.address + grid.index() * size}, size);
      break;
    case Hdf5ChunkIndex::fixed_array:
      take_all(FixedArray(file, layout.address), data_set, size, list);
      break;
    case Hdf5ChunkIndex::extensible_array:
      take_all(ExtensibleArray(file, layout.address), data_set, size, list);
      break;
  }
  return std::move(list.chunks);
}

}  // namespace secular
