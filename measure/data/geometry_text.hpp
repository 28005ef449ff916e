#pragma once

#include <string>
#include <vector>

#include "input/toml_table.hpp"
#include "measure/data/geometry.hpp"

namespace secular {

struct Channel;

/// The [geometry] of campaign.toml. Throws InputError for points and channels that are not there, a direction of no
/// length.
Geometry read_geometry(const TomlTable& table, const std::vector<Channel>& channels);

/// The same as text; reading restores every number bit by bit.
std::string geometry_text(const Geometry& geometry);

}  // namespace secular
