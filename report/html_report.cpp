#include "report/html_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "input/markup.hpp"
#include "input/page_style.hpp"
#include "report/hover_script.hpp"
#include "report/html_style.hpp"
#include "report/number_format.hpp"
#include "report/palette.hpp"
#include "report/warning_kinds.hpp"

namespace secular::report {
namespace {

std::string_view class_of(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "good";
    case Tone::caution:
      return "caution";
    case Tone::bad:
      return "bad";
    case Tone::neutral:
      break;
  }
  return "neutral";
}

/// Said in words as well: colour alone does not print and is not seen by everyone.
std::string_view word_for(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "good";
    case Tone::caution:
      return "caution";
    case Tone::bad:
      return "problem";
    case Tone::neutral:
      break;
  }
  return "";
}

std::string element(std::string_view tag, std::string_view text) {
  return fmt::format("<{0}>{1}</{0}>\n", tag, escape_markup(text));
}

/// Characters after the decimal point of plain decimals ("-12.5" -> 1); -1 for any other text.
int decimals_of(std::string_view cell) {
  constexpr std::string_view minus = "\u2212";
  if (cell.starts_with(minus))
    cell.remove_prefix(minus.size());
  else if (cell.starts_with('-'))
    cell.remove_prefix(1);
  const std::size_t point = cell.find('.');
  const auto all_digits = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  if (point == std::string_view::npos) return all_digits(cell) ? 0 : -1;
  const std::string_view fraction = cell.substr(point + 1);
  return all_digits(cell.substr(0, point)) && all_digits(fraction) ? static_cast<int>(fraction.size()) : -1;
}

/// What a right-aligned column of plain decimals needs behind each number for the points to stand below each other:
/// U+2007 is as wide as a digit, U+2008 as a point. Any other content gets nothing.
std::vector<std::string> padding_of(const Table& table, std::size_t column) {
  std::vector<std::string> padding(table.rows.size());
  if (table.columns[column].kind != Column::Kind::number) return padding;
  std::vector<int> decimals;
  for (const auto& row : table.rows) decimals.push_back(row[column].empty() ? 0 : decimals_of(row[column]));
  if (decimals.empty() || *std::min_element(decimals.begin(), decimals.end()) < 0) return padding;
  const int most = *std::max_element(decimals.begin(), decimals.end());
  for (std::size_t r = 0; r < padding.size(); ++r) {
    if (most > 0 && decimals[r] == 0) padding[r] += "\u2008";
    for (int i = decimals[r]; i < most; ++i) padding[r] += "\u2007";
  }
  return padding;
}

/// A number, an interval or a quantity: it never breaks across lines.
bool is_number(std::string_view text) {
  constexpr std::string_view minus = "\u2212";
  if (text.starts_with(minus)) text.remove_prefix(minus.size());
  while (text.starts_with('(') || text.starts_with('[') || text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && text.front() >= '0' && text.front() <= '9';
}

/// Of a cell: numbers and short texts keep to one line; names of lumps, files and the like part where their own
/// parts do.
std::string_view cell_class(Column::Kind kind, std::string_view text) {
  constexpr std::size_t short_text = 22, long_name = 48;
  if (kind == Column::Kind::number) return " class=\"number\"";
  if (text.size() <= short_text || (text.size() <= long_name && is_number(text))) return " class=\"short\"";
  return text.size() <= long_name && text.find(' ') == std::string_view::npos ? " class=\"name\"" : "";
}

/// Of a cell, as markup; a name may part behind _ and the like, which leaves nothing in what is copied, and a
/// number before what is said of it.
std::string cell_text(std::string_view cell_class, std::string_view text) {
  constexpr std::string_view doubt = " doubtful";
  if (text.ends_with(doubt) && text.size() > doubt.size())
    return escape_markup(text.substr(0, text.size() - doubt.size())) + " <wbr>doubtful";
  if (cell_class.find("name") == std::string_view::npos) return escape_markup(text);
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("_/:.", begin), text.size() - 1) + 1;
    result += escape_markup(text.substr(begin, end - begin));
    if (end < text.size()) result += "<wbr>";
    begin = end;
  }
  return result;
}

