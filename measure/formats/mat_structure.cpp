#include "measure/formats/mat_structure.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "measure/formats/mapped_file.hpp"

namespace secular {
namespace {

using Bytes = std::span<const unsigned char>;

constexpr const char* right_file = "the file is damaged or cut short: copy or save it again";
constexpr std::size_t mat_header_size = 128;
constexpr std::size_t tag_size = 8;
constexpr std::size_t padding_limit = 8;  // that may follow a compressed variable
constexpr int deepest_nesting = 32;
constexpr std::uint64_t most_mat_elements = std::uint64_t{1} << 40;

// Data types (mi...) and array classes (mx...) of the format, as far as their layout differs.
enum DataType : std::uint32_t { mi_int32 = 5, mi_uint32 = 6, mi_matrix = 14, mi_compressed = 15 };
enum ArrayClass : std::uint32_t {
  mx_cell = 1,
  mx_struct = 2,
  mx_object = 3,
  mx_first_number = 6,
  mx_last_number = 15
};
constexpr std::uint32_t complex_flag = 0x0800;

// Bytes of one number of a data type, 0 for a type that holds none: miINT8 = 1, miUINT8, miINT16, miUINT16,
// miINT32, miUINT32, miSINGLE, -, miDOUBLE = 9, -, -, miINT64 = 12, miUINT64.
std::size_t number_size(std::uint32_t type) {
  static constexpr std::size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8};
  return type < std::size(sizes) ? sizes[type] : 0;
}

/// A fault of the structure; becomes an InputError where the file and the place are known.
struct Damage {
  std::string what;
};

struct Element {
  std::uint32_t type = 0;
  Bytes content;
};

/// Takes elements off a stretch of bytes.
class ElementReader {
 public:
  ElementReader(Bytes bytes, bool swapped) : rest_(bytes), swapped_(swapped) {}

  bool at_end() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }
  bool swapped() const { return swapped_; }

  /// The content is filled up to a multiple of eight bytes, except where it is compressed.
  Element next() {
    if (rest_.size() < 8) throw Damage{"an element's tag is cut off"};
    const std::uint32_t first = word(rest_, 0);
    const std::uint32_t small_size = first >> 16;
    Element element;
    if (small_size != 0) {
      if (small_size > 4) throw Damage{"a small element is larger than four bytes"};
      element = {first & 0xffff, rest_.subspan(4, small_size)};
      rest_ = rest_.subspan(8);
      return element;
    }
    const std::size_t size = word(rest_, 4);
    rest_ = rest_.subspan(8);
    if (size > rest_.size()) throw Damage{"an element is longer than what is left"};
    element = {first, rest_.first(size)};
    const std::size_t padding = first == mi_compressed ? 0 : (8 - size % 8) % 8;
    rest_ = rest_.subspan(std::min(size + padding, rest_.size()));
    return element;
  }

  std::uint32_t word(Bytes bytes, std::size_t at) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value |= static_cast<std::uint32_t>(bytes[at + i]) << (8 * (swapped_ ? 3 - i : i));
    return value;
  }

 private:
  Bytes rest_;
  bool swapped_;
};

// The variable in a compressed element; never more than its own tag says, whatever the stream would inflate to.
std::vector<unsigned char> inflated(Bytes compressed, bool swapped) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw Damage{"zlib does not start"};
  const std::unique_ptr<z_stream, int (*)(z_stream*)> ended(&stream, inflateEnd);
  std::vector<unsigned char> output(tag_size);
  stream.next_in = const_cast<unsigned char*>(compressed.data());  // zlib reads it only
  stream.avail_in = static_cast<uInt>(compressed.size());
  std::size_t limit = 0;
  for (int status = Z_OK; status != Z_STREAM_END;) {
    if (stream.total_out == output.size()) {
      if (limit == 0) limit = tag_size + ElementReader(output, swapped).word(output, 4) + padding_limit;
      if (output.size() > limit) throw Damage{"a compressed element is longer than its variable"};
      output.resize(std::min(2 * output.size() + 4 * compressed.size(), limit + 1));
    }
    stream.next_out = output.data() + stream.total_out;
    stream.avail_out = static_cast<uInt>(
        std::min<std::size_t>(output.size() - stream.total_out, std::numeric_limits<uInt>::max()));
    status = inflate(&stream, Z_NO_FLUSH);
    if (status != Z_OK && status != Z_STREAM_END) throw Damage{"a compressed element does not inflate"};
  }
  output.resize(stream.total_out);
  return output;
}

/// Where the type of an array's dimensions stands that are not of the type that the format asks for.
using UnsignedDimensions = std::vector<const unsigned char*>;

void check_matrix(Bytes content, bool swapped, int depth, UnsignedDimensions& found);

void check_matrices(ElementReader& reader, std::uint64_t count, int depth, UnsignedDimensions& found) {
  if (count > reader.left() / 8) throw Damage{"a cell or struct has fewer members than its dimensions say"};
  for (std::uint64_t i = 0; i < count; ++i) {
    const Element member = reader.next();
    if (member.type != mi_matrix) throw Damage{"a member of a cell or struct is no array"};
    check_matrix(member.content, reader.swapped(), depth + 1, found);
  }
}

void check_numbers(ElementReader& reader, std::uint64_t count) {
  const Element data = reader.next();
  const std::size_t size = number_size(data.type);
  if (size == 0 || data.content.size() != count * size)
    throw Damage{"an array holds another count of numbers than its dimensions say"};
}

