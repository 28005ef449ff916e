#include "measure/data/geometry_text.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "measure/data/campaign.hpp"
#include "measure/data/toml_text.hpp"

namespace secular {
namespace {

std::array<double, 3> triple(const TomlTable& table, const std::string& key) {
  const std::vector<double> numbers = table.numbers(key);
  if (numbers.size() != 3)
    table.fail(key, "has " + std::to_string(numbers.size()) + " numbers", "[x, y, z] was expected");
  return {numbers[0], numbers[1], numbers[2]};
}

Geometry::Sensor read_sensor(const TomlTable& table, const std::string& channel,
                             const std::map<std::string, std::size_t>& places) {
  table.refuse_unknown_keys({"point", "direction"});
  Geometry::Sensor sensor{channel, 0, triple(table, "direction")};
  const auto place = places.find(table.string("point"));
  if (place == places.end())
    table.fail("point", "'" + table.string("point") + "' is none of the points", "name one of [geometry.points]");
  sensor.point = place->second;
  const double length = std::hypot(sensor.direction[0], sensor.direction[1], sensor.direction[2]);
  if (!(length > 0)) table.fail("direction", "has no length", "[0, 0, 1] for a sensor along z");
  for (double& part : sensor.direction) part /= length;
  return sensor;
}

std::string triple_text(const std::array<double, 3>& x) {
  return "[" + toml_number(x[0]) + ", " + toml_number(x[1]) + ", " + toml_number(x[2]) + "]";
}

}  // namespace

Geometry read_geometry(const TomlTable& table, const std::vector<Channel>& channels) {
  table.refuse_unknown_keys({"points", "lines", "sensors"});
  Geometry geometry;
  std::map<std::string, std::size_t> places;
  const TomlTable points = table.table("points");
  for (const std::string& name : points.keys()) {
    places[name] = geometry.points.size();
    geometry.points.push_back({name, triple(points, name)});
  }
  if (geometry.points.empty()) table.fail("points", "is empty", "NAME = [x, y, z] for every point");
  if (table.has("lines"))
    for (const std::vector<std::string>& names : table.string_rows("lines")) {
      if (names.size() < 2) table.fail("lines", "holds a line of fewer than two points", "two points or more");
      std::vector<std::size_t>& line = geometry.lines.emplace_back();
      for (const std::string& name : names) {
        const auto place = places.find(name);
        if (place == places.end())
          table.fail("lines", "'" + name + "' is none of the points", "names of [geometry.points] were expected");
        line.push_back(place->second);
      }
    }
  if (!table.has("sensors")) return geometry;
  const TomlTable sensors = table.table("sensors");
  for (const std::string& name : sensors.keys())
    if (std::none_of(channels.begin(), channels.end(),
                     [&](const Channel& c) { return c.name == name && c.role == ChannelRole::response; }))
      sensors.fail(name, "is no response of this campaign", "the name of a response [[channel]] was expected");
  for (const Channel& channel : channels)
    if (sensors.has(channel.name))
      geometry.sensors.push_back(read_sensor(sensors.table(channel.name), channel.name, places));
  return geometry;
}

std::string geometry_text(const Geometry& geometry) {
  std::string text = "\n[geometry]\n";
  if (!geometry.lines.empty()) {
    text += "lines = [";
    for (std::size_t l = 0; l < geometry.lines.size(); ++l) {
      std::vector<std::string> names;
      for (const std::size_t point : geometry.lines[l]) names.push_back(geometry.points[point].name);
      text += (l ? ", " : "") + toml_list(names);
    }
    text += "]\n";
  }
  text += "\n[geometry.points]\n";
  for (const Geometry::Point& point : geometry.points)
    text += toml_string(point.name) + " = " + triple_text(point.at) + "\n";
  if (geometry.sensors.empty()) return text;
  text += "\n[geometry.sensors]\n";
  for (const Geometry::Sensor& sensor : geometry.sensors)
    text += toml_string(sensor.channel) + " = { point = " + toml_string(geometry.points[sensor.point].name) +
            ", direction = " + triple_text(sensor.direction) + " }\n";
  return text;
}

}  // namespace secular
