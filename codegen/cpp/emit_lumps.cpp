// Lumps and their derivatives by the parameters.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "codegen/canonical/lump_gradient.hpp"
#include "codegen/cpp/emitter.hpp"

namespace secular {
namespace {

class LumpCode {
 public:
  explicit LumpCode(Emitter& emitter) : emitter_(emitter), model_(emitter.model), code_(emitter.code) {}

  void lumps(const CanonicalCase& c) {
    CppWriter writer(model_.order, "Scalar");
    std::vector<std::string> values;
    for (const CanonicalLump& lump : c.lumps) values.push_back(writer.expression(lump.definition));
    code_.comment("Lumps: the parameter combinations that multiply data.");
    for (std::size_t l = 0; l < c.lumps.size(); ++l)
      code_.comment(
          fmt::format("lumps[{}]: {} = {}", l, c.lumps[l].name, formula_text(c.lumps[l].definition, model_.order)));
    code_.comment(fmt::format("{} operations.", writer.operations()));
    code_.line("template <class Scalar>");
    code_.line("void evaluate_lumps([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* lumps) {");
    emitter_.unpack(writer.used_symbols());
    emitter_.definitions(writer);
    for (std::size_t l = 0; l < values.size(); ++l)
      code_.line(fmt::format("lumps[{}] = {};  // {}", l, values[l], c.lumps[l].name));
    code_.line("}").line();
  }

  void lumps_jacobian(const CanonicalCase& c) {
    CppWriter writer(model_.order, "Scalar");
    const std::size_t count = model_.parameters.size();
    std::vector<std::string> lines;
    bool shares = false;
    for (std::size_t l = 0; l < c.lumps.size(); ++l) {
      const LumpGradient gradient = lump_gradient(model_, c.lumps[l].definition);
      if (gradient.shared) {
        shared_gradient(c.lumps[l], l, gradient);
        lines.push_back(fmt::format("lump_gradient_{0}(parameters, lumps[{0}], jacobian + {1});  // d {2}", l,
                                    l * count, c.lumps[l].name));
        shares = true;
        continue;
      }
      for (const LumpGradient::Entry& entry : gradient.entries)
        lines.push_back(fmt::format("jacobian[{}] = {};  // d {} / d {}", l * count + entry.parameter,
                                    writer.expression(entry.rate), c.lumps[l].name,
                                    model_.parameters[entry.parameter]));
    }
    code_.comment(fmt::format("jacobian[l * {} + p] = d lumps[l] / d parameters[p]. {} operations.", count,
                              writer.operations()));
    code_.line("template <class Scalar>");
    code_.line(
        "void evaluate_lumps_jacobian([[maybe_unused]] const Scalar* parameters, [[maybe_unused]] Scalar* "
        "jacobian) {");
    emitter_.unpack(writer.used_symbols());
    emitter_.definitions(writer);
    if (shares) {
      code_.line(fmt::format("Scalar lumps[{}];", c.lumps.size()));
      code_.line("evaluate_lumps(parameters, lumps);");
    }
    code_.line(
        fmt::format("for (std::size_t i = 0; i < {}; ++i) jacobian[i] = Scalar(0.0);", c.lumps.size() * count));
    for (const std::string& row : lines) code_.line(row);
    code_.line("}").line();
  }

 private:
  // A numerator N of many terms, for its derivatives: grouped by the monomials of the coefficients, whose factors
  // c_g hold the frequencies, and by the monomials of the frequencies, whose factors w_g hold the coefficients.
  // Every term of N is then written twice instead of once for every symbol in it.
  struct GroupedNumerator {
    std::vector<PolynomialGroup> by_coefficients, by_frequencies;
  };

