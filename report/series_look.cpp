#include "report/series_look.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "report/palette.hpp"

namespace secular::report {
namespace {

constexpr std::array by_group = {blue, vermilion, green, purple, brown, violet};
// circle, square, triangle, diamond, triangle down: gnuplot's point types
constexpr std::array<int, 5> filled = {7, 5, 9, 13, 11};
constexpr std::array<int, 5> hollow = {6, 4, 8, 12, 10};

std::string_view color_of_role(SeriesRole role, std::size_t turn) {
  const auto pick = [turn](const auto& colors) { return colors[turn % colors.size()].light; };
  switch (role) {
    case SeriesRole::data:
      return pick(std::array{blue, violet, green, purple});
    case SeriesRole::held_out:
      return pick(std::array{green, purple, violet, blue});
    case SeriesRole::model:
    case SeriesRole::unstable:
      return pick(std::array{vermilion, brown, purple, violet, green, blue});
    case SeriesRole::hopf:
      return pick(std::array{purple, violet, green});
    case SeriesRole::alternative:
      return pick(std::array{brown, violet, green, purple});
    case SeriesRole::reference:
      return grey.light;
  }
  return grey.light;
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
  std::map<std::pair<SeriesRole, bool>, std::vector<std::string>>
      names_seen;  // what is filled shares its line's colour
  std::vector<SeriesLook> looks;
  for (const Series& series : panel) {
    // Pieces of one branch carry one name and must look the same.
    std::vector<std::string>& names = names_seen[{series.role, is_filled(series.style)}];
    std::size_t turn = 0;
    while (turn < names.size() && names[turn] != series.name) ++turn;
    if (turn == names.size()) names.push_back(series.name);

    SeriesLook look;
    const std::size_t shape = series.group ? static_cast<std::size_t>(*series.group < 0 ? 0 : *series.group) : turn;
    look.color = series.group && series.role != SeriesRole::reference ? by_group[shape % by_group.size()].light
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
