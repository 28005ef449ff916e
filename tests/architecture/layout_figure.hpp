#pragma once

#include <string>

#include "folder_rules.hpp"

namespace secular::architecture {

/// The graph as an SVG picture: each folder above those that it includes, an arrow where no longer way says the
/// same. Throws std::logic_error where folders include one another in a circle.
std::string layout_figure(const FolderGraph& graph);

}  // namespace secular::architecture
