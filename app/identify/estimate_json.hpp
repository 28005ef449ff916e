#pragma once

#include <string>

#include "app/identify/full_equations.hpp"
#include "app/shared/identification.hpp"

namespace secular::app {

/// The text of estimate.json, schema 1.
std::string estimate_json(const Identification& identification);
std::string estimate_json(const FullIdentification& run);

}  // namespace secular::app
