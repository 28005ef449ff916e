#pragma once

#include <string>

#include "measure/signal/band_pass.hpp"

namespace secular::app {

/// LOW:HIGH in Hz, as --band takes it. Throws InputError.
Band parse_band(const std::string& text);

}  // namespace secular::app
