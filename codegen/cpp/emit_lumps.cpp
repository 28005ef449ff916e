// Lumps and their derivatives by the parameters.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "codegen/canonical/lump_gradient.hpp"
#include "codegen/cpp/emitter.hpp"

namespace secular {
namespace {

class LumpCode {
 public:
  explicit LumpCode(Emitter& emitter) : emitter_(emitter), model_(emitter.model), code_(emitter.code) {}

  void shared() {
    const std::vector<const CanonicalLump*> list = shared_lumps();
    for (std::size_t n = 0; n < list.size(); ++n) shared(*list[n], n);
  }

  void lumps(const CanonicalCase& c) {
    CppWriter writer(model_.order, "Scalar");
    const std::vector<const CanonicalLump*> shared = shared_lumps();
    std::vector<std::string> values;
    for (const CanonicalLump& lump : c.lumps)
      values.push_back(is_shared(lump)
                           ? fmt::format("lump_{}(parameters, static_cast<Scalar*>(nullptr))", number(shared, lump))
                           : writer.expression(lump.definition));
    code_.comment("Lumps: the parameter combinations that multiply data.");
    for (std::size_t l = 0; l < c.lumps.size(); ++l)
      if (!is_shared(c.lumps[l]))
        code_.comment(fmt::format("lumps[{}]: {} = {}", l, c.lumps[l].name,
                                  formula_text(c.lumps[l].definition, model_.order)));
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
    const std::vector<const CanonicalLump*> shared = shared_lumps();
    const std::size_t count = model_.parameters.size();
    std::vector<std::string> lines;
    for (std::size_t l = 0; l < c.lumps.size(); ++l) {
      if (is_shared(c.lumps[l])) {
        lines.push_back(fmt::format("lump_{}(parameters, jacobian + {});  // d {}", number(shared, c.lumps[l]),
                                    l * count, c.lumps[l].name));
        continue;
      }
      for (const LumpGradient::Entry& entry : lump_gradient(model_, c.lumps[l].definition).entries)
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
    code_.line(
        fmt::format("for (std::size_t i = 0; i < {}; ++i) jacobian[i] = Scalar(0.0);", c.lumps.size() * count));
    for (const std::string& row : lines) code_.line(row);
    code_.line("}").line();
  }

 private:
  static bool is_shared(const CanonicalLump& lump) {
    return !lump.definition.is_zero() && !lump.definition.numerator.back().divisors.empty();
  }

  // Those with divisors, each definition once, in the order of cases.
  std::vector<const CanonicalLump*> shared_lumps() const {
    std::vector<const CanonicalLump*> result;
    for (const CanonicalCase& c : model_.cases)
      for (const CanonicalLump& lump : c.lumps)
        if (is_shared(lump) && number(result, lump) == result.size()) result.push_back(&lump);
    return result;
  }
  static std::size_t number(const std::vector<const CanonicalLump*>& list, const CanonicalLump& lump) {
    return static_cast<std::size_t>(
        std::find_if(list.begin(), list.end(),
                     [&](const CanonicalLump* other) { return other->definition == lump.definition; }) -
        list.begin());
  }

  static std::string bracketed(const std::string& sum) {
    return sum.find(" + ") == std::string::npos && sum.find(" - ") == std::string::npos ? sum : "(" + sum + ")";
  }

  // Of several terms where a value at rest depends on the parameter, too.
  static std::string factor_code(const RationalFunction& rate, CppWriter& writer) {
    const std::string text = writer.expression(rate);
    return reads_as_sum(rate) ? "(" + text + ")" : text;
  }

  RationalFunction in_lowest_terms(const RationalFunction& value) const {
    return product(value, monomial(unit(0, 0), unit(0, 0)));
  }

  RationalFunction monomial(const std::vector<int>& above, const std::vector<int>& below) const {
    return {{{"1", above}}, {{"1", below}}};
  }

  // Of a lump with divisors: symbols that natural frequencies are or that divisors hold.
  std::vector<bool> frequencies(const RationalFunction& definition) const {
    std::vector<bool> result(model_.order.size(), false);
    std::fill_n(result.begin(), model_.natural_frequencies.size(), true);
    for (const PolynomialTerm& term : definition.numerator)
      for (const DivisorPower& divisor : term.divisors)
        for (const PolynomialTerm& one : *divisor.sum)
          for (std::size_t s = 0; s < result.size(); ++s) result[s] = result[s] || one.exponents[s] != 0;
    return result;
  }

  // By a coefficient: from the lump as sum of c_g * (coefficients).
  void by_coefficients(const RationalFunction& definition, const std::vector<bool>& frequency, CppWriter& writer,
                       std::vector<std::string>& lines) const {
    std::vector<bool> coefficient = frequency;
    coefficient.flip();
    const std::vector<PolynomialGroup> groups = grouped(definition.numerator, coefficient, false);
    const PolynomialTerm& below = definition.denominator.front();
    PolynomialTerm below_factor = below;
    std::vector<int> below_common = below.exponents;
    for (std::size_t s = 0; s < frequency.size(); ++s)
      (frequency[s] ? below_common : below_factor.exponents)[s] = 0;
    std::vector<std::string> sums(model_.parameters.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const RationalFunction common = monomial(groups[g].common, below_common);
      const LumpGradient gradient = lump_gradient(model_, common);
      if (gradient.entries.empty()) continue;
      lines.push_back(fmt::format("const Scalar c_{} = {};  // multiplies {}", g,
                                  writer.expression(in_lowest_terms({groups[g].rest, {below_factor}})),
                                  formula_text(common, model_.order)));
      for (const LumpGradient::Entry& entry : gradient.entries)
        add_to_sum(sums[entry.parameter],
                   (entry.rate.is_one() ? "" : factor_code(entry.rate, writer) + " * ") + fmt::format("c_{}", g));
    }
    for (std::size_t p = 0; p < sums.size(); ++p)
      if (!sums[p].empty())
        lines.push_back(fmt::format("gradient[{}] = {};  // by {}", p, sums[p], model_.parameters[p]));
  }

  // By a natural frequency w: from the lump as sum of the fractions f_g, each a number of coefficients times powers
  // of frequencies and divisors D, sum (power of w in f_g) f_g/w - sum dD/dw * q, q = sum (power of D) f_g/D.
  void by_frequencies(const RationalFunction& definition, const std::vector<bool>& frequency, CppWriter& writer,
                      std::vector<std::string>& fractions, std::vector<std::string>& lines) const {
    const std::vector<PolynomialGroup> groups = grouped(definition.numerator, frequency, true);
    const PolynomialTerm& below = definition.denominator.front();
    const std::size_t modes = model_.natural_frequencies.size();
    std::vector<std::string> by_power(modes);
    std::vector<std::string> by_divisor;
    std::string total;
    std::vector<std::shared_ptr<const std::vector<PolynomialTerm>>> divisors;
    const auto weighted = [](std::string& sum, int weight, std::size_t g) {
      const std::string size = std::abs(weight) == 1 ? "" : fmt::format("Scalar({}.0) * ", std::abs(weight));
      add_to_sum(sum, fmt::format("{}{}f_{}", weight < 0 ? "-" : "", size, g));
    };
    for (std::size_t g = 0; g < groups.size(); ++g) {
      RationalFunction value{groups[g].rest, {below}};
      for (PolynomialTerm& term : value.numerator) {
        for (std::size_t s = 0; s < frequency.size(); ++s) term.exponents[s] += groups[g].common[s];
        term.divisors = groups[g].divisors;
      }
      fractions.push_back(fmt::format("const Scalar f_{} = {};", g, writer.expression(in_lowest_terms(value))));
      add_to_sum(total, fmt::format("f_{}", g));
      for (std::size_t k = 0; k < modes; ++k)
        if (const int power = groups[g].common[k] - below.exponents[k]; power != 0) weighted(by_power[k], power, g);
      for (const auto& [sum, power] : groups[g].divisors) {
        const std::size_t number = writer.number_of(sum);
        if (by_divisor.size() <= number) {
          by_divisor.resize(number + 1);
          divisors.resize(number + 1);
        }
        divisors[number] = sum;
        weighted(by_divisor[number], power, g);
      }
    }
    fractions.push_back(fmt::format("const Scalar value = {};", total));
    fractions.emplace_back("if (gradient == nullptr) return value;");
    for (std::size_t d = 0; d < by_divisor.size(); ++d)
      if (!by_divisor[d].empty())
        lines.push_back(fmt::format("const Scalar q_{0} = {1} * per_{0};", d, bracketed(by_divisor[d])));
    for (std::size_t k = 0; k < modes; ++k) {
      std::string value;
      if (!by_power[k].empty()) {
        const std::string name = writer.expression(monomial(unit(k), unit(0, 0)));
        value = fmt::format("{} / {}", bracketed(by_power[k]), name);
      }
      for (std::size_t d = 0; d < divisors.size(); ++d)
        if (divisors[d]) subtract_rate(value, {*divisors[d], {{"1", unit(0, 0)}}}, k, d, writer);
      if (!value.empty())
        lines.push_back(fmt::format("gradient[{}] = {};  // by {}", k, value, model_.parameters[k]));
    }
  }

  // - dD/dw * q
  void subtract_rate(std::string& value, const RationalFunction& divisor, std::size_t symbol, std::size_t d,
                     CppWriter& writer) const {
    RationalFunction rate = derivative(divisor, symbol);
    if (rate.is_zero()) return;
    for (PolynomialTerm& term : rate.numerator)
      term.coefficient = term.coefficient.front() == '-' ? term.coefficient.substr(1) : "-" + term.coefficient;
    const std::string text = writer.expression(rate);
    const bool one = rate.is_constant() && (text == "Scalar(1.0)" || text == "-Scalar(1.0)");
    add_to_sum(value, one ? fmt::format("{}q_{}", text.front() == '-' ? "-" : "", d)
                          : fmt::format("{} * q_{}", reads_as_sum(rate) ? "(" + text + ")" : text, d));
  }

  // Powers: one of a symbol, or none.
  std::vector<int> unit(std::size_t symbol, int power = 1) const {
    std::vector<int> powers(model_.order.size(), 0);
    powers[symbol] = power;
    return powers;
  }

  // One lump with divisors and its derivatives, as a function of its own: compilers take very long over hundreds of
  // temporaries in one.
  void shared(const CanonicalLump& lump, std::size_t n) {
    CppWriter writer(model_.order, "Scalar");
    std::vector<std::string> fractions, lines;
    const std::vector<bool> frequency = frequencies(lump.definition);
    by_frequencies(lump.definition, frequency, writer, fractions, lines);
    by_coefficients(lump.definition, frequency, writer, lines);
    for (const LumpGradient::Entry& entry : lump_gradient(model_, lump.definition).entries)
      if (entry.symbol >= model_.natural_frequencies.size() && frequency[entry.symbol])
        lines.push_back(fmt::format("gradient[{}] = {};  // by {}", entry.parameter, writer.expression(entry.rate),
                                    model_.parameters[entry.parameter]));
    code_.comment(fmt::format("{} = {}", lump.name, formula_text(lump.definition, model_.order)));
    code_.comment(
        fmt::format("It is returned; gradient[p] = d/d parameters[p] where that is asked for. {} operations.",
                    writer.operations()));
    code_.line("template <class Scalar>");
    code_.line(fmt::format("Scalar lump_{}(const Scalar* parameters, Scalar* gradient) {{", n));
    emitter_.unpack(writer.used_symbols());
    emitter_.definitions(writer);
    for (const std::string& row : fractions) code_.line(row);
    for (const std::string& row : lines) code_.line(row);
    code_.line("return value;");
    code_.line("}").line();
  }

  Emitter& emitter_;
  const CanonicalModel& model_;
  CodeText& code_;
};

}  // namespace

void emit_shared_lumps(Emitter& emitter) {
  LumpCode(emitter).shared();
}

void emit_lumps(Emitter& emitter, const CanonicalCase& resonance) {
  LumpCode code(emitter);
  code.lumps(resonance);
  code.lumps_jacobian(resonance);
}

}  // namespace secular
