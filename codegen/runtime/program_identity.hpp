#pragma once

#include <string>

namespace secular {

/// Tells builds of this program apart: what one build derived and emitted another may do differently. The linker's
/// build number where there is one, otherwise size and time of the program file.
std::string program_identity();

}  // namespace secular
