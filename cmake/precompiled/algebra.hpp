#pragma once

// What most symbolic sources include, parsed once. No source relies on this file: each includes what it uses.

#include <fmt/format.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>