/// The palette as variables of the style sheet, by theme.
std::string series_variables() {
  std::string light, dark;
  for (const PaletteColor& color : palette) {
    light += fmt::format(" --{}: {};", color.name, color.light);
    dark += fmt::format(" --{}: {};", color.name, color.dark);
  }
  return fmt::format(":root {{{0} }}\n@media screen and (prefers-color-scheme: dark) {{ :root {{{1} }} }}\n", light,
                     dark);
}

/// The warnings box: one line for every kind, those of one kind under it.
std::string warnings_box(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return "";
  std::string box = fmt::format("<div class=\"warnings\" role=\"note\"><strong>{}</strong>\n<ul>\n",
                                warnings.size() == 1 ? "Warning" : fmt::format("{} warnings", warnings.size()));
  for (const std::vector<std::size_t>& kind : warning_kinds(warnings)) {
    const std::string first = escape_markup(warnings[kind.front()]);
    if (kind.size() == 1) {
      box += fmt::format("<li>{}</li>\n", first);
      continue;
    }
    box +=
        fmt::format("<li><details><summary>{} of this kind, the first: {}</summary>\n<ul>\n", kind.size(), first);
    for (std::size_t i = 1; i < kind.size(); ++i) box += element("li", warnings[kind[i]]);
    box += "</ul></details></li>\n";
  }
  return box + "</ul></div>\n";
}

std::string card_html(const Card& card) {
  const std::string_view word = word_for(card.tone);
  std::string html =
      fmt::format("<div class=\"card {}\"><div class=\"label\">{}{}</div><div class=\"value{}\">{}</div>",
                  class_of(card.tone), escape_markup(card.label), word.empty() ? "" : fmt::format(" · {}", word),
                  is_number(card.value) ? " headline" : "", escape_markup(card.value));
  if (!card.note.empty()) html += fmt::format("<div class=\"note\">{}</div>", escape_markup(card.note));
  return html + "</div>\n";
}

}  // namespace

HtmlReport::HtmlReport(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void HtmlReport::verdict(std::string_view sentence, Tone tone) {
  verdict_ = sentence;
  verdict_tone_ = tone;
}

void HtmlReport::card(Card card) {
  cards_.push_back(std::move(card));
}

void HtmlReport::warn(std::string_view text) {
  if (std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end()) warnings_.emplace_back(text);
}

void HtmlReport::provenance(Provenance provenance) {
  provenance_ = std::move(provenance);
}

void HtmlReport::section(std::string_view heading) {
  sections_.emplace_back(fmt::format("section-{}", sections_.size() + 1), heading);
  body_ += fmt::format("<h2 id=\"{}\">{}</h2>\n", sections_.back().first, escape_markup(heading));
}

void HtmlReport::paragraph(std::string_view text) {
  body_ += element("p", text);
}

void HtmlReport::bullets(const std::vector<std::string>& items) {
  body_ += "<ul>\n";
  for (const std::string& item : items) body_ += element("li", item);
  body_ += "</ul>\n";
}

void HtmlReport::preformatted(std::string_view text) {
  body_ += element("pre", text);
}

void HtmlReport::table(const Table& table) {
  for (std::size_t r = 0; r < table.rows.size(); ++r)
    if (table.rows[r].size() != table.columns.size())
      throw std::invalid_argument(fmt::format("report table: row {} has {} cells for {} columns", r,
                                              table.rows[r].size(), table.columns.size()));
  if (!table.row_tones.empty() && table.row_tones.size() != table.rows.size())
    throw std::invalid_argument(
        fmt::format("report table: {} tones for {} rows", table.row_tones.size(), table.rows.size()));
  const bool folded = table.rows.size() > most_open_rows;
  const std::string name = escape_markup_line(table.caption.empty() ? "Table" : table.caption);
  if (folded) body_ += fmt::format("<details>\n<summary>{}: {} rows</summary>\n", name, table.rows.size());
  const bool stacked = table.columns.size() >= least_stacked_columns;
  body_ += fmt::format("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\"><table{}>\n", name,
                       table.columns.size() >= least_wide_columns ? " class=\"wide stacked\""
                       : stacked                                  ? " class=\"stacked\""
                                                                  : "");
  if (!table.caption.empty()) body_ += element("caption", table.caption);
  body_ += "<thead><tr>";
  std::vector<std::vector<std::string>> padding;
  std::vector<std::string> labels;  // beside each cell, where rows are stacked
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string unit = pretty_unit(table.columns[c].unit);
    const std::string label = table.columns[c].heading + (unit.empty() ? "" : " (" + unit + ")");
    labels.push_back(stacked ? fmt::format(" data-label=\"{}\"", escape_markup_line(label)) : "");
    body_ += fmt::format("<th scope=\"col\"{}>{}{}</th>",
                         table.columns[c].kind == Column::Kind::number ? " class=\"number\"" : "",
                         escape_markup(table.columns[c].heading),
                         unit.empty() ? "" : fmt::format("<span class=\"unit\">{}</span>", escape_markup(unit)));
    padding.push_back(padding_of(table, c));
  }
  body_ += "</tr></thead>\n<tbody>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const Tone tone = table.row_tones.empty() ? Tone::neutral : table.row_tones[r];
    body_ += tone == Tone::neutral ? "<tr>" : fmt::format("<tr class=\"{}\">", class_of(tone));
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const std::string_view kind = cell_class(table.columns[c].kind, table.rows[r][c]);
      body_ += fmt::format("<td{}{}>{}{}</td>", kind, labels[c], cell_text(kind, table.rows[r][c]), padding[c][r]);
    }
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
  if (folded) body_ += "</details>\n";
}

