#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"

namespace secular {

/// Warnings for a reader: those that say of several records the same, but for numbers, are one with a count.
std::vector<std::string> folded(const std::vector<std::string>& warnings, const Campaign& campaign);

/// What to say where more than half of `given` records (indices into the campaign) are left out: one line with the
/// most common reason. `used`: records that a result rests on, whatever is said of them.
std::optional<std::string> mostly_left_out(const std::vector<std::string>& warnings, const Campaign& campaign,
                                           const std::set<std::size_t>& given, const std::set<std::size_t>& used);

}  // namespace secular
