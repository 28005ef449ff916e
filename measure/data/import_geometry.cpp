#include "measure/data/import_geometry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>
#include <string>
#include <system_error>

#include "input/input_error.hpp"
#include "measure/formats/uff_file.hpp"
#include "measure/formats/uff_geometry.hpp"

namespace secular {

std::optional<Geometry> import_geometry(const std::filesystem::path& named, const std::filesystem::path& first_file,
                                        const std::vector<DescribedChannel>& channels, const Variables& variables,
                                        std::vector<std::string>& warnings) {
  const std::filesystem::path& file = named.empty() ? first_file : named;
  if (std::error_code ignored; !named.empty() && !std::filesystem::is_regular_file(named, ignored))
    throw InputError("--geometry " + named.string(), "",
                     std::filesystem::exists(named, ignored) ? "is no file" : "does not exist",
                     "a universal file with nodes was expected");
  if (!looks_like_uff(file)) {
    if (named.empty()) return std::nullopt;
    throw InputError(
        "--geometry " + named.string(), "", "is no universal file",
        "a file with nodes (data set 15, 781 or 2411) was expected; points of other files go into [geometry] of "
        "campaign.toml");
  }
  const UffGeometry found = read_uff_geometry(file);
  if (found.nodes.empty()) {
    if (named.empty()) return std::nullopt;
    throw InputError("--geometry " + named.string(), "", "holds no nodes",
                     "a data set 15, 781 or 2411 was expected");
  }
  Geometry geometry;
  std::map<std::string, std::array<double, 3>> points;
  for (const UffNode& node : found.nodes) points[std::to_string(node.label)] = node.at;
  std::map<std::string, std::size_t> place;
  for (const auto& [name, at] : points) {
    place[name] = geometry.points.size();
    geometry.points.push_back({name, at});
  }
  std::set<std::string> missing;
  for (const std::vector<long long>& stroke : found.trace_lines) {
    std::vector<std::size_t> line;
    const auto lift = [&] {
      if (line.size() > 1) geometry.lines.push_back(line);
      line.clear();
    };
    for (const long long label : stroke) {
      if (const auto point = place.find(std::to_string(label)); point != place.end()) {
        line.push_back(point->second);
        continue;
      }
      lift();
      missing.insert(std::to_string(label));
    }
    lift();
  }
  for (const DescribedChannel& described : channels) {
    const DataVariable* variable = find_variable(variables, described.variable);
    if (described.channel.role != ChannelRole::response || !variable || !variable->sensor) continue;
    const auto point = place.find(variable->sensor->node);
    if (point != place.end())
      geometry.sensors.push_back({described.channel.name, point->second, variable->sensor->direction});
    else
      missing.insert(variable->sensor->node);
  }
  if (!missing.empty())
    warnings.push_back(fmt::format("{}: there are trace lines or channels at nodes that it does not hold: {}",
                                   file.string(), fmt::join(missing, ", ")));
  if (geometry.sensors.empty())
    warnings.push_back(file.string() +
                       ": no channel says at which node it measures, so that no mode can be drawn; write "
                       "[geometry.sensors] into campaign.toml");
  if (named.empty() && geometry.sensors.empty()) return std::nullopt;
  return geometry;
}

}  // namespace secular
