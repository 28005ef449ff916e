#pragma once

#include <string>
#include <string_view>

namespace secular {

/// What keeps a name from being a channel's (and thereby a CSV column's), or empty.
std::string channel_name_fault(std::string_view name);

}  // namespace secular
