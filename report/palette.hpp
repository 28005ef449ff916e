#pragma once

#include <array>
#include <string_view>

namespace secular::report {

/// A colour of series: on light pages and on paper, and on dark ones. Each has a contrast of at least 4.5 with the
/// page (WCAG 2.1, 1.4.3), and the first ones stay apart for the common kinds of colour blindness (hues near those
/// of Okabe and Ito, 2008, spread in lightness); marker shapes and dashes tell series apart without colour.
struct PaletteColor {
  std::string_view name, light, dark;
};

inline constexpr PaletteColor blue = {"blue", "#0072B2", "#6FAEF0"},
                              vermilion = {"vermilion", "#C04A00", "#F07F4A"},
                              green = {"green", "#00845F", "#8EEBC6"}, purple = {"purple", "#7A1458", "#D846B2"},
                              brown = {"brown", "#5E450B", "#E0B62E"}, violet = {"violet", "#4421D3", "#8C78FF"},
                              grey = {"grey", "#6B6F75", "#9AA0A8"};

inline constexpr std::array palette = {blue, vermilion, green, purple, brown, violet, grey};

}  // namespace secular::report
