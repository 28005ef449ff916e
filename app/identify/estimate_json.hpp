#pragma once

#include <string>

#include "app/shared/identification.hpp"

namespace secular::app {

/// The text of estimate.json, schema 1.
std::string estimate_json(const Identification& identification);

}  // namespace secular::app
