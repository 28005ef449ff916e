#include "codegen/document/derivation_document.hpp"

#include <fmt/format.h>

#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

#include "codegen/canonical/generated_lump.hpp"
#include "codegen/document/look_alikes.hpp"
#include "codegen/document/orders_text.hpp"
#include "codegen/document/rest_lines.hpp"
#include "codegen/document/steady_statements.hpp"
#include "codegen/document/typeset_equations.hpp"

namespace secular::typeset {
namespace {

class Writer {
 public:
  explicit Writer(const CanonicalModel& model) : model_(model) {}

  Document document() && {
    document_.title = "Model " + model_.name;
    introduction();
    for (const CanonicalCase& c : model_.cases) resonance(c);
    tell_look_alikes_apart(document_);
    return std::move(document_);
  }

 private:
  void section(std::string text) { document_.blocks.emplace_back(Heading{false, std::move(text)}); }
  void text(std::vector<Run> runs, Paragraph::Tone tone = Paragraph::Tone::plain) {
    document_.blocks.emplace_back(Paragraph{std::move(runs), tone});
  }
  void equations(std::vector<Equation> list) { document_.blocks.emplace_back(EquationList{std::move(list)}); }

  std::size_t modes() const { return model_.coordinates.size(); }
  template <typename Make>
  void equation_of_each_mode(const Make& make) {
    std::vector<Equation> list;
    for (std::size_t k = 0; k < modes(); ++k) list.push_back(make(k));
    equations(std::move(list));
  }
  template <typename Make>
  void equation_pair_of_each_mode(const Make& make) {
    std::vector<Equation> list;
    for (std::size_t k = 0; k < modes(); ++k) {
      std::pair<Equation, Equation> pair = make(k);
      list.push_back(std::move(pair.first));
      list.push_back(std::move(pair.second));
    }
    equations(std::move(list));
  }

  // v = A_v exp(i omega0 t) + cc.
  Expression first_harmonic(std::size_t mode) const {
    std::vector<int> own(model_.natural_frequencies.size() + model_.excitation_frequencies.size(), 0);
    own[mode] = 1;
    return Product().times(amplitude(model_, mode)).times(harmonic(model_, own)).expression();
  }

  void introduction() {
    if (!model_.source.empty()) text({"Source: " + model_.source});
    section("Equations of motion");
    equation_of_each_mode([&](std::size_t k) { return motion_equation(model_, k); });
    rest();
    section("Conventions");
    for (std::size_t k = 0; k < modes(); ++k)
      text({amplitude(model_, k), " is half the peak amplitude: the harmonic of ",
            symbol(model_.natural_frequencies[k]), " in ", symbol(model_.coordinates[k]), " is ", first_harmonic(k),
            " plus its conjugate, and no correction contains that harmonic."});
    for (std::size_t j = 0; j < model_.excitations.size(); ++j)
      text({symbol(model_.excitations[j]), " is the peak excitation at the frequency ",
            symbol(model_.excitation_frequencies[j]), "."});
    text({"Frequencies are in rad/s. An overline is the complex conjugate. ", symbol("eps"),
          " counts orders and is 1."});
  }

  void rest() {
    const std::vector<std::string> lines = rest_lines(model_);
    if (lines.empty()) return;
    section("Rest position");
    text({"Coordinates count from the rest position. With it and the natural frequencies the model as stated has"});
    for (const std::string& line : lines) document_.blocks.emplace_back(Paragraph{{Code{line}}});
  }

  void resonance(const CanonicalCase& c) {
    document_.blocks.emplace_back(Heading{true, "Case " + c.name});
    if (!c.relations.empty()) {
      text({c.relations.size() == 1 ? "Resonance relation:" : "Resonance relations:"});
      std::vector<Equation> relations;
      for (const CanonicalRelation& relation : c.relations)
        relations.push_back(relation_equation(model_, relation));
      equations(std::move(relations));
    }
    text({"Order of expansion: ", power(symbol("eps"), c.expand_to), c.excited ? "." : "; no excitation."});
    if (!c.chosen_orders.empty()) text({"Orders: " + orders_text(c) + "."});
    for (const std::string& warning : c.warnings) text({"Warning: " + warning}, Paragraph::Tone::bad);
    functions(c);
    expansion(c);
    modulation(c);
    if (!c.observed_frequency.empty()) {
      observed(c);
      steady(c);
      lumps(c);
    }
    certificate(c.certificate);
  }

  void functions(const CanonicalCase& c) {
    if (c.series.empty()) return;
    section("Functions");
    text(
        {"By their series about rest as far as this case needs them; what is left out is of higher degree. The "
         "equations of motion themselves keep the functions."});
    std::vector<Equation> list;
    for (const CanonicalSeries& series : c.series) list.push_back(series_equation(model_, series));
    equations(std::move(list));
  }

  void expansion(const CanonicalCase& c) {
    section("Expansion");
    for (std::size_t k = 0; k < modes(); ++k) {
      const Expression v = symbol(model_.coordinates[k]);
      if (c.harmonics[k].empty()) {
        text({v, " is ", first_harmonic(k), " plus its conjugate; there are no further harmonics."});
        continue;
      }
      text({v, " is the sum of ", first_harmonic(k),
            " and the harmonics below, each with its complex conjugate; a constant stands for itself."});
      Table table{{"Order", "Harmonic", "Coefficient"}, {}};
      for (const CanonicalTerm& term : c.harmonics[k])
        table.rows.push_back({power(symbol("eps"), term.order), harmonic(model_, term.powers.phase),
                              harmonic_coefficient(model_, term)});
      document_.blocks.emplace_back(std::move(table));
    }
  }

