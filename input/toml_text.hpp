#pragma once

#include <string>
#include <string_view>

namespace secular {

/// Refuses, with line and column, texts that are no TOML in ways that toml++ 3.3 is not made for: control
/// characters and characters that are not ASCII where a key or a value stands, a table header that does not begin
/// with a name, and keys of so many parts that the tables they make are deeper than the stack. Other mistakes are
/// toml++'s to find. Throws InputError.
void check_toml_text(std::string_view text, const std::string& file);

}  // namespace secular
