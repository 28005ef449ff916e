#include "measure/formats/hdf5_object.hpp"

#include <algorithm>
#include <utility>

#include "measure/formats/file_bytes.hpp"
#include "measure/formats/hdf5_heap.hpp"
#include "measure/formats/hdf5_tree.hpp"

namespace secular {
namespace {

constexpr std::uint64_t highest_rank = 32;
constexpr std::uint64_t most_blocks = 1000;  // of one object's header

enum MessageType : std::uint64_t {
  dataspace_message = 0x01,
  link_info_message = 0x02,
  datatype_message = 0x03,
  link_message = 0x06,
  layout_message = 0x08,
  filter_message = 0x0B,
  attribute_message = 0x0C,
  continuation_message = 0x10,
  symbol_table_message = 0x11,
  attribute_info_message = 0x15
};

void read_dataspace(Hdf5Cursor cursor, Hdf5Object& object) {
  const std::uint64_t version = cursor.number(1), rank = cursor.number(1), flags = cursor.number(1);
  if (version != 1 && version != 2) cursor.fail("the version of a shape is not known");
  if (rank > highest_rank) cursor.fail("a shape has too many dimensions");
  const std::uint64_t kind = version == 2 ? cursor.number(1) : 1;
  if (version == 1) cursor.skip(5);
  std::vector<std::uint64_t> shape;
  for (std::uint64_t i = 0; i < rank; ++i) shape.push_back(cursor.number(8));
  object.limits.clear();
  for (std::uint64_t i = 0; (flags & 1) != 0 && i < rank; ++i) object.limits.push_back(cursor.number(8));
  if (kind == 2) shape = {0};  // null
  object.shape = std::move(shape);
}

bool is_ieee(std::uint64_t size, Hdf5Cursor& properties) {
  const std::uint64_t offset = properties.number(2), precision = properties.number(2);
  const std::uint64_t exponent_at = properties.number(1), exponent = properties.number(1);
  const std::uint64_t mantissa_at = properties.number(1), mantissa = properties.number(1);
  const std::uint64_t bias = properties.number(4);
  if (offset != 0 || mantissa_at != 0 || precision != 8 * size || exponent_at != mantissa) return false;
  return (size == 8 && exponent == 11 && mantissa == 52 && bias == 1023) ||
         (size == 4 && exponent == 8 && mantissa == 23 && bias == 127);
}

Hdf5Type read_datatype(Hdf5Cursor cursor) {
  const std::uint64_t class_and_version = cursor.number(1), bits = cursor.number(3);
  Hdf5Type type;
  type.size = cursor.number(4);
  type.order = (bits & 1) != 0 ? ByteOrder::big : ByteOrder::little;
  switch (class_and_version & 0x0F) {
    case 0: {
      type.kind = Hdf5Class::integer;
      type.is_signed = (bits & 8) != 0;
      const std::uint64_t offset = cursor.number(2), precision = cursor.number(2);
      type.usual = offset == 0 && type.size >= 1 && type.size <= 8 && precision == 8 * type.size;
      break;
    }
    case 1:
      type.kind = Hdf5Class::floating_point;
      type.usual = (bits & 0x40) == 0 && is_ieee(type.size, cursor);  // bit 6: VAX
      break;
    case 3:
      type.kind = Hdf5Class::text;
      break;
    case 6:
      type.kind = Hdf5Class::compound;
      break;
    case 9:
      if ((bits & 0x0F) == 1) type.kind = Hdf5Class::long_text;
      break;
    case 7:
      type.kind = Hdf5Class::reference;
      type.usual = (bits & 0x0F) == 0 && type.size == 8;
      break;
    default:
      break;
  }
  return type;
}

// Version 4. A version 2 B-tree (of data sets that may grow in several dimensions) is not read.
void read_later_chunks(Hdf5Cursor& cursor, Hdf5Layout& layout) {
  const std::uint64_t flags = cursor.number(1), rank = cursor.number(1), width = cursor.number(1);
  if (rank < 1 || rank > highest_rank + 1 || width < 1 || width > 8) cursor.fail("a chunk has no shape");
  for (std::uint64_t i = 1; i < rank; ++i) layout.chunk.push_back(cursor.number(width));
  cursor.skip(width);  // size of an element
  const std::uint64_t index = cursor.number(1);
  const bool partial_plain = (flags & 1) != 0;  // chunks at the edge do not go through the filters
  if (index < 1 || index > 4 || partial_plain) return;
  layout.index = static_cast<Hdf5ChunkIndex>(index);
  if (layout.index == Hdf5ChunkIndex::single && (flags & 2) != 0) {
    layout.size = cursor.number(8);
    layout.filter_mask = cursor.number(4);
  }
  if (layout.index == Hdf5ChunkIndex::fixed_array) cursor.skip(1);
  if (layout.index == Hdf5ChunkIndex::extensible_array) cursor.skip(5);
  layout.address = cursor.number(8);
  layout.storage = Hdf5Storage::chunked;
}

Hdf5Layout read_layout(Hdf5Cursor cursor) {
  Hdf5Layout layout;
  const std::uint64_t version = cursor.number(1);
  if (version != 3 && version != 4) return layout;
  const std::uint64_t kind = cursor.number(1);
  if (kind == 0) {
    layout.storage = Hdf5Storage::compact;
    layout.compact = cursor.take(cursor.number(2));
  } else if (kind == 1) {
    layout.storage = Hdf5Storage::contiguous;
    layout.address = cursor.number(8);
    layout.size = cursor.number(8);
  } else if (kind == 2 && version == 3) {
    layout.storage = Hdf5Storage::chunked;
    const std::uint64_t rank = cursor.number(1);
    layout.address = cursor.number(8);
    if (rank < 1 || rank > highest_rank + 1) cursor.fail("a chunk has no shape");
    for (std::uint64_t i = 1; i < rank; ++i) layout.chunk.push_back(cursor.number(4));
  } else if (kind == 2) {
    read_later_chunks(cursor, layout);
  }
  return layout;
}

void read_filters(Hdf5Cursor cursor, Hdf5Object& object) {
  const std::uint64_t version = cursor.number(1), count = cursor.number(1);
  object.filters_known = version == 1 || version == 2;
  if (!object.filters_known) return;
  if (version == 1) cursor.skip(6);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t id = cursor.number(2);
    const std::uint64_t name = version == 1 || id >= 256 ? cursor.number(2) : 0;
    cursor.skip(2);
    const std::uint64_t values = cursor.number(2);
    cursor.skip(version == 1 ? (name + 7) / 8 * 8 : name);
    cursor.skip(4 * values + (version == 1 && values % 2 == 1 ? 4 : 0));
    object.filters.push_back(id);
  }
}

std::string text_until_zero(std::string_view bytes) {
  return as_utf8(bytes.substr(0, bytes.find('\0')));
}

// Elements of a dataspace.
std::uint64_t element_count(Hdf5Cursor cursor) {
  Hdf5Object object;
  read_dataspace(cursor, object);
  std::uint64_t count = 1;
  for (const std::uint64_t length : *object.shape) count *= length == 1 ? 1 : length == 0 ? 0 : 2;  // several
  return count;
}

// A text of any length: its bytes stand in a global heap (III.E of the specification).
std::string long_text(const Hdf5Bytes& file, Hdf5Cursor value) {
  const std::uint64_t length = value.number(4), address = value.number(8), index = value.number(4);
  if (length == 0) return {};
  constexpr std::uint64_t head_size = 16;
  Hdf5Cursor head(file.at(address, head_size), address);
  if (head.take(4) != "GCOL") head.fail("a text stands in no heap");
  head.skip(4);
  const std::uint64_t size = head.number(8);
  if (size < head_size) head.fail("a heap of texts has no room");
  Hdf5Cursor objects(file.at(address + head_size, size - head_size), address + head_size);
  while (objects.left() >= head_size) {
    const std::uint64_t found = objects.number(2);
    objects.skip(6);
    const std::uint64_t bytes = objects.number(8);
    if (found == 0) break;  // the free space at the end
    const std::string_view content = objects.take(bytes);
    if (found == index) return text_until_zero(content.substr(0, length));
    objects.skip(std::min((8 - bytes % 8) % 8, objects.left()));
  }
  head.fail("a text is missing in its heap");
}

void read_attribute(const Hdf5Bytes& file, Hdf5Cursor cursor, Hdf5Object& object) {
  const std::uint64_t version = cursor.number(1), flags = cursor.number(1);
  const std::uint64_t name_size = cursor.number(2), type_size = cursor.number(2), space_size = cursor.number(2);
  if (version == 3) cursor.skip(1);
  const auto padded = [&](std::uint64_t size) { return version == 1 ? (size + 7) / 8 * 8 : size; };
  const std::string name = text_until_zero(cursor.take(padded(name_size)));
  std::string& text = object.attributes[name];
  text.clear();
  const std::uint64_t type_at = cursor.address();
  const Hdf5Cursor type_bytes(cursor.take(padded(type_size)), type_at);
  const std::uint64_t space_at = cursor.address();
  const Hdf5Cursor space_bytes(cursor.take(padded(space_size)), space_at);
  if (version > 1 && flags != 0) return;  // type or shape stand elsewhere
  const Hdf5Type type = read_datatype(type_bytes);
  if (type.kind == Hdf5Class::text) {
    text = text_until_zero(cursor.take(std::min(type.size, cursor.left())));
    return;
  }
  if (element_count(space_bytes) != 1) return;
  if (type.kind == Hdf5Class::long_text) text = long_text(file, cursor);
  const bool number = type.kind == Hdf5Class::integer || type.kind == Hdf5Class::floating_point;
  if (number && type.usual) object.numbers[name] = hdf5_number(cursor.take(type.size), type);
}

void read_link_info(Hdf5Cursor cursor, Hdf5Object& object) {
  cursor.skip(1);
  if ((cursor.number(1) & 1) != 0) cursor.skip(8);
  const std::uint64_t heap = cursor.number(8);
  if (heap != hdf5_nowhere) object.dense_links = Hdf5DenseLinks{heap, cursor.number(8)};
}

// Attributes outside of the header, as soon as an object has more than some.
void read_attribute_info(const Hdf5Bytes& file, Hdf5Cursor cursor, Hdf5Object& object) {
  cursor.skip(1);
  if ((cursor.number(1) & 1) != 0) cursor.skip(2);
  const std::uint64_t heap_address = cursor.number(8);
  if (heap_address == hdf5_nowhere) return;
  const std::uint64_t index = cursor.number(8);
  Hdf5Heap heap(file, heap_address);
  if (heap.filtered()) cursor.fail("the attributes of an object are compressed");
  for (const Hdf5Record& record : hdf5_tree_records(file, index, Hdf5TreeKind::attributes_by_name)) {
    Hdf5Cursor identifier(record.bytes, record.address);
    const Hdf5Record attribute = heap.object({identifier.take(8), record.address});
    read_attribute(file, {attribute.bytes, attribute.address}, object);
  }
}

struct Block {
  std::uint64_t address = 0, size = 0;
};

void read_message(const Hdf5Bytes& file, std::uint64_t type, bool shared, Hdf5Cursor cursor, Hdf5Object& object,
                  std::vector<Block>& blocks) {
  // The contents of a shared message stand elsewhere: its data set has no type, or no shape, that is known.
  if (shared && type != continuation_message) return;
  switch (type) {
    case dataspace_message:
      read_dataspace(cursor, object);
      break;
    case datatype_message:
      object.type = read_datatype(cursor);
      break;
    case layout_message:
      object.layout = read_layout(cursor);
      break;
    case filter_message:
      read_filters(cursor, object);
      break;
    case attribute_message:
      read_attribute(file, cursor, object);
      break;
    case attribute_info_message:
      read_attribute_info(file, cursor, object);
      break;
    case link_message:
      if (std::optional<Hdf5Link> link = read_hdf5_link(cursor)) object.links.push_back(std::move(*link));
      break;
    case link_info_message:
      read_link_info(cursor, object);
      break;
    case symbol_table_message: {
      const std::uint64_t tree = cursor.number(8);
      object.symbol_table = Hdf5SymbolTable{tree, cursor.number(8)};
      break;
    }
    case continuation_message: {
      const std::uint64_t address = cursor.number(8);
      blocks.push_back({address, cursor.number(8)});
      if (blocks.size() > most_blocks) cursor.fail("an object's header has too many parts");
      break;
    }
    default:
      break;
  }
}

void read_first_version(const Hdf5Bytes& file, std::uint64_t address, Hdf5Object& object) {
  Hdf5Cursor prefix(file.at(address, 16), address);
  prefix.skip(2);
  std::uint64_t messages = prefix.number(2);
  prefix.skip(4);
  std::vector<Block> blocks = {{address + 16, prefix.number(4)}};
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block block = blocks[b];
    Hdf5Cursor cursor(file.at(block.address, block.size), block.address);
    for (; cursor.left() >= 8 && messages > 0; --messages) {
      const std::uint64_t type = cursor.number(2), size = cursor.number(2), flags = cursor.number(1);
      cursor.skip(3);
      const std::uint64_t at = cursor.address();
      read_message(file, type, (flags & 2) != 0, {cursor.take(size), at}, object, blocks);
    }
  }
  if (messages != 0) throw Hdf5Damage{"an object's header has fewer parts than it says", address};
}

