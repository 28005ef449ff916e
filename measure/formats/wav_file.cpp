#include "measure/formats/wav_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "input/input_error.hpp"
#include "measure/formats/damaged_file.hpp"
#include "measure/formats/file_bytes.hpp"
#include "measure/formats/mapped_file.hpp"
#include "measure/formats/stored_numbers.hpp"

namespace secular {
namespace {

constexpr std::size_t riff_head = 12, chunk_head = 8, shortest_format = 16, extensible_format = 40;
enum Coding : std::uint64_t { pcm = 1, floating_point = 3, extensible = 0xFFFE };

struct WavFormat {
  std::uint64_t coding = 0;
  std::size_t channels = 0, bytes_a_sample = 0;
  double sample_rate_hz = 0;
};

std::uint64_t number(std::string_view bytes, std::size_t at, std::size_t size) {
  return unsigned_at(bytes, at, size, ByteOrder::little);
}

WavFormat read_format(std::string_view content, const std::string& file, const std::string& place) {
  if (content.size() < shortest_format) throw InputError(file, place, "the format is cut off", whole_again);
  WavFormat format;
  format.coding = number(content, 0, 2);
  format.channels = static_cast<std::size_t>(number(content, 2, 2));
  format.sample_rate_hz = static_cast<double>(number(content, 4, 4));
  const std::uint64_t bits = number(content, 14, 2);
  if (format.coding == extensible && content.size() >= extensible_format) format.coding = number(content, 24, 2);
  format.bytes_a_sample = static_cast<std::size_t>(bits / 8);
  const bool readable = (format.coding == pcm && bits % 8 == 0 && bits >= 8 && bits <= 32) ||
                        (format.coding == floating_point && (bits == 32 || bits == 64));
  if (!readable)
    throw InputError(file, place, fmt::format("coding {} with {} bits is not read", format.coding, bits),
                     "PCM of 8, 16, 24 or 32 bits or floating point of 32 or 64 was expected");
  if (format.channels == 0) throw InputError(file, place, "there are no channels", whole_again);
  if (format.sample_rate_hz <= 0) throw InputError(file, place, "the sample rate is zero", whole_again);
  if (number(content, 12, 2) != format.channels * format.bytes_a_sample)
    throw InputError(file, place, "the size of a sample contradicts channels and bits", whole_again);
  return format;
}

struct Wav {
  WavFormat format;
  std::string_view samples;
};

// What stands for a size in a stream, whose end was not known at its beginning.
bool is_never_filled_in(std::uint64_t size) {
  return size == 0 || size == 0xFFFFFFFF;
}

Wav read_chunks(std::string_view bytes, const std::string& file) {
  const bool large = bytes.starts_with("RF64");
  std::optional<WavFormat> format;
  std::optional<std::uint64_t> large_size;
  for (std::size_t at = riff_head; at + chunk_head <= bytes.size();) {
    const std::string_view name = bytes.substr(at, 4);
    const std::string place = fmt::format("byte {}", at + 1);
    std::uint64_t size = number(bytes, at + 4, 4);
    if (large && name == "data" && size == 0xFFFFFFFF && large_size) size = *large_size;
    at += chunk_head;
    if (name == "data" && is_never_filled_in(size) && is_never_filled_in(number(bytes, 4, 4)) && format && !large) {
      const std::size_t frame = format->channels * format->bytes_a_sample;
      size = (bytes.size() - at) / frame * frame;
    }
    if (size > bytes.size() - at)
      throw InputError(file, place, fmt::format("{} bytes are announced, {} follow", size, bytes.size() - at),
                       whole_again);
    const std::string_view content = bytes.substr(at, static_cast<std::size_t>(size));
    if (name == "ds64" && content.size() >= 16) large_size = number(content, 8, 8);
    if (name == "fmt ") format = read_format(content, file, place);
    if (name == "data") {
      if (!format) throw InputError(file, place, "the data stand in front of their format", whole_again);
      if (content.size() % (format->channels * format->bytes_a_sample) != 0)
        throw InputError(file, place, "the data end inside of a sample", whole_again);
      return {*format, content};
    }
    at += std::min(content.size() + content.size() % 2, bytes.size() - at);
  }
  throw InputError(file, "", "has no data", whole_again);
}

double sample(const Wav& wav, std::size_t at) {
  const std::size_t size = wav.format.bytes_a_sample;
  if (wav.format.coding == floating_point) return float_at(wav.samples, at, size, ByteOrder::little);
  if (size == 1) return (static_cast<double>(number(wav.samples, at, 1)) - 128) / 128;
  const auto whole = static_cast<double>(signed_at(wav.samples, at, size, ByteOrder::little));
  return std::ldexp(whole, 1 - static_cast<int>(8 * size));
}

}  // namespace

DataFile read_wav(const std::filesystem::path& path, const std::vector<std::string>& wanted, std::size_t limit) {
  const MappedFile mapped(path);
  if (!looks_like_wav(path))
    throw InputError(path.string(), "byte 1", "is not the begin of a WAV file", "RIFF and WAVE were expected");
  const Wav wav = read_chunks(mapped.bytes(), path.string());
  const WavFormat& format = wav.format;
  const std::size_t count = wav.samples.size() / (format.channels * format.bytes_a_sample);
  const auto is_wanted = [&](const std::string& name) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  };
  DataFile data{path.string(), "WAV", {}, {"sample", 1}};
  const std::string empty = count == 0 ? "is empty" : "";
  data.variables.push_back({"t", {count}, "time", {}, empty});
  const std::size_t taken = std::min(count, limit);
  data.partial = taken < count;
  if (is_wanted("t"))
    for (std::size_t i = 0; i < taken; ++i)
      data.variables.back().values.push_back(static_cast<double>(i) / format.sample_rate_hz);
  const std::string type = fmt::format("{}-bit {}, full scale 1", 8 * format.bytes_a_sample,
                                       format.coding == pcm ? "PCM" : "floating point");
  for (std::size_t c = 0; c < format.channels; ++c) {
    data.variables.push_back({fmt::format("channel {}", c + 1), {count}, type, {}, empty});
    DataVariable& channel = data.variables.back();
    channel.of_full_scale = true;
    if (!is_wanted(channel.name)) continue;
    channel.values.reserve(taken);
    for (std::size_t i = 0; i < taken; ++i)
      channel.values.push_back(sample(wav, (i * format.channels + c) * format.bytes_a_sample));
  }
  return data;
}

bool looks_like_wav(const std::filesystem::path& path) {
  const std::string begin = some_bytes(path, riff_head);
  return begin.size() == riff_head && (begin.starts_with("RIFF") || begin.starts_with("RF64")) &&
         begin.substr(8) == "WAVE";
}

}  // namespace secular
