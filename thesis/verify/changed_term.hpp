#pragma once

#include <string>
#include <utility>

namespace secular::verify {

/// What of a printed formula a corrected one changes: both without what they begin and end with alike, out to whole
/// terms between + - = and brackets. Both empty for equal formulas.
std::pair<std::string, std::string> changed_term(const std::string& printed, const std::string& corrected);

}  // namespace secular::verify
