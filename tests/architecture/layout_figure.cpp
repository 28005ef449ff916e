#include "layout_figure.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace secular::architecture {
namespace {

constexpr double box_width = 168, box_height = 30, gap = 22, row_height = 92, margin = 20;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

// Everything that is reached from each folder.
FolderGraph reached_from(const FolderGraph& graph) {
  FolderGraph reached;
  std::set<std::string> open;
  const std::function<const std::set<std::string>&(const std::string&)> of =
      [&](const std::string& folder) -> const std::set<std::string>& {
    if (const auto known = reached.find(folder); known != reached.end()) return known->second;
    if (!open.insert(folder).second) throw std::logic_error(folder + " includes itself by way of others");
    std::set<std::string> all;
    if (const auto own = graph.find(folder); own != graph.end())
      for (const std::string& target : own->second) {
        all.insert(target);
        const std::set<std::string>& further = of(target);
        all.insert(further.begin(), further.end());
      }
    open.erase(folder);
    return reached[folder] = std::move(all);
  };
  for (const auto& [folder, targets] : graph) of(folder);
  return reached;
}

// Without the arrows that a longer way makes superfluous.
FolderGraph reduced(const FolderGraph& graph) {
  const FolderGraph reached = reached_from(graph);
  FolderGraph result;
  for (const auto& [folder, targets] : graph) {
    std::set<std::string>& kept = result[folder];
    for (const std::string& target : targets)
      if (std::none_of(targets.begin(), targets.end(), [&](const std::string& other) {
            return other != target && reached.at(other).count(target) == 1;
          }))
        kept.insert(target);
  }
  return result;
}

// Rows of folders, the lowest first: each folder above everything that it includes.
std::vector<std::vector<std::string>> rows_of(const FolderGraph& graph) {
  std::map<std::string, std::size_t> level;
  const std::function<std::size_t(const std::string&)> of = [&](const std::string& folder) -> std::size_t {
    if (const auto known = level.find(folder); known != level.end()) return known->second;
    std::size_t height = 0;
    for (const std::string& target : graph.at(folder)) height = std::max(height, of(target) + 1);
    return level[folder] = height;
  };
  std::vector<std::vector<std::string>> rows;
  for (const auto& [folder, targets] : graph) {
    const std::size_t row = of(folder);
    rows.resize(std::max(rows.size(), row + 1));
    rows[row].push_back(folder);
  }
  return rows;
}

double width_of(std::size_t boxes) {
  return static_cast<double>(boxes) * (box_width + gap) - gap;
}

// Horizontal centres. Every row is ordered by the mean place of what its folders are joined to, a few times over.
std::map<std::string, double> places(const FolderGraph& graph, std::vector<std::vector<std::string>>& rows,
                                     double width) {
  std::map<std::string, double> place;
  const auto lay_out = [&](const std::vector<std::string>& row) {
    double x = (width - width_of(row.size())) / 2 + box_width / 2;
    for (const std::string& folder : row) {
      place[folder] = x;
      x += box_width + gap;
    }
  };
  for (const auto& row : rows) lay_out(row);
  FolderGraph joined = graph;
  for (const auto& [folder, targets] : graph)
    for (const std::string& target : targets) joined[target].insert(folder);
  const auto mean_place = [&](const std::string& folder) {
    const std::set<std::string>& others = joined.at(folder);
    if (others.empty()) return place.at(folder);
    return std::accumulate(others.begin(), others.end(), 0.0,
                           [&](double sum, const std::string& other) { return sum + place.at(other); }) /
           static_cast<double>(others.size());
  };
  for (int round = 0; round < 8; ++round)
    for (auto& row : rows) {
      std::map<std::string, double> wanted;
      for (const std::string& folder : row) wanted[folder] = mean_place(folder);
      std::stable_sort(row.begin(), row.end(),
                       [&](const std::string& a, const std::string& b) { return wanted.at(a) < wanted.at(b); });
      lay_out(row);
    }
  return place;
}

}  // namespace

std::string layout_figure(const FolderGraph& graph) {
  const FolderGraph arrows = reduced(graph);
  std::vector<std::vector<std::string>> rows = rows_of(arrows);
  double width = 0;
  for (const auto& row : rows) width = std::max(width, width_of(row.size()));
  const std::map<std::string, double> place = places(arrows, rows, width);
  const double height = static_cast<double>(rows.size() - 1) * row_height + box_height;
  std::map<std::string, double> top;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const std::string& folder : rows[r])
      top[folder] = margin + static_cast<double>(rows.size() - 1 - r) * row_height;
  const double full_width = width + 2 * margin, full_height = height + 2 * margin;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(full_width) + " " +
                    number(full_height) + "\" font-family=\"sans-serif\" font-size=\"14\">\n" +
                    "<title>Folders of the project, each above those that it includes</title>\n" +
                    "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const auto& [folder, targets] : arrows)
    for (const std::string& target : targets) {
      const double x1 = place.at(folder) + margin, y1 = top.at(folder) + box_height;
      const double x2 = place.at(target) + margin, y2 = top.at(target);
      const double bend = std::min(row_height / 2, (y2 - y1) / 2);
      svg += "<path d=\"M" + number(x1) + " " + number(y1) + " C" + number(x1) + " " + number(y1 + bend) + " " +
             number(x2) + " " + number(y2 - bend) + " " + number(x2) + " " + number(y2) +
             "\" fill=\"none\" stroke=\"#5b6b7b\" stroke-width=\"1.2\"/>\n";
    }
  for (const auto& [folder, y] : top)
    svg += "<rect x=\"" + number(place.at(folder) + margin - box_width / 2) + "\" y=\"" + number(y) +
           "\" width=\"" + number(box_width) + "\" height=\"" + number(box_height) +
           "\" rx=\"5\" fill=\"#eef3f8\" stroke=\"#2f4b66\"/>\n<text x=\"" + number(place.at(folder) + margin) +
           "\" y=\"" + number(y + box_height / 2 + 5) + "\" text-anchor=\"middle\" fill=\"#1b2733\">" + folder +
           "</text>\n";
  return svg + "</svg>\n";
}

}  // namespace secular::architecture
