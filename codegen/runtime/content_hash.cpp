#include "codegen/runtime/content_hash.hpp"

#include <fmt/format.h>

#include <boost/uuid/detail/sha1.hpp>

namespace secular {

std::string content_hash(std::initializer_list<std::string_view> parts) {
  boost::uuids::detail::sha1 hash;
  for (const std::string_view part : parts) {
    const std::string length = fmt::format("{}:", part.size());
    hash.process_bytes(length.data(), length.size());
    hash.process_bytes(part.data(), part.size());
  }
  // An array of 5 words or of 20 bytes, depending on Boost's version.
  boost::uuids::detail::sha1::digest_type digest;
  hash.get_digest(digest);
  std::string text;
  for (const auto word : digest) text += fmt::format("{:0{}x}", word, 2 * sizeof word);
  return text;
}

}  // namespace secular
