#include "measure/data/hdf5_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "measure/data/hdf5_chunks.hpp"

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

// Hands the bytes of every element to `put`, in order; false (and a fault) if they are not all there.
template <class Put>
bool visit_chunks(const Hdf5Bytes& file, const Hdf5Object& data_set, std::string& fault, std::uint64_t limit,
                  const Put& put) {
  const std::vector<std::uint64_t>& shape = *data_set.shape;
  const std::vector<std::uint64_t>& chunk_shape = data_set.layout.chunk;
  if (chunk_shape.size() != shape.size() || shape.empty())
    throw Hdf5Damage{"the chunks have another rank than their data set", data_set.layout.address};
  for (const std::uint64_t filter : data_set.filters)
    if (filter < deflate_filter || filter > fletcher_filter) {
      fault = "is compressed in a way that is not read (filter " + std::to_string(filter) + ")";
      return false;
    }
  const std::size_t dimension = hdf5_long_dimension(shape);
  const std::uint64_t count = std::min(shape[dimension], limit), length = chunk_shape[dimension],
                      size = data_set.type->size;
  const std::uint64_t elements = hdf5_count(chunk_shape);
  if (elements == 0 || elements > std::numeric_limits<std::uint32_t>::max() / size)
    throw Hdf5Damage{"a chunk has an impossible shape", data_set.layout.address};
  std::uint64_t stride = 1;
  for (std::size_t d = dimension + 1; d < chunk_shape.size(); ++d) stride *= chunk_shape[d];
  std::vector<Hdf5Chunk> chunks = hdf5_chunks(file, data_set, fault);
  if (!fault.empty()) return false;
  std::sort(chunks.begin(), chunks.end(), [](const Hdf5Chunk& a, const Hdf5Chunk& b) { return a.begin < b.begin; });
  std::uint64_t next = 0;
  for (const Hdf5Chunk& chunk : chunks) {
    if (next >= count) break;
    if (chunk.begin != next) break;
    const std::string bytes = decoded(chunk, data_set, elements * size);
    for (std::uint64_t i = 0; i < length && next < count; ++i, ++next)
      put(std::string_view(bytes).substr(i * stride * size, size));
  }
  if (next < count) fault = "has parts that were never written";
  return next >= count;
}

template <class Put>
bool visit_elements(const Hdf5Bytes& file, const Hdf5Object& data_set, std::string& fault, std::uint64_t limit,
                    const Put& put) {
  const Hdf5Layout& layout = data_set.layout;
  if (!data_set.filters_known || layout.storage == Hdf5Storage::other) {
    fault = "is stored in a form that is not read (save it for an earlier version of HDF5)";
    return false;
  }
  if (layout.storage == Hdf5Storage::chunked) return visit_chunks(file, data_set, fault, limit, put);
  const std::uint64_t count = hdf5_count(*data_set.shape), size = data_set.type->size;
  if (layout.storage == Hdf5Storage::contiguous && layout.address == hdf5_nowhere) {
    fault = "was never written";
    return false;
  }
  const std::string_view bytes =
      layout.storage == Hdf5Storage::compact ? layout.compact : file.at(layout.address, layout.size);
  if (count > bytes.size() / size)
    throw Hdf5Damage{"a data set has fewer bytes than its shape needs", layout.address};
  for (std::uint64_t i = 0; i < std::min(count, limit); ++i) put(bytes.substr(i * size, size));
  return true;
}

}  // namespace

std::uint64_t hdf5_count(const std::vector<std::uint64_t>& shape) {
  std::uint64_t count = 1;
  for (const std::uint64_t length : shape) {
    if (length != 0 && count > most_elements / length) throw Hdf5Damage{"a shape is out of all proportion", 0};
    count *= length;
  }
  return count;
}

std::vector<double> hdf5_numbers(const Hdf5Bytes& file, const Hdf5Object& data_set, std::string& fault,
                                 std::uint64_t limit) {
  std::vector<double> numbers;
  const bool whole = visit_elements(file, data_set, fault, limit, [&](std::string_view bytes) {
    numbers.push_back(hdf5_number(bytes, *data_set.type));
  });
  if (!whole) numbers.clear();
  return numbers;
}

std::vector<std::uint64_t> hdf5_references(const Hdf5Bytes& file, const Hdf5Object& data_set, std::string& fault) {
  std::vector<std::uint64_t> addresses;
  visit_elements(file, data_set, fault, std::numeric_limits<std::uint64_t>::max(),
                 [&](std::string_view bytes) { addresses.push_back(unsigned_at(bytes, 0, 8, ByteOrder::little)); });
  return addresses;
}

}  // namespace secular
