#pragma once

#include <string>

namespace secular::architecture {

/// docs/thresholds.md, from the lists of the structs.
std::string thresholds_page();

}  // namespace secular::architecture
