#include "report/series_look.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace secular::report {
namespace {

constexpr std::string_view blue = "#0072B2", sky = "#56B4E9", green = "#009E73", vermilion = "#D55E00",
                           orange = "#E69F00", purple = "#CC79A7", grey = "#7F7F7F";

constexpr std::array<std::string_view, 6> by_group = {blue, vermilion, green, purple, orange, sky};
// circle, square, triangle, diamond, triangle down: gnuplot's point types
constexpr std::array<int, 5> filled = {7, 5, 9, 13, 11};
constexpr std::array<int, 5> hollow = {6, 4, 8, 12, 10};

std::string_view color_of_role(SeriesRole role, std::size_t turn) {
  const auto pick = [turn](const auto& colors) { return colors[turn % colors.size()]; };
  switch (role) {
    case SeriesRole::data:
      return pick(std::array{blue, sky, green, purple});
    case SeriesRole::held_out:
      return pick(std::array{green, purple, sky, blue});
    case SeriesRole::model:
    case SeriesRole::unstable:
      return pick(std::array{vermilion, orange, purple, sky, green, blue});
    case SeriesRole::hopf:
      return pick(std::array{purple, sky, green});
    case SeriesRole::alternative:
      return pick(std::array{orange, sky, green, purple});
    case SeriesRole::reference:
      return grey;
  }
  return grey;
}

std::string_view dash_of_role(SeriesRole role) {
  switch (role) {
    case SeriesRole::unstable:
      return "(8,5)";
    case SeriesRole::hopf:
      return "(2,4)";
    case SeriesRole::alternative:
      return "(12,4,3,4)";
    default:
      return "solid";
  }
}

}  // namespace

std::vector<SeriesLook> series_looks(const std::vector<Series>& panel) {
  std::map<std::pair<SeriesRole, bool>, std::vector<std::string>> names_seen;  // a band shares its line's colour
  std::vector<SeriesLook> looks;
  for (const Series& series : panel) {
    // Pieces of one branch carry one name and must look the same.
    std::vector<std::string>& names = names_seen[{series.role, series.style == SeriesStyle::band}];
    std::size_t turn = 0;
    while (turn < names.size() && names[turn] != series.name) ++turn;
    if (turn == names.size()) names.push_back(series.name);

    SeriesLook look;
    const std::size_t shape = series.group ? static_cast<std::size_t>(*series.group < 0 ? 0 : *series.group) : turn;
    look.color = series.group && series.role != SeriesRole::reference ? by_group[shape % by_group.size()]
                                                                      : color_of_role(series.role, turn);
    look.dash = dash_of_role(series.role);
    look.line_width = series.role == SeriesRole::reference ? 1.2 : 2;
    look.point_type = (series.role == SeriesRole::held_out ? hollow : filled)[shape % filled.size()];
    look.point_size = series.role == SeriesRole::held_out ? 0.75 : 0.6;
    looks.push_back(look);
  }
  return looks;
}

}  // namespace secular::report
