#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace secular::app {

/// Of an option's value: one of these words. Another one is refused with that which may be meant.
CLI::Validator one_of(std::vector<std::string> words);

}  // namespace secular::app
