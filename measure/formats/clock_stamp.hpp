#pragma once

#include <optional>
#include <string_view>

namespace secular {

/// Seconds of a time of day, "hh:mm:ss" with a fraction or without: since midnight, or with a date in front of it
/// ("2024-05-01", "2024/05/01", "01.05.2024", then T or a blank) since the begin of 1970, with days in front of it
/// ("0 days 00:00:00.5", as pandas writes durations) since their begin; behind it Z or an offset
/// from universal time ("+02:00"). Nothing for any other text. The order of month and day of "05/01/2024" is not
/// known.
std::optional<double> clock_stamp(std::string_view text);

}  // namespace secular
