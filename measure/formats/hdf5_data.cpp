#include "measure/formats/hdf5_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "measure/formats/hdf5_chunks.hpp"

namespace secular {
namespace {

constexpr std::uint64_t most_elements = std::uint64_t{1} << 40;
enum FilterId : std::uint64_t { deflate_filter = 1, shuffle_filter = 2, fletcher_filter = 3 };

std::string inflated(std::string_view stored, std::uint64_t limit, std::uint64_t address) {
  std::string output(limit, '\0');
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw Hdf5Damage{"zlib does not start", address};
  const std::unique_ptr<z_stream, int (*)(z_stream*)> ended(&stream, inflateEnd);
  // zlib reads the input only; chunks are smaller than 4 GiB by their format
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(stored.data()));
  stream.avail_in = static_cast<uInt>(stored.size());
  stream.next_out = reinterpret_cast<Bytef*>(output.data());
  stream.avail_out = static_cast<uInt>(output.size());
  if (inflate(&stream, Z_FINISH) != Z_STREAM_END) throw Hdf5Damage{"a compressed chunk does not inflate", address};
  output.resize(stream.total_out);
  return output;
}

// Shuffled: all first bytes of the elements, then all second ones, ...
std::string unshuffled(const std::string& bytes, std::uint64_t size) {
  const std::uint64_t count = bytes.size() / size;
  std::string output = bytes;
  for (std::uint64_t i = 0; i < count; ++i)
    for (std::uint64_t k = 0; k < size; ++k) output[i * size + k] = bytes[k * count + i];
  return output;
}

std::string decoded(const Hdf5Chunk& chunk, const Hdf5Object& data_set, std::uint64_t size) {
  std::string bytes(chunk.stored);
  for (std::size_t f = data_set.filters.size(); f-- > 0;) {
    if (f < 32 && (chunk.filter_mask >> f & 1) != 0) continue;
    if (data_set.filters[f] == fletcher_filter) {
      if (bytes.size() < hdf5_check_sum_size) throw Hdf5Damage{"a chunk has no check sum", chunk.address};
      bytes.resize(bytes.size() - hdf5_check_sum_size);
    } else if (data_set.filters[f] == deflate_filter) {
      if (size / hdf5_deflate_limit > bytes.size())
        throw Hdf5Damage{"a compressed chunk is too short for its shape", chunk.address};
      bytes = inflated(bytes, size + hdf5_check_sum_size, chunk.address);
    } else {
      bytes = unshuffled(bytes, data_set.type->size);
    }
  }
  if (bytes.size() != size) throw Hdf5Damage{"a chunk has another size than its shape", chunk.address};
  return bytes;
}

/// How far apart neighbours along each dimension are, in elements.
std::vector<std::uint64_t> strides(const std::vector<std::uint64_t>& shape) {
  std::vector<std::uint64_t> strides(shape.size(), 1);
  for (std::size_t d = shape.size(); d-- > 1;) strides[d - 1] = strides[d] * shape[d];
  return strides;
}

bool readable_filters(const Hdf5Object& data_set, std::string& fault) {
  for (const std::uint64_t filter : data_set.filters)
    if (filter < deflate_filter || filter > fletcher_filter) {
      fault = "is compressed in a way that is not read (filter " + std::to_string(filter) + ")";
      return false;
    }
  return true;
}

// True for a chunk that holds some of the lines.
bool is_of(const Hdf5Lines& lines, const Hdf5Chunk& chunk, const std::vector<std::uint64_t>& chunk_shape) {
  for (std::size_t d = 0; d < chunk_shape.size(); ++d)
    if (d != lines.along && d != lines.across && chunk.begin[d] != 0) return false;
  return true;
}

// Hands the bytes of the lines' elements to put(line, index, bytes), each line in order.
template <class Put>
void visit_chunks(const Hdf5Bytes& file, const Hdf5Object& data_set, const Hdf5Lines& lines, std::string& fault,
                  std::uint64_t limit, const Put& put) {
  const std::vector<std::uint64_t>& shape = *data_set.shape;
  const std::vector<std::uint64_t>& chunk_shape = data_set.layout.chunk;
  if (chunk_shape.size() != shape.size() || shape.empty())
    throw Hdf5Damage{"the chunks have another rank than their data set", data_set.layout.address};
  if (!readable_filters(data_set, fault)) return;
  const std::uint64_t size = data_set.type->size, elements = hdf5_count(chunk_shape);
  if (elements == 0 || elements > std::numeric_limits<std::uint32_t>::max() / size)
    throw Hdf5Damage{"a chunk has an impossible shape", data_set.layout.address};
  const std::vector<std::uint64_t> stride = strides(chunk_shape);
  const std::uint64_t count = std::min(shape[lines.along], limit);
  std::vector<Hdf5Chunk> chunks = hdf5_chunks(file, data_set);
  std::sort(chunks.begin(), chunks.end(),
            [&](const Hdf5Chunk& a, const Hdf5Chunk& b) { return a.begin[lines.along] < b.begin[lines.along]; });
  for (const Hdf5Chunk& chunk : chunks) {
    const std::uint64_t begin = chunk.begin[lines.along], first = chunk.begin[lines.across];
    if (begin >= count) break;
    if (!is_of(lines, chunk, chunk_shape)) continue;
    std::string bytes;
    for (std::size_t line = 0; line < lines.places.size(); ++line) {
      const bool single = lines.along == lines.across;
      const std::uint64_t place = lines.places[line];
      if (!single && (place < first || place - first >= chunk_shape[lines.across])) continue;
      if (bytes.empty()) bytes = decoded(chunk, data_set, elements * size);
      const std::uint64_t start = single ? 0 : (place - first) * stride[lines.across];
      const std::uint64_t end = std::min(chunk_shape[lines.along], count - begin);
      for (std::uint64_t i = 0; i < end; ++i)
        put(line, begin + i, std::string_view(bytes).substr((start + i * stride[lines.along]) * size, size));
    }
  }
}

template <class Put>
void visit_elements(const Hdf5Bytes& file, const Hdf5Object& data_set, const Hdf5Lines& lines, std::string& fault,
                    std::uint64_t limit, const Put& put) {
  const Hdf5Layout& layout = data_set.layout;
  if (!data_set.filters_known || layout.storage == Hdf5Storage::other) {
    fault = "is stored in a form that is not read (save it for an earlier version of HDF5)";
    return;
  }
  if (layout.storage == Hdf5Storage::chunked) return visit_chunks(file, data_set, lines, fault, limit, put);
  const std::vector<std::uint64_t>& shape = *data_set.shape;
  const std::uint64_t count = hdf5_count(shape), size = data_set.type->size;
  if (layout.storage == Hdf5Storage::contiguous && layout.address == hdf5_nowhere) return;
  const std::string_view bytes =
      layout.storage == Hdf5Storage::compact ? layout.compact : file.at(layout.address, layout.size);
  if (count > bytes.size() / size)
    throw Hdf5Damage{"a data set has fewer bytes than its shape needs", layout.address};
  const std::vector<std::uint64_t> stride = strides(shape);
  for (std::size_t line = 0; line < lines.places.size(); ++line) {
    const std::uint64_t length = shape.empty() ? 1 : shape[lines.along];
    const std::uint64_t start = lines.along == lines.across ? 0 : lines.places[line] * stride[lines.across];
    for (std::uint64_t i = 0; i < std::min(length, limit); ++i)
      put(line, i, bytes.substr((start + (i == 0 ? 0 : i * stride[lines.along])) * size, size));
  }
}

/// Numbers of a line as they come; what is left out between them becomes NaN.
struct GrowingLine {
  std::vector<double> numbers;
  std::uint64_t left_out = 0;