  GroupedNumerator grouped_numerator(const RationalFunction& definition, CppWriter& writer,
                                     std::vector<std::string>& temporaries) const {
    std::vector<bool> frequency(model_.order.size(), false);
    std::fill_n(frequency.begin(), model_.natural_frequencies.size(), true);
    std::vector<bool> coefficient = frequency;
    coefficient.flip();
    GroupedNumerator result{grouped(definition.numerator, coefficient), grouped(definition.numerator, frequency)};
    const auto declare = [&](const char* letter, const std::vector<PolynomialGroup>& groups) {
      for (std::size_t g = 0; g < groups.size(); ++g) {
        // What multiplies 1 is in no derivative.
        if (groups[g].common == unity().front().exponents) continue;
        temporaries.push_back(fmt::format("const Scalar {}_{} = {};  // multiplies {}", letter, g,
                                          writer.expression({groups[g].rest, unity()}),
                                          formula_text({{{"1", groups[g].common}}, unity()}, model_.order)));
      }
    };
    declare("c", result.by_coefficients);
    declare("w", result.by_frequencies);
    return result;
  }

  std::vector<PolynomialTerm> unity() const { return {{"1", std::vector<int>(model_.order.size(), 0)}}; }

  // dN/dp from the groups.
  std::string grouped_derivative(const GroupedNumerator& numerator, std::size_t symbol, CppWriter& writer) const {
    const bool frequency = symbol < model_.natural_frequencies.size();
    const auto& groups = frequency ? numerator.by_frequencies : numerator.by_coefficients;
    std::string sum;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const RationalFunction rate = derivative(RationalFunction{{{"1", groups[g].common}}, unity()}, symbol);
      if (rate.is_zero()) continue;
      sum += fmt::format("{}{}{}_{}", sum.empty() ? "" : " + ",
                         rate.is_one() ? "" : writer.expression(rate) + " * ", frequency ? "w" : "c", g);
    }
    return sum;
  }

  // The derivatives of one lump N/D with a sum D, as a function of its own: compilers take very long over hundreds
  // of temporaries in one.
  void shared_gradient(const CanonicalLump& lump, std::size_t l, const LumpGradient& gradient) {
    constexpr std::size_t many_terms = 6;
    CppWriter writer(model_.order, "Scalar");
    std::vector<std::string> lines = {
        fmt::format("const Scalar denominator = {};", writer.expression(gradient.denominator))};
    std::optional<GroupedNumerator> numerator;
    if (lump.definition.numerator.size() > many_terms)
      numerator = grouped_numerator(lump.definition, writer, lines);
    for (const LumpGradient::Entry& entry : gradient.entries) {
      std::string value;
      if (!entry.rate.is_zero())
        value = numerator ? grouped_derivative(*numerator, entry.symbol, writer) : writer.expression(entry.rate);
      if (!entry.denominator_rate.is_zero())
        value +=
            fmt::format("{}lump * ({})", value.empty() ? "-" : " - ", writer.expression(entry.denominator_rate));
      lines.push_back(fmt::format("gradient[{}] = ({}) / denominator;  // by {}", entry.parameter, value,
                                  model_.parameters[entry.parameter]));
    }
    code_.comment(
        fmt::format("gradient[p] = d {} / d parameters[p] = (dN/dp - N/D dD/dp)/D of this lump N/D.", lump.name));
    if (numerator)
      code_.comment(
          "N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked, besides what has "
          "none of them.");
    code_.comment(fmt::format("{} operations.", writer.operations()));
    code_.line("template <class Scalar>");
    code_.line(fmt::format(
        "void lump_gradient_{}(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {{", l));
    emitter_.unpack(writer.used_symbols());
    emitter_.definitions(writer);
    for (const std::string& row : lines) code_.line(row);
    code_.line("}").line();
  }

  Emitter& emitter_;
  const CanonicalModel& model_;
  CodeText& code_;
};

}  // namespace

void emit_lumps(Emitter& emitter, const CanonicalCase& resonance) {
  LumpCode code(emitter);
  code.lumps(resonance);
  code.lumps_jacobian(resonance);
}

}  // namespace secular
