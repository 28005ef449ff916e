#pragma once

#include <string>
#include <vector>

namespace secular {

/// A TOML basic string.
std::string toml_string(const std::string& text);

/// A TOML float, which needs a point or an exponent to stay one; reading restores its bits.
std::string toml_number(double value);

/// An array of strings.
std::string toml_list(const std::vector<std::string>& names);

}  // namespace secular
