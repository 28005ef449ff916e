#include "report/svg_cleanup.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "input/markup.hpp"
#include "report/palette.hpp"

namespace secular::report {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

std::string_view between(std::string_view text, std::string_view begin, std::string_view end) {
  const std::size_t from = text.find(begin);
  if (from == std::string_view::npos) return {};
  const std::size_t to = text.find(end, from);
  return to == std::string_view::npos ? std::string_view{}
                                      : text.substr(from + begin.size(), to - from - begin.size());
}

void put_text(std::string& line, const PlaceHolders& texts) {
  constexpr std::string_view open = "<text>", close = "</text>";
  const std::size_t begin = line.find(open), end = line.find(close);
  if (begin == std::string::npos || end == std::string::npos) return;
  const std::size_t inside = begin + open.size();
  if (const std::string* text = texts.find(std::string_view(line).substr(inside, end - inside)))
    line.replace(inside, end - inside, *text);
}

/// gnuplot's two ways to write a colour of six digits: "rgb(  0, 114, 178)" and "rgb(0,114,178)".
std::array<std::string, 2> gnuplot_colors(std::string_view hex) {
  int red = 0, green_part = 0, blue_part = 0;
  std::from_chars(hex.data() + 1, hex.data() + 3, red, 16);
  std::from_chars(hex.data() + 3, hex.data() + 5, green_part, 16);
  std::from_chars(hex.data() + 5, hex.data() + 7, blue_part, 16);
  return {fmt::format("rgb({:3}, {:3}, {:3})", red, green_part, blue_part),
          fmt::format("rgb({},{},{})", red, green_part, blue_part)};
}

/// Colours of series become those of the page's theme (series_variables).
void follow_the_page(std::string& svg) {
  for (const PaletteColor& color : palette)
    for (const std::string& written : gnuplot_colors(color.light))
      replace_all(svg, written, fmt::format("var(--{})", color.name));
}

std::string clean_line(std::string_view raw, const PlaceHolders& texts, std::string_view id) {
  std::string line(raw);
  if (line.find("id=\"gnuplot_plot_") != std::string::npos) return "<g>";  // its <title> repeats the plot command
  for (const std::string_view noise :
       {" color=\"black\"", " color=\"white\"", " font-family=\"sans-serif\"", " shape-rendering='crispEdges'",
        " stroke-linecap=\"butt\"", " stroke-linejoin=\"miter\"", " class=\"gridline\""})
    replace_all(line, noise, "");
  replace_all(line, " font-family=\"secular-bold\"", " font-weight=\"600\"");
  for (const std::string_view ink : {"rgb(  1,   2,   3)", "rgb(1,2,3)"}) replace_all(line, ink, "currentColor");
  replace_all(line, "stroke='rgb(  1,   2,   4)'", "stroke='currentColor' stroke-opacity='0.13'");
  replace_all(line, "fill=\"black\"", "fill=\"currentColor\"");
  replace_all(line, "stroke-width='0.205'", "stroke-width='0.35'");
  replace_all(line, "gpPt", fmt::format("{}-pt", id));
  replace_all(line, "gpDot", fmt::format("{}-dot", id));
  put_text(line, texts);
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin == std::string::npos ? std::string() : line.substr(begin);
}

}  // namespace

std::string PlaceHolders::add(std::string_view text) {
  escaped_.push_back(escape_markup_line(text));
  return fmt::format("text{}", escaped_.size() - 1);
}

const std::string* PlaceHolders::find(std::string_view word) const {
  while (word.starts_with(' ')) word.remove_prefix(1);
  if (!word.starts_with("text")) return nullptr;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(word.data() + 4, word.data() + word.size(), index);
  if (error != std::errc() || end != word.data() + word.size() || index >= escaped_.size()) return nullptr;
  return &escaped_[index];
}

std::string svg_head(const SvgFrame& frame) {
  const auto& [title, width, height, use] = frame;
  const std::string name = escape_markup_line(title);
  std::string head = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" viewBox=\"0 0 {0} "
      "{1}\" "
      "width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"{2}\" "
      "font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" stroke-linejoin=\"round\"",
      width, height, name);
  if (use == FigureUse::standalone)
    head +=
        fmt::format(" color=\"#1b1f24\">\n<title>{}</title>\n<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n",
                    name, width, height);
  else
    head += fmt::format(" style=\"--width: {}px\">\n<title>{}</title>\n", width, name);
  return head;
}

std::string svg_text(double x, double y, std::string_view text, std::string_view anchor,
                     std::string_view attributes) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" fill=\"currentColor\" {}>{}</text>\n", x,
                     y, anchor, attributes, escape_markup_line(text));
}

std::string clean_svg(std::string_view gnuplot_svg, const PlaceHolders& texts, std::string_view id,
                      const SvgFrame& frame) {
  std::string svg = svg_head(frame);
  const auto append_lines = [&](std::string_view part) {
    std::string pending;  // an opened group of which nothing has been written yet
    while (!part.empty()) {
      const std::size_t end = part.find('\n');
      const std::string line = clean_line(part.substr(0, end), texts, id);
      part.remove_prefix(end == std::string_view::npos ? part.size() : end + 1);
      if (line.empty()) continue;
      if (!pending.empty() && line == "</g>") {
        pending.clear();
        continue;
      }
      if (!pending.empty()) svg += pending + '\n';
      pending.clear();
      const bool opens_a_group =
          line.starts_with("<g") && line.ends_with('>') && line.find("</g>") == std::string::npos;
      if (opens_a_group)
        pending = line;
      else
        svg += line + '\n';
    }
    if (!pending.empty()) svg += pending + '\n';
  };
  svg += "<defs>\n";
  append_lines(between(gnuplot_svg, "<defs>", "<filter"));
  svg += "</defs>\n<g>\n";
  append_lines(between(gnuplot_svg, "</defs>", "</svg>"));
  if (frame.use == FigureUse::inline_html) follow_the_page(svg);
  return svg + "</svg>\n";
}

}  // namespace secular::report
