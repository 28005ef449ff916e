#pragma once

namespace secular {

/// What to do about a file whose content contradicts itself or ends too early.
inline constexpr const char* whole_again = "the file is damaged or cut short: copy or export it again";

}  // namespace secular
