#include "motion/simulate/sensor_placement.hpp"

#include <cmath>

namespace secular {
namespace {

double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 vector(const TomlTable& table, std::string_view key) {
  const std::vector<double> numbers = table.numbers(key);
  if (numbers.size() != 3) table.fail(key, "has " + std::to_string(numbers.size()) + " numbers", "x, y and z");
  return {numbers[0], numbers[1], numbers[2]};
}

Vector3 direction(const TomlTable& table, std::string_view key) {
  Vector3 u = vector(table, key);
  const double length = std::sqrt(dot(u, u));
  if (length == 0) table.fail(key, "is zero", "a direction was expected");
  for (double& x : u) x /= length;
  return u;
}

std::vector<Vector3> by_mode(const TomlTable& table, std::string_view key, std::size_t modes) {
  std::vector<Vector3> result;
  for (const std::vector<double>& row : table.number_rows(key)) {
    if (row.size() != 3) table.fail(key, "has a row that is not x, y and z", "three numbers for every mode");
    result.push_back({row[0], row[1], row[2]});
  }
  if (result.size() != modes)
    table.fail(key, "has " + std::to_string(result.size()) + " rows",
               "one for each of the model's " + std::to_string(modes) + " modes");
  return result;
}

}  // namespace

Structure read_structure(const TomlTable& root, std::size_t modes) {
  Structure structure;
  if (root.has("structure")) {
    const TomlTable table = root.table("structure");
    table.refuse_unknown_keys({"base_direction"});
    structure.base_direction = direction(table, "base_direction");
  }
  for (const TomlTable& table : root.tables("body")) {
    table.refuse_unknown_keys({"name", "point", "translation", "rotation"});
    RigidBody body;
    body.point = vector(table, "point");
    body.translation = by_mode(table, "translation", modes);
    body.rotation = table.has("rotation") ? by_mode(table, "rotation", modes) : std::vector<Vector3>(modes);
    if (!structure.bodies.emplace(table.string("name"), std::move(body)).second)
      table.fail("name", "'" + table.string("name") + "' is used twice", "body names differ");
  }
  return structure;
}

Placement read_placement(const TomlTable& response, const Structure& structure) {
  const auto found = structure.bodies.find(response.string("body"));
  if (found == structure.bodies.end()) {
    std::string names;
    for (const auto& [name, ignored] : structure.bodies) names += (names.empty() ? "" : ", ") + name;
    response.fail("body", "'" + response.string("body") + "' is no [[body]]",
                  names.empty() ? "describe the structure's bodies" : "its bodies are " + names);
  }
  const RigidBody& body = found->second;
  const Vector3 position = vector(response, "position"), u = direction(response, "orientation");
  Vector3 arm{};
  for (std::size_t i = 0; i < 3; ++i) arm[i] = position[i] - body.point[i];
  Placement placement;
  for (std::size_t k = 0; k < body.translation.size(); ++k)
    placement.shape.push_back(dot(u, body.translation[k]) + dot(u, cross(body.rotation[k], arm)));
  placement.base = dot(u, structure.base_direction);
  return placement;
}

}  // namespace secular