  void modulation(const CanonicalCase& c) {
    section("Solvability: complex modulation equations");
    text({"In true time, all orders together."});
    equation_of_each_mode([&](std::size_t k) { return complex_modulation(model_, c, k); });
    if (!c.quadratures.empty()) {
      text(
          {"Terms left to quadrature, to be added: angle brackets are the mean over the fast phases of the leading "
           "motion."});
      std::vector<Equation> list;
      for (const CanonicalQuadrature& quadrature : c.quadratures)
        list.push_back(quadrature_equation(model_, quadrature));
      equations(std::move(list));
    }
    section("Polar form");
    equation_of_each_mode([&](std::size_t k) {
      const Expression turn =
          exponential(Product().times(constant("i")).times(named("beta", model_, k)).expression());
      return Equation{
          amplitude(model_, k),
          Product().times(fraction(number(1), number(2))).times(named("a", model_, k)).times(turn).expression()};
    });
    equation_pair_of_each_mode([&](std::size_t k) { return polar_modulation(model_, c, k); });
  }

  void observed(const CanonicalCase& c) {
    section("Observed frequencies");
    text(
        {"In the frame that turns with these frequencies the equations for the amplitudes B do not "
         "depend on time."});
    equation_of_each_mode([&](std::size_t k) { return observed_frequency(model_, c, k); });
    equation_of_each_mode([&](std::size_t k) { return frame_amplitude(model_, c, k); });
    section("Cartesian form");
    equation_of_each_mode([&](std::size_t k) { return cartesian_amplitude(model_, k); });
    equation_pair_of_each_mode([&](std::size_t k) { return cartesian_modulation(model_, c, k); });
  }

  void steady(const CanonicalCase& c) {
    for (StatementSection& one : steady_sections(model_, c)) {
      section(std::move(one.heading));
      for (Statement& statement : one.statements) {
        if (std::string* first = std::get_if<std::string>(&statement.says.front()); first != nullptr)
          (*first)[0] = static_cast<char>(std::toupper(static_cast<unsigned char>((*first)[0])));
        text(std::move(statement.says));
        if (!statement.equations.empty()) equations(std::move(statement.equations));
      }
    }
  }

  void lumps(const CanonicalCase& c) {
    section("Lumps: what data near this resonance can see");
    std::vector<Equation> definitions;
    for (std::size_t i = 0; i < c.lumps.size(); ++i) definitions.push_back(lump_definition(model_, c, i));
    equations(std::move(definitions));
    for (std::size_t i = 0; i < c.lumps.size(); ++i)
      if (const std::optional<GeneratedLump> made_up = generated_lump(model_, c, i))
        text({lump_symbol(model_, c, i), " is ", Code{c.lumps[i].name},
              ": " + std::string(meaning(made_up->kind)) + " ", monomial(model_, made_up->powers),
              " in the equations of ", symbol(model_.coordinates[made_up->mode]), "."});
    section("Equations linear in the lumps");
    text(
        {"The rate is the logarithmic derivative of the observed fundamental harmonic; a hat marks the complex "
         "coefficient of the harmonic whose frequency stands behind it; what coincides in the observed frame is "
         "one "
         "harmonic."});
    std::vector<Equation> list;
    for (const CanonicalBlock& block : c.blocks) list.push_back(block_equation(model_, c, block));
    equations(std::move(list));
  }

  static std::string_view meaning(GeneratedLump::Kind kind) {
    switch (kind) {
      case GeneratedLump::Kind::conservative:
        return "the conservative (imaginary) coefficient of";
      case GeneratedLump::Kind::dissipative:
        return "the dissipative (real) coefficient of";
      case GeneratedLump::Kind::harmonic_real:
        return "the real part of the coefficient of";
      case GeneratedLump::Kind::harmonic_imaginary:
        break;
    }
    return "the imaginary part of the coefficient of";
  }

  void certificate(const CanonicalCertificate& c) {
    section("Certificate");
    if (c.holds)
      text({fmt::format("The certificate holds: put back into the original equation as a function of true time, {} "
                        "coefficients vanish exactly up to ",
                        c.coefficients_checked),
            power(symbol("eps"), c.order), "."},
           Paragraph::Tone::good);
    else
      text({fmt::format("The certificate DOES NOT HOLD: put back into the original equation as a function of true "
                        "time, {} coefficients were checked up to ",
                        c.coefficients_checked),
            power(symbol("eps"), c.order), "."},
           Paragraph::Tone::bad);
    if (c.nonsmooth_harmonics > 0)
      text(
          {fmt::format("Nonsmooth terms: Fourier integrals by quadrature up to harmonic {}, relative "
                       "difference at most {:.0e}.",
                       c.nonsmooth_harmonics, c.nonsmooth_error)});
    for (const std::string& remainder : c.remainders) text({"Left over: ", Code{remainder}}, Paragraph::Tone::bad);
  }

  const CanonicalModel& model_;
  Document document_;
};

}  // namespace

Document derivation_document(const CanonicalModel& model) {
  return Writer(model).document();
}

}  // namespace secular::typeset
