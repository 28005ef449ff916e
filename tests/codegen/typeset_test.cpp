// Derivations as LaTeX and as HTML with MathML: the formula layer, and the whole documents of the shipped models.
#include "codegen/document/typeset.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "codegen/canonical/generated_lump.hpp"
#include "codegen/document/latex_math.hpp"
#include "codegen/document/line_pieces.hpp"
#include "codegen/document/mathml.hpp"
#include "codegen/document/print_html.hpp"
#include "codegen/document/print_latex.hpp"
#include "codegen/document/print_text.hpp"
#include "codegen/document/symbol_name.hpp"
#include "perturb/model.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using namespace typeset;  // NOLINT: everything under test

using Formula = typeset::Expression;

const std::vector<std::string> shipped = {"pendulum", "two_mass_mode1"};

const CanonicalModel& shipped_canonical(const std::string& name) {
  static std::map<std::string, CanonicalModel> models;
  if (!models.count(name))
    models[name] = canonical_model(read_model(testing_support::source_folder() / "models" / (name + ".toml")));
  return models.at(name);
}

/// Two coupled modes, names that look alike, special characters, a fractional coefficient of the detuning, sums far
/// longer than a line.
const CanonicalModel& awkward_model() {
  static const CanonicalModel model = canonical_model(read_model_text(R"toml(schema = 1
name = "awkward_1"
source = "Schrödinger & Gauß, α <b> ~ ^ \\ $x_1$ {5} # 5 % “x”"
[[mode]]
coordinate = "u1"
frequency = "omega_0"
equation = "D2(u1) + omega_0^2*u1 = -2*mu_1*D(u1) + delta_1*u1*u2 + gam*u1*u2^2 + eta*F*cos(Omega*t)"
[[mode]]
coordinate = "u2"
frequency = "omega0"
equation = "D2(u2) + omega0^2*u2 = -2*mu_2*D(u2) + delta_2*u1^2 + beta2*u2^3"
[[case]]
name = "half"
relations = ["2*Omega = omega0 + eps^2*sigma2/3"]
order = { mu_1 = 1, mu_2 = 1, delta_1 = 1, delta_2 = 1, eta = 0, gam = 2, beta2 = 2 }
expand_to = 2
)toml",
                                                                      "awkward_1"));
  return model;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

