#pragma once

// What most sources of the program include, parsed once. No source relies on this file: each includes what it uses.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cmake/precompiled/dense.hpp"
