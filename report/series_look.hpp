#pragma once

#include <string_view>
#include <vector>

#include "report/figure.hpp"

namespace secular::report {

/// How one series is drawn, in gnuplot's terms.
struct SeriesLook {
  std::string_view color;  ///< "#0072B2"
  std::string_view dash;   ///< gnuplot dash type: "solid" or "(8,5)"
  double line_width = 2;
  int point_type = 7;
  double point_size = 0.6;
};

/// The looks of a panel's series, by index. Colours are from the palette of Okabe and Ito (2008), which stays apart
/// for the common kinds of colour blindness; marker shapes and dashes tell series apart in black and white.
std::vector<SeriesLook> series_looks(const std::vector<Series>& panel);

}  // namespace secular::report