void read_second_version(const Hdf5Bytes& file, std::uint64_t address, Hdf5Object& object) {
  constexpr std::uint64_t longest_prefix = 34, signature = 4;
  Hdf5Cursor prefix(file.at(address, std::min(longest_prefix, file.size() - address)), address);
  prefix.skip(5);
  const std::uint64_t flags = prefix.number(1);
  if ((flags & 0x20) != 0) prefix.skip(16);  // times
  if ((flags & 0x10) != 0) prefix.skip(4);   // limits of attributes
  const std::uint64_t size = prefix.number(std::uint64_t{1} << (flags & 3));
  std::vector<Block> blocks = {{prefix.address(), size}};
  const std::uint64_t message_head = (flags & 4) != 0 ? 6 : 4;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Block block = blocks[b];
    if (b > 0) {
      if (block.size < signature + hdf5_check_sum_size || file.at(block.address, signature) != "OCHK")
        throw Hdf5Damage{"an object's header does not go on where it should", block.address};
      block = {block.address + signature, block.size - signature - hdf5_check_sum_size};
    }
    Hdf5Cursor cursor(file.at(block.address, block.size), block.address);
    while (cursor.left() >= message_head) {
      const std::uint64_t type = cursor.number(1), message_size = cursor.number(2),
                          message_flags = cursor.number(1);
      cursor.skip(message_head - 4);
      const std::uint64_t at = cursor.address();
      read_message(file, type, (message_flags & 2) != 0, {cursor.take(message_size), at}, object, blocks);
    }
  }
}

}  // namespace

