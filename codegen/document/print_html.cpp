#include "codegen/document/print_html.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "codegen/document/derivation_document.hpp"
#include "codegen/document/line_pieces.hpp"
#include "codegen/document/mathml.hpp"
#include "input/markup.hpp"
#include "input/page_style.hpp"

namespace secular {
namespace typeset {
namespace {

// Beside page_style.
constexpr std::string_view style = R"css(
main { max-width: 960px; margin: 0 auto; padding: 40px 24px 56px; }
h1 { font-size: 28px; line-height: 1.2; margin: 0 0 12px; }
h2 { font-size: 21px; line-height: 1.3; margin: 48px 0 12px; padding-bottom: 6px;
  border-bottom: 1px solid var(--rule); }
h3 { font-size: 16px; margin: 28px 0 8px; }
p { margin: 10px 0; }
p.good { color: var(--good); }
p.bad { color: var(--bad); font-weight: 600; }
nav { margin: 18px 0; }
nav ul { margin: 4px 0; padding-left: 22px; }
a { color: var(--accent); text-decoration: none; }
code { font: 0.9em "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
math { font-family: "Latin Modern Math", "STIX Two Math", "Cambria Math", math; font-size: 1.12em; text-indent: 0; }
.word { font-style: italic; }
.verbatim { font-family: "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: 0.85em; }
.equation { padding-left: 3em; text-indent: -2em; overflow-x: auto; overflow-y: hidden;
  margin: 6px 0; }
.equation math, td math { margin: 0.22em 0; }
.scroll { overflow-x: auto; margin: 12px 0; }
table { border-collapse: collapse; }
th, td { padding: 7px 18px 7px 0; text-align: left; vertical-align: middle; border-bottom: 1px solid var(--rule); }
th { font-weight: 600; border-bottom-color: var(--ink); }
td { white-space: nowrap; }
td.long { white-space: normal; }
@media print {
  main { max-width: none; padding: 0; } h2, h3 { break-after: avoid; } tr { break-inside: avoid; } }
)css";

constexpr double widest_html_piece = 36;  // em: wider terms are opened up

std::string in_math(std::string_view content) {
  return fmt::format("<math displaystyle=\"true\">{}</math>", content);
}

// One <math> a piece: browsers break lines between them only.
std::string breakable(const Expression& formula, std::string_view before = {}) {
  std::string text;
  for (const Piece& piece : line_pieces(formula, widest_html_piece)) {
    const bool first = text.empty();
    text += first ? in_math(std::string(before) + mathml(piece, true)) : "\n" + in_math(mathml(piece, false));
  }
  return text;
}

class HtmlPrinter {
 public:
  std::string print(const Document& document) && {
    std::string contents;
    std::size_t cases = 0;
    for (const Block& block : document.blocks)
      if (const Heading* heading = std::get_if<Heading>(&block); heading != nullptr && heading->of_case)
        contents += fmt::format("<li><a href=\"#case-{}\">{}</a></li>\n", ++cases, escape_markup(heading->text));
    const std::string title = escape_markup(document.title);
    text_ =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
        title + "</title>\n<style>" + std::string(page_style) + std::string(style) +
        "</style>\n</head>\n<body>\n<main>\n<h1>" + title + "</h1>\n";
    if (cases > 0) text_ += "<nav>Cases\n<ul>\n" + contents + "</ul>\n</nav>\n";
    for (const Block& block : document.blocks) std::visit([this](const auto& b) { print(b); }, block);
    return std::move(text_) + "</main>\n</body>\n</html>\n";
  }

 private:
  void print(const Heading& heading) {
    const std::string text = escape_markup(heading.text);
    text_ += heading.of_case ? fmt::format("<h2 id=\"case-{}\">{}</h2>\n", ++cases_, text)
                             : fmt::format("<h3>{}</h3>\n", text);
  }

  void print(const Paragraph& paragraph) {
    text_ += paragraph.tone == Paragraph::Tone::good  ? "<p class=\"good\">"
             : paragraph.tone == Paragraph::Tone::bad ? "<p class=\"bad\">"
                                                      : "<p>";
    for (const Run& run : paragraph.runs) text_ += std::visit([](const auto& r) { return run_html(r); }, run);
    text_ += "</p>\n";
  }
  static std::string run_html(const std::string& text) { return escape_markup(text); }
  static std::string run_html(const Code& code) { return "<code>" + escape_markup(code.text) + "</code>"; }
  static std::string run_html(const Expression& formula) { return "<math>" + mathml(formula) + "</math>"; }

  void print(const EquationList& list) {
    for (const Equation& equation : list.equations)
      text_ += "<p class=\"equation\">" + breakable(equation.left) + "\n" +
               breakable(equation.right, "<mo form=\"infix\" lspace=\"0\">=</mo>") + "</p>\n";
  }

  void print(const Table& table) {
    text_ += "<div class=\"scroll\"><table>\n<thead><tr>";
    for (const std::string& heading : table.headings) text_ += "<th>" + escape_markup(heading) + "</th>";
    text_ += "</tr></thead>\n<tbody>\n";
    for (const std::vector<Expression>& row : table.rows) {
      text_ += "<tr>";
      for (std::size_t column = 0; column + 1 < row.size(); ++column)
        text_ += "<td>" + in_math(mathml(row[column])) + "</td>";
      text_ += "<td class=\"long\">" + breakable(row.back()) + "</td></tr>\n";
    }
    text_ += "</tbody>\n</table></div>\n";
  }

  std::string text_;
  std::size_t cases_ = 0;
};

}  // namespace
}  // namespace typeset

std::string derivation_html(const CanonicalModel& model) {
  return typeset::HtmlPrinter().print(typeset::derivation_document(model));
}

}  // namespace secular
