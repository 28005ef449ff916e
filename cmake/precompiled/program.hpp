#pragma once

// What most sources of the program include, parsed once. No source relies on this file: each includes what it uses.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cmake/precompiled/dense.hpp"
