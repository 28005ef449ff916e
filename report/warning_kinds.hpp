#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace secular::report {

/// Indices of texts by kind, kinds and members in the order of the texts. Of one kind are texts that are the same
/// but for their numbers: runs of digits, with what may stand within or before a number (point, sign, exponent).
std::vector<std::vector<std::size_t>> warning_kinds(const std::vector<std::string>& texts);

}  // namespace secular::report
