#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/figure.hpp"

namespace secular::report {

/// Texts of a figure on their way around gnuplot: it sees place holders of letters and digits only.
class PlaceHolders {
 public:
  /// The place holder that stands for `text`.
  std::string add(std::string_view text);
  /// The text of a place holder, escaped for XML; nullptr if `word` is none.
  const std::string* find(std::string_view word) const;

 private:
  std::vector<std::string> escaped_;
};

/// Colours that gnuplot is told to use where the final colour depends on the page.
inline constexpr std::string_view ink_color = "#010203";
inline constexpr std::string_view grid_color = "#010204";

/// The element that a figure becomes.
struct SvgFrame {
  std::string_view title;
  int width = 0, height = 0;
  FigureUse use = FigureUse::inline_html;
};

/// From what gnuplot's svg terminal writes to the figure's <svg> element: texts put in, ids prefixed, colours of
/// ink and grid resolved, gnuplot's version and empty groups left out.
std::string clean_svg(std::string_view gnuplot_svg, const PlaceHolders& texts, std::string_view id,
                      const SvgFrame& frame);

/// The opening tag, name and (standalone) background of a figure's SVG.
std::string svg_head(const SvgFrame& frame);

/// One line of text of a figure that is drawn without gnuplot. `anchor`: "start", "middle" or "end"; `attributes`:
/// further ones, written as they are.
std::string svg_text(double x, double y, std::string_view text, std::string_view anchor = "middle",
                     std::string_view attributes = "");

}  // namespace secular::report
