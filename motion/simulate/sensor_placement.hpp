#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "input/toml_table.hpp"

namespace secular {

using Vector3 = std::array<double, 3>;

/// A rigid part of the structure: how its point `point` translates and how the part turns in a unit of every modal
/// displacement (mass-normalised, per mode).
struct RigidBody {
  Vector3 point{};
  std::vector<Vector3> translation, rotation;
};

/// Structure as rigid bodies on a base that moves along `base_direction`.
struct Structure {
  Vector3 base_direction{};
  std::map<std::string, RigidBody> bodies;
};

/// What one sensor sees: of every mode (a row of the mode shapes), and of the base's own motion.
struct Placement {
  std::vector<double> shape;
  double base = 0;
};

/// Reads [structure] and [[body]] for a model of `modes` modes. Throws InputError.
Structure read_structure(const TomlTable& root, std::size_t modes);

/// A sensor's `body`, `position` (m) and `orientation` (turned into a unit vector): orientation . (translation +
/// rotation x (position - point)).
Placement read_placement(const TomlTable& response, const Structure& structure);

}  // namespace secular