  // False if more is left out than there is: no line of measurements, and no end to what it would take.
  bool put(std::uint64_t index, double number) {
    if (index < numbers.size()) throw Hdf5Damage{"chunks lie upon each other", index};
    const std::uint64_t gap = index - numbers.size();
    left_out += gap;
    if (gap > 0 && left_out > numbers.size()) return false;
    numbers.resize(index, std::numeric_limits<double>::quiet_NaN());
    numbers.push_back(number);
    return true;
  }
};

}  // namespace

std::uint64_t hdf5_count(const std::vector<std::uint64_t>& shape) {
  std::uint64_t count = 1;
  for (const std::uint64_t length : shape) {
    if (length != 0 && count > most_elements / length) throw Hdf5Damage{"a shape is out of all proportion", 0};
    count *= length;
  }
  return count;
}

Hdf5Lines hdf5_only_line(const std::vector<std::uint64_t>& shape) {
  const auto found = std::find_if(shape.begin(), shape.end(), [](std::uint64_t n) { return n > 1; });
  const auto along = found == shape.end() ? 0 : static_cast<std::size_t>(found - shape.begin());
  return {along, along};
}

std::vector<std::vector<double>> hdf5_numbers(const Hdf5Bytes& file, const Hdf5Object& data_set,
                                              const Hdf5Lines& lines, std::string& fault, std::uint64_t limit) {
  std::vector<GrowingLine> growing(lines.places.size());
  visit_elements(file, data_set, lines, fault, limit,
                 [&](std::size_t line, std::uint64_t index, std::string_view bytes) {
                   if (fault.empty() && !growing[line].put(index, hdf5_number(bytes, *data_set.type)))
                     fault = "has more parts that were never written than parts that were";
                 });
  std::vector<std::vector<double>> numbers;
  for (GrowingLine& line : growing) {
    if (fault.empty() && line.numbers.empty() && limit > 0) fault = "was never written";
    numbers.push_back(std::move(line.numbers));
  }
  if (!fault.empty()) numbers.assign(lines.places.size(), {});
  return numbers;
}

std::vector<std::uint64_t> hdf5_references(const Hdf5Bytes& file, const Hdf5Object& data_set, std::string& fault) {
  std::vector<std::uint64_t> addresses;
  visit_elements(file, data_set, hdf5_only_line(*data_set.shape), fault, std::numeric_limits<std::uint64_t>::max(),
                 [&](std::size_t, std::uint64_t, std::string_view bytes) {
                   addresses.push_back(unsigned_at(bytes, 0, 8, ByteOrder::little));
                 });
  return addresses;
}

}  // namespace secular
