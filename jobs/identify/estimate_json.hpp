#pragma once

#include <string>

#include "jobs/identify/identification.hpp"

namespace secular {

/// The text of estimate.json, schema 1.
std::string estimate_json(const Identification& identification);

}  // namespace secular
