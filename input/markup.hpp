#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace secular {

/// Text made safe for the content and the quoted attributes of XML and HTML: & < > " ' become character references,
/// bytes that are not UTF-8 and characters that XML forbids become U+FFFD; tabs and line breaks stay.
std::string escape_markup(std::string_view text);

/// The same on one line: tabs and line breaks become spaces.
std::string escape_markup_line(std::string_view text);

/// Number of code points of UTF-8 text; a byte that is not UTF-8 counts one.
std::size_t code_points(std::string_view text);

}  // namespace secular
