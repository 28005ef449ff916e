#include "report/html_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "input/markup.hpp"
#include "input/page_style.hpp"
#include "report/html_style.hpp"
#include "report/number_format.hpp"

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

}  // namespace

HtmlReport::HtmlReport(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

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
  const auto class_attribute = [&](std::size_t c) {
    return table.columns[c].kind == Column::Kind::number ? " class=\"number\"" : "";
  };
  body_ += "<div class=\"scroll\"><table>\n";
  if (!table.caption.empty()) body_ += element("caption", table.caption);
  body_ += "<thead><tr>";
  std::vector<std::vector<std::string>> padding;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string unit = pretty_unit(table.columns[c].unit);
    body_ +=
        fmt::format("<th scope=\"col\"{}>{}{}</th>", class_attribute(c), escape_markup(table.columns[c].heading),
                    unit.empty() ? "" : fmt::format("<span class=\"unit\">{}</span>", escape_markup(unit)));
    padding.push_back(padding_of(table, c));
  }
  body_ += "</tr></thead>\n<tbody>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const Tone tone = table.row_tones.empty() ? Tone::neutral : table.row_tones[r];
    body_ += tone == Tone::neutral ? "<tr>" : fmt::format("<tr class=\"{}\">", class_of(tone));
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      body_ += fmt::format("<td{}>{}{}</td>", class_attribute(c), escape_markup(table.rows[r][c]), padding[c][r]);
    body_ += "</tr>\n";
  }
  body_ += "</tbody></table></div>\n";
}

void HtmlReport::figure(const Figure& figure, std::string_view caption) {
  const int number = ++figures_;
  const RenderedFigure drawn = render_figure(figure, fmt::format("figure-{}", number));
  if (!drawn.problem.empty()) warn("Figures could not be drawn: " + drawn.problem);
  body_ += fmt::format("<figure>\n{}<figcaption><strong>Figure {}.</strong> {}</figcaption>\n</figure>\n",
                       drawn.svg, number, escape_markup(caption));
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
      escape_markup_line(title_), page_style, html_style);
  page += element("h1", title_);
  if (!subtitle_.empty()) page += fmt::format("<p class=\"subtitle\">{}</p>\n", escape_markup(subtitle_));
  if (sections_.size() > 2) {
    page += "<nav>";
    for (const auto& [id, heading] : sections_)
      page += fmt::format("<a href=\"#{}\">{}</a> ", id, escape_markup(heading));
    page += "</nav>\n";
  }
  page += "</header>\n";
  if (!cards_.empty()) {
    page += "<div class=\"cards\">\n";
    for (const Card& card : cards_) {
      const std::string_view word = word_for(card.tone);
      page += fmt::format("<div class=\"card {}\"><div class=\"label\">{}{}</div><div class=\"value\">{}</div>",
                          class_of(card.tone), escape_markup(card.label),
                          word.empty() ? "" : fmt::format(" · {}", word), escape_markup(card.value));
      if (!card.note.empty()) page += fmt::format("<div class=\"note\">{}</div>", escape_markup(card.note));
      page += "</div>\n";
    }
    page += "</div>\n";
  }
  if (!warnings_.empty()) {
    page += fmt::format("<div class=\"warnings\" role=\"note\"><strong>{}</strong>\n<ul>\n",
                        warnings_.size() == 1 ? "Warning" : fmt::format("{} warnings", warnings_.size()));
    for (const std::string& text : warnings_) page += element("li", text);
    page += "</ul></div>\n";
  }
  page += body_;
  page += "<footer>\n";
  if (!provenance_.command.empty()) page += "<p>Made by</p>\n" + element("pre", provenance_.command);
  if (!provenance_.version.empty()) page += element("p", "Program: " + provenance_.version);
  if (!provenance_.inputs.empty()) {
    page += "<ul>\n";
    for (const std::string& input : provenance_.inputs) page += element("li", input);
    page += "</ul>\n";
  }
  return page + "</footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace secular::report