double hdf5_number(std::string_view bytes, const Hdf5Type& type) {
  if (type.kind == Hdf5Class::floating_point) return float_at(bytes, 0, type.size, type.order);
  if (type.is_signed) return static_cast<double>(signed_at(bytes, 0, type.size, type.order));
  return static_cast<double>(unsigned_at(bytes, 0, type.size, type.order));
}

std::optional<Hdf5Link> read_hdf5_link(Hdf5Cursor cursor) {
  Hdf5Link link;
  cursor.skip(1);
  const std::uint64_t flags = cursor.number(1);
  const std::uint64_t kind = (flags & 8) != 0 ? cursor.number(1) : 0;
  if ((flags & 4) != 0) link.created = cursor.number(8);
  if ((flags & 16) != 0) cursor.skip(1);
  const std::uint64_t name_size = cursor.number(std::uint64_t{1} << (flags & 3));
  link.name = as_utf8(cursor.take(name_size));
  constexpr std::uint64_t hard = 0, symbolic = 1;
  if (kind == hard) {
    link.address = cursor.number(8);
  } else if (kind == symbolic) {
    link.target = as_utf8(cursor.take(cursor.number(2)));
  } else {
    return std::nullopt;
  }
  return link;
}

Hdf5Object read_hdf5_object(const Hdf5Bytes& file, std::uint64_t address) {
  Hdf5Object object;
  const std::string_view begin = file.at(address, 5);
  if (begin == std::string_view("OHDR\2", 5))
    read_second_version(file, address, object);
  else if (begin[0] == 1)
    read_first_version(file, address, object);
  else
    throw Hdf5Damage{"no object's header stands where one should", address};
  return object;
}

}  // namespace secular
