#pragma once

#include <string>
#include <vector>

#include "report/figure.hpp"

namespace secular::report {

/// Where a panel is drawn: pixels of the figure (y downwards), and the data at its edges.
struct PlotArea {
  double left = 0, right = 0, top = 0, bottom = 0;
  double x_low = 0, x_high = 1, y_low = 0, y_high = 1;
};

/// The drawn points as JSON, for the script that shows values under the pointer (hover_script.hpp): by panel the
/// pixels of its edges, the data there, whether an axis is logarithmic, the axes' names, and of every series its
/// name and x, y in turn. Of a series of more than 600 points as many, evenly chosen. `areas`: one a panel.
std::string figure_points(const Figure& figure, const std::vector<PlotArea>& areas);

}  // namespace secular::report
