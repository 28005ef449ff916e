#include "report/structure_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include "report/palette.hpp"
#include "report/svg_cleanup.hpp"

namespace secular::report {
namespace {

constexpr double drawing_width = 360, least_height = 110, most_height = 360, edge = 34, title_height = 30;
/// Of the structure's size, its largest motion.
constexpr double largest_motion = 0.15;
/// Frames of one period.
constexpr int frames = 24;

struct OnPage {
  double x = 0, y = 0;
};

// Onto the plane across the direction (1, -2, 1): right is (2, 1, 0), up what is left of z.
OnPage projected(const std::array<double, 3>& p) {
  return {(2 * p[0] + p[1]) / std::sqrt(5.0), (-p[0] + 2 * p[1] + 5 * p[2]) / std::sqrt(30.0)};
}

class Drawing {
 public:
  explicit Drawing(const StructureDrawing& drawing) : drawing_(drawing) {
    if (drawing.points.empty() || drawing.points.size() != drawing.motion.size())
      throw std::invalid_argument("structure drawing: sizes differ, or no points");
    if (drawing.id.empty() || !std::all_of(drawing.id.begin(), drawing.id.end(),
                                           [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }))
      throw std::invalid_argument("structure drawing: SMIL cannot read the id " + drawing.id);
    for (const std::vector<std::size_t>& line : drawing.lines)
      for (const std::size_t point : line)
        if (point >= drawing.points.size())
          throw std::invalid_argument("structure drawing: a line leaves the points");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double low = drawing.points[0][axis], high = low;
      for (const std::array<double, 3>& p : drawing.points) {
        low = std::min(low, p[axis]);
        high = std::max(high, p[axis]);
      }
      size_ = std::hypot(size_, high - low);
    }
    if (!(size_ > 0)) size_ = 1;  // a single point
    double largest = 0;
    for (const auto& m : drawing.motion) {
      double square = 0;
      for (const std::complex<double>& part : m) square += std::norm(part);
      largest = std::max(largest, std::sqrt(square));
    }
    scale_ = largest > 0 ? largest_motion * size_ / largest : 0;
    fit_page();
  }

  std::string svg() const {
    const SvgFrame frame{drawing_.title, static_cast<int>(drawing_width), static_cast<int>(std::ceil(height_)),
                         FigureUse::inline_html};
    std::string text = svg_head(frame);
    text += fmt::format(
        "<g id=\"{}\" fill=\"none\" cursor=\"pointer\" tabindex=\"0\" role=\"button\" aria-label=\"set it "
        "going\">\n",
        drawing_.id);
    text += fmt::format("<rect width=\"{}\" height=\"{:.0f}\" fill-opacity=\"0\" pointer-events=\"all\"/>\n",
                        drawing_width, height_);
    text += svg_text(8, 20, drawing_.title, "start", "font-size=\"14\" font-weight=\"600\"");
    for (const std::vector<std::size_t>& line : drawing_.lines) {
      text += stroke(line, 0, 0, "currentColor", "stroke-opacity=\"0.45\" stroke-width=\"1\"", false);
      text += stroke(line, 1, std::numbers::pi, vermilion.name,
                     "stroke-opacity=\"0.55\" stroke-width=\"1.2\" stroke-dasharray=\"5 4\"", false);
    }
    for (std::size_t p = 0; p < drawing_.points.size(); ++p) {
      const OnPage at = place(p, 0, 0);
      text += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\" fill=\"currentColor\"/>\n", at.x, at.y);
      if (moves(p)) text += stroke({p}, 1, 0, vermilion.name, "stroke-width=\"1.2\"", true);
    }
    for (const std::vector<std::size_t>& line : drawing_.lines)
      text += stroke(line, 1, 0, vermilion.name, "stroke-width=\"2.2\" stroke-linecap=\"round\"", true);
    return text + "</g>\n</svg>\n";
  }

 private:
  bool moves(std::size_t p) const {
    return std::any_of(drawing_.motion[p].begin(), drawing_.motion[p].end(),
                       [](const std::complex<double>& part) { return std::abs(part) > 0; });
  }

  OnPage moved(std::size_t p, double share, double phase) const {
    std::array<double, 3> at = drawing_.points[p];
    for (std::size_t axis = 0; axis < 3; ++axis)
      at[axis] += share * scale_ * (drawing_.motion[p][axis] * std::polar(1.0, phase)).real();
    return projected(at);
  }

  OnPage place(std::size_t p, double share, double phase) const {
    const OnPage at = moved(p, share, phase);
    return {edge + (at.x - left_) * unit_, title_height + (top_ - at.y) * unit_};
  }

  // Room for every place that the motion can reach.
  void fit_page() {
    left_ = top_ = std::numeric_limits<double>::quiet_NaN();
    double right = left_, bottom = left_;
    for (std::size_t p = 0; p < drawing_.points.size(); ++p)
      for (int frame = 0; frame < frames; ++frame) {
        const OnPage at = moved(p, 1, 2 * std::numbers::pi * frame / frames);
        left_ = std::fmin(left_, at.x);
        right = std::fmax(right, at.x);
        top_ = std::fmax(top_, at.y);
        bottom = std::fmin(bottom, at.y);
      }
    const double wide = drawing_width - 2 * edge, high = most_height - title_height - edge / 2;
    unit_ = std::min(wide / std::max(right - left_, 1e-3 * size_), high / std::max(top_ - bottom, 1e-3 * size_));
    left_ -= (wide / unit_ - (right - left_)) / 2;
    height_ = std::max(least_height, title_height + (top_ - bottom) * unit_ + edge / 2);
  }

  // Along the points of a line; of one point from its rest.
  std::string points_of(const std::vector<std::size_t>& line, double share, double phase) const {
    std::string text;
    if (line.size() == 1) {
      const OnPage rest = place(line[0], 0, 0);
      text = fmt::format("{:.1f},{:.1f} ", rest.x, rest.y);
    }
    for (const std::size_t p : line) {
      const OnPage at = place(p, share, phase);
      text += fmt::format("{:.1f},{:.1f} ", at.x, at.y);
    }
    text.pop_back();
    return text;
  }

  std::string stroke(const std::vector<std::size_t>& line, double share, double phase, std::string_view color,
                     std::string_view look, bool in_motion) const {
    const std::string paint = color == "currentColor" ? std::string(color) : fmt::format("var(--{})", color);
    std::string text =
        fmt::format("<polyline points=\"{}\" stroke=\"{}\" {}", points_of(line, share, phase), paint, look);
    if (!in_motion) return text + "/>\n";
    text += fmt::format(
        "><animate attributeName=\"points\" begin=\"{0}.click;{0}.keypress\" restart=\"whenNotActive\" "
        "dur=\"1.25s\" repeatCount=\"8\" values=\"",
        drawing_.id);
    for (int frame = 0; frame <= frames; ++frame)
      text += (frame ? ";" : "") + points_of(line, share, phase + 2 * std::numbers::pi * frame / frames);
    return text + "\"/></polyline>\n";
  }

  const StructureDrawing& drawing_;
  double size_ = 0, scale_ = 0, left_ = 0, top_ = 0, unit_ = 1, height_ = 0;
};

}  // namespace

std::string structure_drawing(const StructureDrawing& drawing) {
  return Drawing(drawing).svg();
}

}  // namespace secular::report