/// Empty, or what is wrong: braces that do not match, environments that do not nest.
std::string latex_imbalance(const std::string& text) {
  std::vector<std::string> open;
  static const std::regex token(R"(\\(begin|end)\{([^}]*)\}|\\.|[{}])");
  for (std::sregex_iterator it(text.begin(), text.end(), token), end; it != end; ++it) {
    const std::string found = it->str(), kind = (*it)[1];
    if (kind == "begin" || found == "{") {
      open.push_back(kind == "begin" ? (*it)[2].str() : "{");
    } else if (kind == "end" || found == "}") {
      const std::string expected = kind == "end" ? (*it)[2].str() : "{";
      if (open.empty() || open.back() != expected) return "unmatched " + found;
      open.pop_back();
    }
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

/// Empty, or what is wrong: tags that do not nest, attributes or references that are none.
std::string xml_imbalance(const std::string& text) {
  std::vector<std::string> open;
  static const std::regex tag(R"re(<(/?)([A-Za-z][A-Za-z0-9]*)((?:\s+[a-z-]+="[^"<]*")*)\s*(/?)>)re");
  static const std::regex reference(R"(&(?:[a-z]+|#[0-9]+);)");
  for (std::size_t at = text.find_first_of("<&"); at != std::string::npos; at = text.find_first_of("<&", at)) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
    std::smatch match;
    if (!std::regex_search(begin, text.end(), match, text[at] == '&' ? reference : tag,
                           std::regex_constants::match_continuous))
      return "no tag or reference: " + text.substr(at, 40);
    at += static_cast<std::size_t>(match.length());
    if (match.str().front() == '&' || match[4].length() > 0) continue;
    if (match[1].length() == 0) {
      open.push_back(match[2]);
    } else {
      if (open.empty() || open.back() != match[2]) return "unmatched " + match.str();
      open.pop_back();
    }
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

struct NameCase {
  const char *identifier, *latex, *mathml;
};

TEST(Typeset, NamesOfSymbols) {
  const NameCase cases[] = {
      {"F", "F", "<mi>F</mi>"},
      {"omega0", "\\omega_{0}", "<msub><mi>ω</mi><mn>0</mn></msub>"},
      {"Omega", "\\Omega", "<mi>Ω</mi>"},
      {"mu12", "\\mu_{12}", "<msub><mi>μ</mi><mn>12</mn></msub>"},
      {"alpha_e", "\\alpha_{e}", "<msub><mi>α</mi><mi>e</mi></msub>"},
      {"Gamma_5", "\\Gamma_{5}", "<msub><mi>Γ</mi><mn>5</mn></msub>"},
      {"A_v1", "A_{v_{1}}", "<msub><mi>A</mi><msub><mi>v</mi><mn>1</mn></msub></msub>"},
      {"a_theta", "a_{\\theta}", "<msub><mi>a</mi><mi>θ</mi></msub>"},
      {"eps", "\\varepsilon", "<mi>ε</mi>"},
      {"pi", "\\pi", "<mi>π</mi>"},
      {"rate", "\\mathit{rate}", "<mi class=\"word\">rate</mi>"},
      {"fc2", "\\mathit{fc}_{2}", "<msub><mi class=\"word\">fc</mi><mn>2</mn></msub>"},
      {"alpha_long_2", "\\alpha_{\\mathrm{long},2}",
       "<msub><mi>α</mi><mrow><mi>long</mi><mo separator=\"true\">,</mo><mn>2</mn></mrow></msub>"},
      {"etafoo", "\\mathit{etafoo}", "<mi class=\"word\">etafoo</mi>"},
  };
  for (const NameCase& one : cases) {
    EXPECT_EQ(latex_symbol(one.identifier), one.latex);
    EXPECT_EQ(mathml(symbol(one.identifier)), one.mathml);
  }
}

TEST(Typeset, SignsAndFractionsOfCoefficients) {
  const SymbolOrder order = {"w", "b", "pi"};
  const RationalFunction negative{{{"-3", {1, 1, 0}}, {"5", {0, 2, 0}}}, {{"12", {0, 0, 1}}}};
  const RationalFunction polynomial{{{"-1", {2, 0, 0}}, {"1", {0, 1, 0}}}, {{"1", {0, 0, 0}}}};
  const RationalFunction four_over{{{"4", {0, 0, 0}}}, {{"1", {1, 0, 0}}}};
  const RationalFunction one{{{"1", {0, 0, 0}}}, {{"1", {0, 0, 0}}}};
  Product a;
  a.times(symbol("A"), 2);
  const auto text = [&](const Formula& formula) { return latex_math(formula); };
  EXPECT_EQ(text(expression_of(negative, order)), "-\\frac{3 w b - 5 b^{2}}{12 \\pi}");
  EXPECT_EQ(text(expression_of(polynomial, order)), "-w^{2} + b");
  EXPECT_EQ(text(Sum(order).add(one).add(polynomial, a).expression()), "1 - (w^{2} - b) A^{2}");
  EXPECT_EQ(text(Sum(order).add(four_over, a, true).expression()), "\\frac{4 \\mathrm{i}}{w} A^{2}");
  EXPECT_EQ(text(Sum(order).add(negative, a, true).expression()),
            "-\\mathrm{i} \\frac{3 w b - 5 b^{2}}{12 \\pi} A^{2}");
  EXPECT_EQ(text(Sum(order).add(one, Product().times(modulus(symbol("A")), -1)).expression()),
            "\\frac{1}{\\lvert A\\rvert }");
  EXPECT_EQ(text(Sum(order).expression()), "0");
  EXPECT_EQ(text(power(accent("bar", symbol("A_v")), 2)), "\\overline{A}_{v}^{2}");
  EXPECT_EQ(mathml(power(accent("bar", symbol("A_v")), 2)),
            "<msubsup><mover accent=\"true\"><mi>A</mi><mo stretchy=\"false\">¯</mo></mover><mi>v</mi><mn>2</mn>"
            "</msubsup>");
}

TEST(Typeset, LongFormulasAreOpenedUpWithoutLosingAnything) {
  Sum numerator({}), denominator({});
  for (int i = 0; i < 9; ++i) {
    numerator.add(symbol("alpha" + std::to_string(i)), i % 2 == 1);
    denominator.add(symbol("mu" + std::to_string(i)), false);
  }
  const Formula above = numerator.expression(), below = denominator.expression();
  const auto joined = [](const Formula& formula, double widest) {
    std::string text;
    for (const Piece& piece : line_pieces(formula, widest)) {
      EXPECT_LE(piece.width, widest + 4);
      text += (text.empty() ? "" : " ") + latex_math(piece, text.empty());
    }
    return text;
  };
  const Formula rest = symbol("A");
  const Formula wide = Product().times(fraction(above, symbol("b"))).times(rest).expression();
  EXPECT_EQ(joined(wide, 12), "\\frac{1}{b} \\bigl( " + latex_math(above) + "\\bigr) A");
  EXPECT_EQ(joined(wide, 100), latex_math(wide));
  const Formula deep = Product().times(fraction(symbol("b"), below)).times(rest).expression();
  EXPECT_EQ(joined(deep, 12), "b \\bigl( " + latex_math(below) + "\\bigr)^{-1} A");
  EXPECT_EQ(joined(fraction(above, below), 12),
            "\\bigl( " + latex_math(above) + "\\bigr) \\bigl( " + latex_math(below) + "\\bigr)^{-1}");
  EXPECT_EQ(joined(power(above, 2), 12), "\\bigl( " + latex_math(above) + "\\bigr)^{2}");
  // A numerator that fits, above a denominator that does not, keeps its brackets.
  const Formula two = Sum({}).add(symbol("x"), false).add(symbol("y"), false).expression();
  EXPECT_EQ(joined(fraction(two, below), 12), "(x + y) \\bigl( " + latex_math(below) + "\\bigr)^{-1}");
}

TEST(Typeset, TextIsEscaped) {
  EXPECT_EQ(latex_text("a_b & 5% of $x$ {#} ~^\\"),
            "a\\_b \\& 5\\% of \\$x\\$ \\{\\#\\} \\textasciitilde{}\\textasciicircum{}\\textbackslash{}");
  EXPECT_EQ(latex_text("Gauß α"), "Gauß [U+03B1]");
}

TEST(Typeset, LumpsThatTheDerivationNamedAreRecognised) {
  const CanonicalModel& model = shipped_canonical("two_mass_mode1");
  std::size_t found = 0;
  for (const CanonicalCase& c : model.cases)
    for (std::size_t i = 0; i < c.lumps.size(); ++i) {
      const std::string& name = c.lumps[i].name;
      const bool made_up = name.starts_with("harmonic_") || name.starts_with("conservative_");
      EXPECT_EQ(generated_lump(model, c, i).has_value(), made_up) << name;
      found += made_up;
    }
  EXPECT_GT(found, 3u);
}

TEST(Typeset, DetuningsKeepTheirFractions) {
  const CanonicalModel& model = awkward_model();
  EXPECT_NE(derivation_latex(model).find("2 \\Omega &= \\texttt{omega0} + \\frac{\\varepsilon^{2} \\sigma_{2}}{3}"),
            std::string::npos);
  EXPECT_NE(derivation_latex(model).find("\\frac{\\sigma_{2} t}{3} - \\beta_{u_{2}}"), std::string::npos);
  EXPECT_NE(derivation_text(model).find("sigma2*t/3-beta_u2"), std::string::npos);
}

TEST(Typeset, SymbolsThatWouldLookAlikeStandAsWritten) {
  const std::string page = derivation_html(awkward_model());
  EXPECT_NE(page.find("<mi class=\"verbatim\">omega_0</mi>"), std::string::npos);
  EXPECT_NE(page.find("<mi class=\"verbatim\">omega0</mi>"), std::string::npos);
  EXPECT_EQ(page.find("<msub><mi>ω</mi><mn>0</mn></msub>"), std::string::npos);
}

class TypesetDocument : public testing::TestWithParam<std::string> {
 protected:
  const CanonicalModel& model() const {
    return GetParam() == "awkward" ? awkward_model() : shipped_canonical(GetParam());
  }
};

TEST(Typeset, FunctionsOfCoordinatesAreWrittenAndSoAreTheirSeries) {
  const CanonicalModel model =
      canonical_model(read_model_text("schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = "
                                      "\"w\"\nequation = \"D2(x) + w^2*sin(x) = "
                                      "-g*(exp(b*x) - 1)^2/(1 + x^2) - g*x^2*(1 + x)^(-2/3)*sqrt(1 + x) - "
                                      "g*x*log(1 + x)*atan(x)^2\"\n[[case]]\nname = "
                                      "\"c\"\nordering = \"degree\"\nexpand_to = 3\nexcitation = false\n",
                                      "m"));
  const std::string latex = derivation_latex(model), html = derivation_html(model), text = derivation_text(model);
  EXPECT_EQ(latex_imbalance(latex), "");
  EXPECT_EQ(xml_imbalance(html.substr(html.find("<html"))), "");
  for (const char* const part :
       {"w^{2} \\sin(x)", "\\mathrm{e}^{2 b x}", "\\mathrm{e}^{\\frac{2}{3} \\ln(1 + x)}", "\\sqrt{1 + x}",
        "\\ln(1 + x) \\arctan^{2}(x)", "{1 + x^{2}}", "\\sin(x) &= x - \\frac{1}{6} x^{3}"})
    EXPECT_NE(latex.find(part), std::string::npos) << part << " in " << latex.substr(0, 3000);
  EXPECT_EQ(latex.find("}^{2 b x}^"), std::string::npos);
  for (const char* const part :
       {"w^2*sin(x)", "exp(b*x)^2", "(1 + x)^(-2/3)", "  sin(x) = x - 1/6*x^3 + terms of degree 4 and above\n",
        "  exp(b*x) = 1 + b*x + b^2/2*x^2 + b^3/6*x^3 + b^4/24*x^4 + terms of degree 5 and above\n"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text.substr(0, 1500);
}

TEST_P(TypesetDocument, LatexIsBalancedAndComplete) {
  const std::string text = derivation_latex(model());
  EXPECT_EQ(latex_imbalance(text), "");
  EXPECT_EQ(count(text, "\\section{"), model().cases.size());
  for (const char* part :
       {"Equations of motion", "Conventions", "Expansion", "Solvability", "Polar form", "Cartesian form",
        "Steady states", "Lumps", "Equations linear in the lumps", "Certificate"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  EXPECT_EQ(count(text, "\\left"), count(text, "\\right"));
  EXPECT_EQ(count(text, "\\biggl("), count(text, "\\biggr)"));
  EXPECT_EQ(count(text, "\\bigl("), count(text, "\\bigr)"));
}

TEST_P(TypesetDocument, HtmlIsWellFormedAndComplete) {
  std::string page = derivation_html(model());
  ASSERT_TRUE(page.starts_with("<!DOCTYPE html>\n"));
  page.erase(0, page.find('\n'));
  EXPECT_EQ(xml_imbalance(page), "");
  EXPECT_EQ(count(page, "<h2 "), model().cases.size());
  std::size_t harmonics = 0;
  for (const CanonicalCase& c : model().cases) {
    EXPECT_NE(page.find(">Case " + c.name + "</a>"), std::string::npos);
    for (const auto& terms : c.harmonics) harmonics += terms.size();
  }
  EXPECT_EQ(count(page, "<tr><td>"), harmonics);
  for (const char* foreign : {"<script", "src=", "http:", "https:", "@import", "url("})
    EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
}

TEST_P(TypesetDocument, TwoRunsGiveTheSameBytes) {
  EXPECT_EQ(derivation_latex(model()), derivation_latex(model()));
  EXPECT_EQ(derivation_html(model()), derivation_html(model()));
  if (GetParam() == "awkward") return;
  const CanonicalModel again =
      canonical_model(read_model(testing_support::source_folder() / "models" / (GetParam() + ".toml")));
  EXPECT_EQ(derivation_latex(model()), derivation_latex(again));
  EXPECT_EQ(derivation_html(model()), derivation_html(again));
}

TEST_P(TypesetDocument, PdflatexTakesItAndNothingLeavesThePage) {
  if (std::system("command -v pdflatex >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "pdflatex is not on the PATH: LaTeX output is checked for balance only";
  const fs::path folder = testing_support::process_folder() / ("secular_latex_" + GetParam());
  fs::create_directories(folder);
  std::ofstream(folder / "derivation.tex", std::ios::binary) << derivation_latex(model());
  const std::string command = "cd '" + folder.string() +
                              "' && pdflatex -interaction=nonstopmode -halt-on-error derivation.tex >run.txt 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << "see " << folder / "run.txt";
  std::ifstream stream(folder / "derivation.log", std::ios::binary);
  const std::string log{std::istreambuf_iterator<char>(stream), {}};
  static const std::regex overfull(R"(Overfull \\hbox \(([0-9.]+)pt too wide\))");
  for (std::sregex_iterator it(log.begin(), log.end(), overfull), end; it != end; ++it)
    EXPECT_LT(std::stod((*it)[1]), 40) << it->str();  // the margin is 70 pt
  if (!HasFailure()) fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Models, TypesetDocument, testing::Values("pendulum", "two_mass_mode1", "awkward"),
                         [](const auto& instance) { return instance.param; });

TEST(Typeset, TheChecksSeeWhatTheyForbid) {
  EXPECT_EQ(latex_imbalance("\\begin{align*} x^{2} \\{ \\end{align*}"), "");
  EXPECT_NE(latex_imbalance("\\begin{align*} x^{2 \\end{align*}"), "");
  EXPECT_NE(latex_imbalance("x^2}"), "");
  EXPECT_EQ(xml_imbalance("<a x=\"1\"><b/>&lt;</a>"), "");
  EXPECT_NE(xml_imbalance("<a><b></a></b>"), "");
  EXPECT_NE(xml_imbalance("<a>x < y</a>"), "");
  EXPECT_NE(xml_imbalance("<a>x & y</a>"), "");
}

}  // namespace
}  // namespace secular