void HtmlReport::figure(const Figure& figure, std::string_view caption) {
  const RenderedFigure drawn = render_figure(figure, fmt::format("figure-{}", figures_ + 1));
  if (!drawn.problem.empty()) warn("Figures could not be drawn: " + drawn.problem);
  add_figure(drawn, figure.title, caption);
}

void HtmlReport::drawing(std::string_view svg, std::string_view title, std::string_view caption) {
  add_figure({std::string(svg), "", ""}, title, caption);
}

void HtmlReport::add_figure(const RenderedFigure& drawn, std::string_view title, std::string_view caption) {
  body_ += fmt::format(
      "<figure>\n<div class=\"scroll\" id=\"drawn-{0}\" role=\"region\" tabindex=\"0\" aria-label=\"Figure {0}: "
      "{1}\"{4}>\n{2}</div>\n"
      "<figcaption><strong>Figure {0}.</strong> {3} <span class=\"size\" id=\"size-{0}\"><a class=\"large\" "
      "href=\"#drawn-{0}\">Enlarge</a><a class=\"whole\" href=\"#size-{0}\">Show it whole</a></span></figcaption>\n"
      "</figure>\n",
      ++figures_, escape_markup_line(title), drawn.svg, escape_markup(caption),
      drawn.points.empty() ? "" : fmt::format(" data-plot=\"{}\"", escape_markup_line(drawn.points)));
}

void HtmlReport::details(std::string_view summary, const std::function<void()>& content) {
  body_ += fmt::format("<details>\n<summary>{}</summary>\n", escape_markup(summary));
  content();
  body_ += "</details>\n";
}

std::string HtmlReport::html() const {
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n"
      "<style>{}{}</style>\n</head>\n<body>\n<main>\n<header>\n",
      escape_markup_line(title_), page_style, std::string(html_style) + series_variables());
  page += element("h1", title_);
  if (!subtitle_.empty()) page += fmt::format("<p class=\"subtitle\">{}</p>\n", escape_markup(subtitle_));
  if (sections_.size() > 2) {
    page += "<nav>";
    for (const auto& [id, heading] : sections_)
      page += fmt::format("<a href=\"#{}\">{}</a> ", id, escape_markup(heading));
    page += "</nav>\n";
  }
  page += "</header>\n";
  if (!verdict_.empty())
    page += fmt::format("<p class=\"verdict {}\">{}</p>\n", class_of(verdict_tone_), escape_markup(verdict_));
  if (!cards_.empty()) {
    page += "<div class=\"cards\">\n";
    for (const Card& card : cards_) page += card_html(card);
    page += "</div>\n";
  }
  page += warnings_box(warnings_);
  page += body_;
  page += "<footer>\n";
  if (!provenance_.command.empty()) page += "<p>Made by</p>\n" + element("pre", provenance_.command);
  if (!provenance_.version.empty()) page += element("p", "Program: " + provenance_.version);
  if (!provenance_.inputs.empty()) {
    page += "<ul>\n";
    for (const std::string& input : provenance_.inputs) page += element("li", input);
    page += "</ul>\n";
  }
  page += "</footer>\n</main>\n";
  if (figures_ > 0) page += fmt::format("<script>{}</script>\n", hover_script);
  return page + "</body>\n</html>\n";
}

}  // namespace secular::report
