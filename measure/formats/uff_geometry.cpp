#include "measure/formats/uff_geometry.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "measure/formats/damaged_file.hpp"
#include "measure/formats/fortran_number.hpp"
#include "measure/formats/mapped_file.hpp"
#include "measure/formats/uff_data_set.hpp"
#include "measure/formats/uff_lines.hpp"

namespace secular {
namespace {

// Lines of the data set up to its delimiter, which is taken.
template <class Take>
void each_line(UffLines& lines, Take take) {
  while (!lines.at_end()) {
    const std::string_view line = lines.take();
    if (is_uff_delimiter(line)) return;
    take(line);
  }
  lines.fail("the data set does not end: the delimiter -1 is missing", whole_again);
}

long long whole_field(const UffLines& lines, std::string_view line, std::size_t first, std::size_t width) {
  const std::string_view field = first < line.size() ? line.substr(first, width) : std::string_view();
  const auto number = whole_number(field);
  if (!number)
    lines.fail("'" + std::string(stripped(field)) + "' is no number of a node", "a whole number was expected");
  return *number;
}

std::array<double, 3> coordinates(const UffLines& lines, std::string_view line, std::size_t first,
                                  std::size_t width) {
  std::array<double, 3> at{};
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::size_t begin = first + k * width;
    const std::string_view field = begin < line.size() ? line.substr(begin, width) : std::string_view();
    const auto number = fortran_number(stripped(field));
    if (!number || !std::isfinite(*number))
      lines.fail("'" + std::string(stripped(field)) + "' is no coordinate of a node", "a number was expected");
    at[k] = *number;
  }
  return at;
}

// Data set 15: label, two coordinate systems, colour (4I10), coordinates (3E13.5), one line a node.
void read_short_nodes(UffLines& lines, std::vector<UffNode>& nodes) {
  each_line(lines, [&](std::string_view line) {
    nodes.push_back({whole_field(lines, line, 0, 10), coordinates(lines, line, 40, 13)});
  });
}

// Data sets 781 and 2411: label, two coordinate systems, colour (4I10); coordinates (3D25.16) on the next line.
void read_long_nodes(UffLines& lines, std::vector<UffNode>& nodes) {
  bool named = false;
  each_line(lines, [&](std::string_view line) {
    if (named)
      nodes.back().at = coordinates(lines, line, 0, 25);
    else
      nodes.push_back({whole_field(lines, line, 0, 10), {}});
    named = !named;
  });
  if (named) lines.fail("the last node has no coordinates", whole_again);
}

// Data set 82: number of the line, count of nodes, colour; a name; nodes (8I10), zero where the pen is lifted.
void read_trace_lines(UffLines& lines, std::vector<std::vector<long long>>& strokes) {
  std::size_t row = 0;
  std::vector<long long> stroke;
  const auto lift = [&] {
    if (stroke.size() > 1) strokes.push_back(stroke);
    stroke.clear();
  };
  each_line(lines, [&](std::string_view line) {
    if (row++ < 2) return;
    for (std::size_t first = 0; first < line.size(); first += 10) {
      if (stripped(line.substr(first, 10)).empty()) continue;
      const long long label = whole_field(lines, line, first, 10);
      if (label == 0)
        lift();
      else
        stroke.push_back(label);
    }
  });
  lift();
}

}  // namespace

UffGeometry read_uff_geometry(const std::filesystem::path& path) {
  const MappedFile mapped(path);
  UffLines lines(mapped.bytes(), path.string());
  UffGeometry geometry;
  std::vector<UffNode> nodes;
  UffDataSetHead head;
  while (next_data_set(lines, head)) {
    if (head.number == 15)
      read_short_nodes(lines, nodes);
    else if (head.number == 781 || head.number == 2411)
      read_long_nodes(lines, nodes);
    else if (head.number == 82)
      read_trace_lines(lines, geometry.trace_lines);
    else
      skip_data_set(head, lines);
  }
  std::map<long long, std::size_t> place;
  for (const UffNode& node : nodes) {
    const auto [known, is_new] = place.emplace(node.label, geometry.nodes.size());
    if (is_new)
      geometry.nodes.push_back(node);
    else
      geometry.nodes[known->second] = node;
  }
  return geometry;
}

}  // namespace secular
