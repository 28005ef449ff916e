#include "codegen/document/print_latex.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "codegen/document/derivation_document.hpp"
#include "codegen/document/latex_math.hpp"
#include "codegen/document/line_pieces.hpp"

namespace secular {
namespace typeset {
namespace {

constexpr std::string_view preamble = R"(\documentclass{article}
\usepackage{amsmath}
\usepackage{amssymb}
\setlength{\textwidth}{165mm}
\setlength{\textheight}{235mm}
\setlength{\oddsidemargin}{-3mm}
\setlength{\topmargin}{-15mm}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\setlength{\emergencystretch}{3em}
\allowdisplaybreaks
)";

constexpr double line_width = 44;          // em, of 165 mm at 10 pt
constexpr double continuation = 2;         // em, indent of a broken line
constexpr double widest_left = 20;         // em: a longer left side gets lines of its own
constexpr double widest_latex_piece = 38;  // em

// The right side on as few lines as fit, the first of them `first_width` wide.
std::vector<std::string> lines_of(const Expression& formula, double first_width, double width) {
  std::vector<std::string> lines{""};
  double free = first_width;
  bool first = true;
  for (const Piece& piece : line_pieces(formula, std::min(widest_latex_piece, width))) {
    if (!lines.back().empty() && piece.width > free) {
      lines.emplace_back("{}");
      free = width - continuation;
    }
    lines.back() += (lines.back().empty() ? "" : " ") + latex_math(piece, first);
    first = false;
    free -= piece.width;
  }
  return lines;
}

class LatexPrinter {
 public:
  std::string print(const Document& document) && {
    text_ = preamble;
    text_ += "\\title{" + latex_text(document.title) + "}\n\\author{}\n\\date{}\n\\begin{document}\n\\maketitle\n";
    for (const Block& block : document.blocks) std::visit([this](const auto& b) { print(b); }, block);
    return std::move(text_) + "\\end{document}\n";
  }

 private:
  void print(const Heading& heading) {
    text_ += heading.of_case ? "\n\\section{" : "\n\\subsection*{";
    text_ += latex_text(heading.text) + "}\n";
  }

  void print(const Paragraph& paragraph) {
    text_ += '\n';
    std::string line;
    for (const Run& run : paragraph.runs) line += std::visit([](const auto& r) { return run_latex(r); }, run);
    text_ += paragraph.tone == Paragraph::Tone::bad ? "\\textbf{" + line + "}\n" : line + "\n";
  }
  static std::string run_latex(const std::string& text) { return latex_text(text); }
  static std::string run_latex(const Expression& formula) { return "$" + latex_math(formula) + "$"; }
  static std::string run_latex(const Code& code) {
    std::string text;
    for (std::size_t begin = 0; begin < code.text.size();) {
      const std::size_t end = std::min(code.text.find_first_of("*+-/(),", begin), code.text.size() - 1) + 1;
      text += latex_text(std::string_view(code.text).substr(begin, end - begin)) + "\\allowbreak{}";
      begin = end;
    }
    return "\\texttt{" + text + "}";
  }

  void print(const EquationList& list) {
    if (list.equations.empty()) return;
    double left = 0;
    for (const Equation& equation : list.equations) {
      const double width = estimated_width(equation.left);
      if (width <= widest_left) left = std::max(left, width);
    }
    std::string rows;
    for (const Equation& equation : list.equations) {
      if (!rows.empty()) rows += " \\\\\n";
      const double width = line_width - left - 1.3;
      if (estimated_width(equation.left) <= widest_left) {
        rows += latex_math(equation.left) + " &= " + broken(lines_of(equation.right, width, width));
      } else {
        // Both sides from the left margin of the aligned column.
        rows += "&" + broken(lines_of(equation.left, width, width)) +
                " \\\\\n&\\quad = " + broken(lines_of(equation.right, width - continuation, width));
      }
    }
    text_ += "\\begin{align*}\n" + rows + "\n\\end{align*}\n";
  }

  static std::string broken(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : " \\\\\n&\\quad ") + line;
    return text;
  }

  void print(const Table& table) {
    if (table.rows.empty()) return;
    std::vector<double> widths(table.headings.size(), 0);
    for (std::size_t column = 0; column + 1 < table.headings.size(); ++column) {
      widths[column] = static_cast<double>(table.headings[column].size()) * 0.5;
      for (const std::vector<Expression>& row : table.rows)
        widths[column] = std::max(widths[column], estimated_width(row[column]));
    }
    double last = line_width;
    for (const double width : widths) last -= width + 1;
    std::string rows;
    std::string skipped;
    for (std::size_t column = 0; column < table.headings.size(); ++column) {
      rows += (column == 0 ? "&" : " \\quad&& ") + ("\\text{" + latex_text(table.headings[column]) + "}");
      skipped += column == 0 ? "&" : "&&";
    }
    for (const std::vector<Expression>& row : table.rows) {
      rows += " \\\\\n";
      for (std::size_t column = 0; column + 1 < row.size(); ++column)
        rows += (column == 0 ? "&" : " \\quad&& ") + latex_math(row[column]);
      rows += " \\quad&& ";
      bool first = true;
      for (const std::string& line : lines_of(row.back(), last, last)) {
        rows += (first ? "" : " \\\\\n" + skipped + "\\quad ") + line;
        first = false;
      }
    }
    text_ += "\\begin{alignat*}{" + std::to_string(table.headings.size()) + "}\n" + rows + "\n\\end{alignat*}\n";
  }

  std::string text_;
};

}  // namespace
}  // namespace typeset

std::string derivation_latex(const CanonicalModel& model) {
  return typeset::LatexPrinter().print(typeset::derivation_document(model));
}

}  // namespace secular
