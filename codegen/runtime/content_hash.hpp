#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace secular {

/// 40 hexadecimal digits that name a content: SHA-1 over all parts and their lengths.
std::string content_hash(std::initializer_list<std::string_view> parts);

}  // namespace secular