void check_matrix(Bytes content, bool swapped, int depth, UnsignedDimensions& found) {
  if (content.empty()) return;  // an empty field
  if (depth > deepest_nesting) throw Damage{"structs are nested too deep"};
  ElementReader reader(content, swapped);
  const Element flags = reader.next();
  if (number_size(flags.type) != 4 || flags.content.size() != 8) throw Damage{"an array has no flags"};
  const std::uint32_t flag_word = reader.word(flags.content, 0);
  const std::uint32_t array_class = flag_word & 0xff;
  if (array_class > mx_last_number || array_class == 0) return;  // a class of later versions, which is skipped
  const Element dimensions = reader.next();
  const std::size_t rank = dimensions.content.size() / 4;
  if (number_size(dimensions.type) != 4 || dimensions.content.size() % 4 != 0 || rank < 2 || rank > 64)
    throw Damage{"an array has no dimensions"};
  if (dimensions.type == mi_uint32) found.push_back(dimensions.content.data() - (swapped ? 5 : 8));
  std::uint64_t count = 1;
  for (std::size_t i = 0; i < rank; ++i) {
    const std::uint32_t length = reader.word(dimensions.content, 4 * i);
    if (length != 0 && count > most_mat_elements / length)
      throw Damage{"an array's dimensions are out of all proportion"};
    count *= length;
  }
  if (number_size(reader.next().type) != 1) throw Damage{"an array has no name"};
  if (array_class == mx_cell) {
    check_matrices(reader, count, depth, found);
  } else if (array_class == mx_struct || array_class == mx_object) {
    if (array_class == mx_object) reader.next();  // class name
    const Element width = reader.next();
    const Element names = reader.next();
    if (number_size(width.type) != 4 || width.content.size() != 4 || number_size(names.type) != 1)
      throw Damage{"a struct has no field names"};
    const std::size_t name_width = reader.word(width.content, 0);
    if (name_width == 0 ? !names.content.empty() : names.content.size() % name_width != 0)
      throw Damage{"a struct's field names do not fit their length"};
    const std::uint64_t fields = name_width == 0 ? 0 : names.content.size() / name_width;
    for (std::uint64_t f = 1; f <= fields; ++f)
      if (names.content[f * name_width - 1] != 0) throw Damage{"a struct's field name has no end"};
    if (fields > 0 && count > reader.left() / fields)
      throw Damage{"a struct has fewer members than its dimensions say"};
    check_matrices(reader, count * fields, depth, found);
  } else if (array_class >= mx_first_number) {
    check_numbers(reader, count);
    if ((flag_word & complex_flag) != 0) check_numbers(reader, count);
  } else {  // text and sparse matrices, which nobody reads: their elements have to fit into them all the same
    while (reader.left() >= tag_size) reader.next();
  }
}

/// A variable as it stands in the file, or what its compressed form inflates to.
struct TopLevel {
  std::vector<unsigned char> inflated;  // with its tag; empty if it is not compressed
  UnsignedDimensions found;
};

TopLevel check_top_level(const Element& element, bool swapped) {
  TopLevel top;
  if (element.type == mi_matrix) {
    check_matrix(element.content, swapped, 0, top.found);
    return top;
  }
  if (element.type != mi_compressed) throw Damage{"something stands where a variable should be"};
  top.inflated = inflated(element.content, swapped);
  ElementReader reader(top.inflated, swapped);
  const Element matrix = reader.next();
  if (matrix.type != mi_matrix) throw Damage{"a compressed element holds no variable"};
  check_matrix(matrix.content, swapped, 0, top.found);
  return top;
}

bool is_swapped(Bytes bytes, const std::string& file) {
  const bool little = bytes[126] == 'I' && bytes[127] == 'M';
  const bool big = bytes[126] == 'M' && bytes[127] == 'I';
  if (!little && !big) throw InputError(file, "byte 127", "does not say its byte order", right_file);
  return big;
}

// Appends bytes with the types of dimensions as the format asks for.
void append_repaired(std::vector<unsigned char>& copy, Bytes bytes, const UnsignedDimensions& found) {
  const std::size_t begin = copy.size();
  copy.insert(copy.end(), bytes.begin(), bytes.end());
  for (const unsigned char* type : found) copy[begin + static_cast<std::size_t>(type - bytes.data())] = mi_int32;
}

}  // namespace

std::vector<unsigned char> check_mat_structure(const std::filesystem::path& path) {
  const MappedFile mapped(path);
  const Bytes bytes(reinterpret_cast<const unsigned char*>(mapped.bytes().data()), mapped.bytes().size());
  if (bytes.size() < mat_header_size) throw InputError(path.string(), "", "ends inside of its header", right_file);
  const bool swapped = is_swapped(bytes, path.string());
  std::vector<unsigned char> repaired;
  ElementReader reader(bytes.subspan(mat_header_size), swapped);
  while (!reader.at_end()) {
    const std::size_t at = bytes.size() - reader.left();
    try {
      const TopLevel top = check_top_level(reader.next(), swapped);
      const std::size_t end = bytes.size() - reader.left();
      if (!top.found.empty() && repaired.empty()) append_repaired(repaired, bytes.first(at), {});
      if (!repaired.empty())
        append_repaired(repaired, top.inflated.empty() ? bytes.subspan(at, end - at) : Bytes(top.inflated),
                        top.found);
    } catch (const Damage& damage) {
      throw InputError(path.string(), fmt::format("variable at byte {}", at + 1), damage.what, right_file);
    }
  }
  return repaired;
}

}  // namespace secular
