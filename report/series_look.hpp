#pragma once

#include <string_view>
#include <vector>

#include "report/figure.hpp"

namespace secular::report {

/// How one series is drawn, in gnuplot's terms.
struct SeriesLook {
  std::string_view color;  ///< "#0072B2", of PaletteColor::light
  std::string_view dash;   ///< gnuplot dash type: "solid" or "(8,5)"
  double line_width = 2;
  int point_type = 7;
  double point_size = 0.6;
};

/// The looks of a panel's series, by index: colours of the palette, marker shapes and dashes.
std::vector<SeriesLook> series_looks(const std::vector<Series>& panel);

}  // namespace secular::report
