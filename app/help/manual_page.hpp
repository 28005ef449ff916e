#pragma once

#include <string>

#include "app/help/described_command.hpp"

namespace secular::app {

/// The page of section 1 of the manual, as `man` reads it (roff): `program` and all its commands with their
/// options. `version`: what `--version` prints.
std::string manual_page(const DescribedCommand& program, const std::string& version);

}  // namespace secular::app
