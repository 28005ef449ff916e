#pragma once

// What most sources of the program include, parsed once; and what CLI11 makes of options, compiled once in
// app/shared/command_line.cpp, as are the classes which CLI/CLI.hpp brings beyond CLI/App.hpp. No source relies on this
// file: each includes what it uses.

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include "cmake/precompiled/dense.hpp"

#define SECULAR_INSTANCE extern template
#include "cmake/precompiled/options.inc"
#undef SECULAR_INSTANCE
