#include "codegen/emit_cpp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>

#include "codegen/amplitude_derivative.hpp"
#include "codegen/cpp_expression.hpp"
#include "codegen/lump_gradient.hpp"
#include "codegen/print_text.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

// Lines with indentation.
class CodeText {
 public:
  /// A line that is too long is broken before an operator; its trailing remark goes above it.
  CodeText& line(const std::string& text = {}) {
    if (text.empty()) {
      text_ += "\n";
      return *this;
    }
    if (text.front() == '}') --depth_;
    const std::string indent(static_cast<std::size_t>(2 * std::max(0, depth_)), ' ');
    std::string rest = text;
    const std::size_t remark = rest.find(";  // ");
    if (remark != std::string::npos && indent.size() + rest.size() > widest) {
      text_ += indent + rest.substr(remark + 3) + "\n";
      rest.resize(remark + 1);
    }
    std::string lead = indent;
    const bool breakable = rest.rfind("//", 0) != 0 && rest.find('"') == std::string::npos;
    while (breakable && lead.size() + rest.size() > widest) {
      const std::size_t room = widest - lead.size();
      std::size_t cut = std::max(position(rest.rfind(" + ", room)), position(rest.rfind(" - ", room)));
      if (cut == 0) cut = position(rest.rfind(" * ", room));
      if (cut == 0) break;
      text_ += lead + rest.substr(0, cut) + "\n";
      rest = rest.substr(cut + 1);
      lead = indent + "    ";
    }
    text_ += lead + rest + "\n";
    if (text.back() == '{') ++depth_;
    return *this;
  }
  /// A comment, broken at blanks.
  CodeText& comment(const std::string& text, const std::string& mark = "///") {
    std::istringstream words(text);
    std::string row;
    for (std::string word; words >> word;) {
      if (!row.empty() && row.size() + word.size() > 108) {
        line(mark + " " + row);
        row.clear();
      }
      row += (row.empty() ? "" : " ") + word;
    }
    return row.empty() ? *this : line(mark + " " + row);
  }
  const std::string& text() const { return text_; }

 private:
  static constexpr std::size_t widest = 118;
  static std::size_t position(std::size_t found) { return found == std::string::npos ? 0 : found; }
  std::string text_;
  int depth_ = 0;
};

// "a" and "-b" make "a - b".
void add_to_sum(std::string& sum, const std::string& addend) {
  if (sum.empty())
    sum = addend;
  else if (addend.front() == '-')
    sum += " - " + addend.substr(1);
  else
    sum += " + " + addend;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 0x20)
      result += ' ';
    else
      result += c;
  }
  return result + "\"";
}

// A comment must not be able to end itself or continue on the next line.
std::string commented(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == '\\') c = ' ';
  return text;
}

std::string times(const std::string& base, int power) {
  std::string text;
  for (int i = 0; i < power; ++i) text += (i ? " * " : "") + base;
  return text;
}

class ModelEmitter {
 public:
  explicit ModelEmitter(const CanonicalModel& model) : model_(model) {}

  GeneratedFile header() {
    banner();
    code_.line("#pragma once")
        .line()
        .line("#include <cmath>")
        .line("#include <complex>")
        .line("#include <cstddef>");
    code_.line("#include <numbers>").line().line("#include \"estimator/compiled_model.hpp\"");
    if (model_.coordinates.size() > 1) code_.line("#include \"estimator/dense_solve.hpp\"");
    code_.line("#include \"estimator/integer_power.hpp\"");
    code_.line().line(fmt::format("namespace secular::generated::{} {{", space(model_.name))).line();
    equations_of_motion();
    for (const CanonicalCase& c : model_.cases) resonance_case(c);
    code_.line(fmt::format("}}  // namespace secular::generated::{}", space(model_.name)));
    return {model_.name + ".hpp", undented(code_.text())};
  }

  GeneratedFile table() {
    code_ = {};
    banner();
    code_.line(fmt::format("#include \"generated/{}.hpp\"", model_.name)).line();
    code_.line("#include <limits>").line();
    code_.line(fmt::format("namespace secular::generated::{} {{", space(model_.name))).line("namespace {").line();
    tables();
    code_.line("}  // namespace").line();
    model_table();
    code_.line(fmt::format("}}  // namespace secular::generated::{}", space(model_.name)));
    return {model_.name + ".cpp", undented(code_.text())};
  }

 private:
  static std::string space(const std::string& name) { return safe_namespace(name); }
  static constexpr int indentation = 2;

  // Namespaces do not indent.
  static std::string undented(const std::string& text) {
    std::istringstream lines(text);
    std::string result;
    int spaces = 0;
    for (std::string row; std::getline(lines, row);) {
      const std::size_t begin = row.find_first_not_of(' ');
      const std::string body = begin == std::string::npos ? "" : row.substr(begin);
      if (body.rfind("}  // namespace", 0) == 0) {
        --spaces;
        result += body + "\n";
        continue;
      }
      const std::size_t shift = static_cast<std::size_t>(indentation * spaces);
      result += (row.size() >= shift ? row.substr(shift) : row) + "\n";
      if (body.rfind("namespace ", 0) == 0 && body.back() == '{') ++spaces;
    }
    return result;
  }

  void banner() {
    code_.comment(fmt::format("Model {}: generated code, never edited by hand.", model_.name), "//");
    if (!model_.source.empty()) code_.comment("Source: " + commented(model_.source), "//");
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k)
      code_.comment("Equation of motion: " + motion_text(model_, k), "//");
    for (const CanonicalCase& c : model_.cases) {
      std::string relations;
      for (const CanonicalRelation& relation : c.relations)
        relations += (relations.empty() ? "" : "; ") + commented(relation.text);
      code_.comment(
          fmt::format("Case {}: {}, multiple scales to eps^{}. Valid near that resonance for small amplitudes; "
                      "what is left out is of order eps^{}.",
                      c.name, relations.empty() ? (c.excited ? "no resonance" : "free vibration") : relations,
                      c.expand_to, c.expand_to + 1),
          "//");
    }
    code_.comment("Units: SI; frequencies in rad/s; amplitudes as in estimator/compiled_model.hpp.", "//");
    code_.comment("Made by: secular generate " + model_.name, "//");
  }

  void unpack(const std::vector<std::string>& names, const std::string& scalar = "Scalar",
              const std::string& attribute = "") {
    for (const std::string& name : names) {
      if (name == "pi") {
        code_.line(fmt::format("const {0} pi = std::numbers::pi_v<{0}>;", scalar));
        continue;
      }
      const auto parameter = std::find(model_.parameters.begin(), model_.parameters.end(), name);
      if (parameter == model_.parameters.end()) continue;
      code_.line(fmt::format("{}const {} {} = parameters[{}];", attribute, scalar, safe_identifier(name),
                             parameter - model_.parameters.begin()));
    }
  }

  void definitions(const CppWriter& writer) {
    for (const std::string& definition : writer.definitions()) code_.line(definition);
  }

  std::string parameter_list() const {
    std::string text;
    for (std::size_t i = 0; i < model_.parameters.size(); ++i)
      text += fmt::format("{}[{}] {}", i ? ", " : "", i, model_.parameters[i]);
    return text;
  }

  // ---- equations of motion ----
  // "displacement[0] - parameters[3]" for v - gap.
  std::string argument_code(const CanonicalFactor& f) const {
    std::string sum;
    for (const auto& [name, ratio] : f.argument) {
      std::string value;
      for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
        if (name == model_.coordinates[k]) value = fmt::format("displacement[{}]", k);
        if (name == "D(" + model_.coordinates[k] + ")") value = fmt::format("velocity[{}]", k);
      }
      for (std::size_t p = 0; p < model_.parameters.size() && value.empty(); ++p)
        if (name == model_.parameters[p]) value = fmt::format("parameters[{}]", p);
      if (value.empty()) value = "Scalar(1)";
      const bool one = std::abs(ratio.numerator) == 1 && ratio.denominator == 1;
      if (!one)
        value = fmt::format("Scalar({}) / Scalar({}) * {}", std::abs(ratio.numerator), ratio.denominator, value);
      sum += (ratio.numerator < 0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ")) + value;
    }
    return "(" + sum + ")";
  }

  std::string factor_code(const CanonicalFactor& f) const {
    const auto argument = [&](int derivative) {
      return f.argument.empty() ? fmt::format("{}[{}]", derivative == 0 ? "displacement" : "velocity", f.index)
                                : argument_code(f);
    };
    switch (f.kind) {
      case CanonicalFactor::Kind::displacement:
        return times(argument(0), f.power);
      case CanonicalFactor::Kind::velocity:
        return times(argument(1), f.power);
      case CanonicalFactor::Kind::acceleration:
        break;
      case CanonicalFactor::Kind::excitation: {
        static const char* const member[] = {"value", "first_derivative", "second_derivative"};
        return times(fmt::format("Scalar(excitation[{}].{})", f.index, member[f.derivative]), f.power);
      }
      case CanonicalFactor::Kind::absolute:
        return times(fmt::format("std::abs({})", argument(f.derivative)), f.power);
      case CanonicalFactor::Kind::sign: {
        const std::string x = argument(f.derivative);
        return fmt::format("(Scalar({0} > Scalar(0)) - Scalar({0} < Scalar(0)))", x);
      }
      case CanonicalFactor::Kind::clock_cos:
      case CanonicalFactor::Kind::clock_sin:
        break;
    }
    return {};
  }

  void equations_of_motion() {
    refuse_unsupported_motion(model_);
    const std::size_t modes = model_.coordinates.size();
    CppWriter writer(model_.order, "Scalar");
    std::vector<std::string> force(modes);
    std::vector<std::vector<std::string>> mass(modes, std::vector<std::string>(modes));
    for (std::size_t k = 0; k < modes; ++k)
      for (const CanonicalMotionTerm& term : model_.motion[k]) {
        std::string product = writer.expression(term.coefficient);
        const bool sum = term.coefficient.numerator.size() > 1 && term.coefficient.denominator_is_number();
        if (sum && !term.factors.empty()) product = "(" + product + ")";
        for (const CanonicalFactor& factor : term.factors) product += " * " + factor_code(factor);
        std::string& target = term.acceleration_of ? mass[k][*term.acceleration_of] : force[k];
        add_to_sum(target, product);
      }
    code_.comment("Accelerations of the full equations of motion, solved from the state-dependent mass matrix.");
    for (std::size_t k = 0; k < modes; ++k) code_.comment(motion_text(model_, k));
    code_.comment(fmt::format("parameters: {}. displacement, velocity, acceleration: {} values. {} operations.",
                              parameter_list(), modes, writer.operations()));
    code_.line("template <class Scalar>");
    code_.line("void accelerations(const Scalar* parameters, [[maybe_unused]] const ExcitationSample* excitation,");
    code_.line(
        "                   [[maybe_unused]] const Scalar* displacement, [[maybe_unused]] const Scalar* velocity,");
    code_.line("                   Scalar* acceleration) {");
    unpack(writer.used_symbols());
    definitions(writer);
    if (modes == 1) {
      code_.line(fmt::format("const Scalar mass = {};", mass[0][0]));
      code_.line(fmt::format("const Scalar force = {};", force[0].empty() ? "Scalar(0.0)" : force[0]));
      code_.line("acceleration[0] = -force / mass;");
    } else {
      code_.line(fmt::format("Scalar mass[{0} * {0}] = {{", modes));
      for (std::size_t k = 0; k < modes; ++k)
        for (std::size_t j = 0; j < modes; ++j) code_.line((mass[k][j].empty() ? "Scalar(0.0)" : mass[k][j]) + ",");
      code_.line("};");
      for (std::size_t k = 0; k < modes; ++k)
        code_.line(fmt::format("acceleration[{}] = -({});", k, force[k].empty() ? "Scalar(0.0)" : force[k]));
      code_.line(fmt::format("solve_in_place<{}>(mass, acceleration);", modes));
    }
    code_.line("}").line();
  }

  // ---- cases ----
  void resonance_case(const CanonicalCase& c) {
    refuse_unsupported(model_, c);
    code_.line(fmt::format("namespace {} {{", space(c.name))).line();
    lumps(c);
    lumps_jacobian(c);
    for (std::size_t b = 0; b < c.blocks.size(); ++b) block_columns(c, b);
    modulation(c);
    modulation_jacobian(c);
    code_.line(fmt::format("}}  // namespace {}", space(c.name))).line();
  }

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
    unpack(writer.used_symbols());
    definitions(writer);
    for (std::size_t l = 0; l < values.size(); ++l)
      code_.line(fmt::format("lumps[{}] = {};  // {}", l, values[l], c.lumps[l].name));
    code_.line("}").line();
  }

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
      for (std::size_t g = 0; g < groups.size(); ++g)
        temporaries.push_back(fmt::format("const Scalar {}_{} = {};  // multiplies {}", letter, g,
                                          writer.expression({groups[g].rest, unity()}),
                                          formula_text({{{"1", groups[g].common}}, unity()}, model_.order)));
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
      code_.comment("N = sum of c_g * (coefficients) = sum of w_g * (natural frequencies), as remarked.");
    code_.comment(fmt::format("{} operations.", writer.operations()));
    code_.line("template <class Scalar>");
    code_.line(fmt::format(
        "void lump_gradient_{}(const Scalar* parameters, [[maybe_unused]] Scalar lump, Scalar* gradient) {{", l));
    unpack(writer.used_symbols());
    definitions(writer);
    for (const std::string& row : lines) code_.line(row);
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
    unpack(writer.used_symbols());
    definitions(writer);
    if (shares) {
      code_.line(fmt::format("Scalar lumps[{}];", c.lumps.size()));
      code_.line("evaluate_lumps(parameters, lumps);");
    }
    code_.line(
        fmt::format("for (std::size_t i = 0; i < {}; ++i) jacobian[i] = Scalar(0.0);", c.lumps.size() * count));
    for (const std::string& row : lines) code_.line(row);
    code_.line("}").line();
  }

  // Names of the local values a monomial is made of, collected for declaration.
  struct Used {
    std::set<std::size_t> amplitude, norm, modulus, inverse_modulus, unit, conjugate, forcing, forcing_norm,
        forcing_conjugate;
  };

  std::string monomial(const CanonicalPowers& powers, Used& used, int& complex_products) const {
    std::vector<std::string> factors;
    const auto add = [&](const std::string& name, int power) {
      if (power > 3)
        factors.push_back(fmt::format("integer_power({}, {})", name, power));
      else
        for (int i = 0; i < power; ++i) factors.push_back(name);
    };
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
      const std::string name = "A_" + model_.coordinates[k];
      const int pairs = std::min(powers.amplitude[k], powers.conjugate[k]);
      // A/|A| is a direction of length one: safe at zero, exact in any power.
      const int turned = powers.amplitude[k] - pairs, returned = powers.conjugate[k] - pairs;
      const int directions = std::min(std::max(turned, returned), std::max(0, -powers.modulus[k]));
      const int forward = turned > returned ? turned - directions : 0;
      const int backward = returned > turned ? returned - directions : 0;
      const int modulus = powers.modulus[k] + directions;
      if (forward) used.amplitude.insert(k);
      if (backward) used.conjugate.insert(k);
      if (pairs) used.norm.insert(k);
      if (modulus > 0) used.modulus.insert(k);
      if (modulus < 0) used.inverse_modulus.insert(k);
      if (directions) used.unit.insert(k);
      add("norm_" + name, pairs);
      add("abs_" + name, std::max(0, modulus));
      add("inverse_abs_" + name, std::max(0, -modulus));
      add(turned > returned ? "unit_" + name : "std::conj(unit_" + name + ")", directions);
      add(name, forward);
      add("conj_" + name, backward);
    }
    for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
      const std::string name = safe_identifier(model_.excitations[j]);
      const int net = powers.phase[model_.coordinates.size() + j], total = powers.forcing[j];
      const int pairs = (total - std::abs(net)) / 2;
      if (pairs) used.forcing_norm.insert(j);
      if (net > 0) used.forcing.insert(j);
      if (net < 0) used.forcing_conjugate.insert(j);
      add("norm_" + name, pairs);
      add(net > 0 ? name : "conj_" + name, std::abs(net));
    }
    complex_products += std::max(0, static_cast<int>(factors.size()) - 1);
    return factors.empty() ? "Complex(Scalar(1.0))" : fmt::format("{}", fmt::join(factors, " * "));
  }

  void declare_data(const Used& used, const std::string& index, bool complex_batch) {
    const auto amplitude = [&](std::size_t k) {
      return complex_batch ? fmt::format("data.amplitude[{}][{}]", k, index) : fmt::format("amplitude[{}]", k);
    };
    const auto forcing = [&](std::size_t j) {
      return complex_batch ? fmt::format("data.forcing[{}][{}]", j, index) : fmt::format("forcing[{}]", j);
    };
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
      const std::string name = "A_" + model_.coordinates[k];
      const bool any = used.amplitude.count(k) || used.norm.count(k) || used.modulus.count(k) ||
                       used.inverse_modulus.count(k) || used.unit.count(k) || used.conjugate.count(k);
      if (!any) continue;
      code_.line(fmt::format("const Complex {} = {};", name, amplitude(k)));
      if (used.conjugate.count(k)) code_.line(fmt::format("const Complex conj_{0} = std::conj({0});", name));
      if (used.norm.count(k)) code_.line(fmt::format("const Scalar norm_{0} = std::norm({0});", name));
      if (used.modulus.count(k) || used.inverse_modulus.count(k) || used.unit.count(k))
        code_.line(fmt::format("const Scalar abs_{0} = std::abs({0});", name));
      if (used.unit.count(k))
        code_.line(fmt::format("const Complex unit_{0} = abs_{0} > Scalar(0) ? {0} / abs_{0} : Complex();", name));
      if (used.inverse_modulus.count(k))
        code_.line(fmt::format(
            "const Scalar inverse_abs_{0} = abs_{0} > Scalar(0) ? Scalar(1) / abs_{0} : Scalar(0);", name));
    }
    for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
      const std::string name = safe_identifier(model_.excitations[j]);
      if (!used.forcing.count(j) && !used.forcing_norm.count(j) && !used.forcing_conjugate.count(j)) continue;
      code_.line(fmt::format("const Complex {} = {};", name, forcing(j)));
      if (used.forcing_conjugate.count(j))
        code_.line(fmt::format("const Complex conj_{0} = std::conj({0});", name));
      if (used.forcing_norm.count(j)) code_.line(fmt::format("const Scalar norm_{0} = std::norm({0});", name));
    }
  }

  bool uses_excitation_frequency(const RationalFunction& f) const {
    const std::size_t modes = model_.coordinates.size();
    for (const auto* part : {&f.numerator, &f.denominator})
      for (const PolynomialTerm& term : *part)
        for (std::size_t j = 0; j < model_.excitations.size(); ++j)
          if (term.exponents[modes + j] != 0) return true;
    return false;
  }

  static std::string rotated(const std::string& product, bool imaginary) {
    return imaginary ? "Complex(Scalar(0), Scalar(1)) * " + product : product;
  }

  void block_columns(const CanonicalCase& c, std::size_t b) {
    const CanonicalBlock& block = c.blocks[b];
    CppWriter before(model_.order, "Scalar"), inside(model_.order, "Scalar");
    Used used;
    int complex_products = 0, complex_sums = 0;
    std::vector<std::string> constants, inner, assignments;
    for (std::size_t j = 0; j < block.columns.size(); ++j) {
      std::string sum;
      for (std::size_t t = 0; t < block.columns[j].terms.size(); ++t) {
        const CanonicalColumnTerm& term = block.columns[j].terms[t];
        const std::string name = fmt::format("factor_{}_{}", j, t);
        const bool varies = uses_excitation_frequency(term.factor);
        (varies ? inner : constants)
            .push_back(
                fmt::format("const Scalar {} = {};", name, (varies ? inside : before).expression(term.factor)));
        const std::string product =
            rotated(name + " * (" + monomial(term.powers, used, complex_products) + ")", term.imaginary);
        ++complex_products;
        if (!sum.empty()) ++complex_sums;
        sum += (sum.empty() ? "" : " + ") + product;
      }
      assignments.push_back(
          fmt::format("columns[{}][i] = {};  // {}", j, sum, c.lumps[block.columns[j].lump].name));
    }
    code_.comment(fmt::format("Regressor rows of the {}: target = sum of columns[j][i] * lump_j.", block.name));
    code_.comment(equation_text(model_, c, block));
    code_.comment(fmt::format("{} columns; per observation {} complex products, {} complex sums.",
                              block.columns.size(), complex_products, complex_sums));
    code_.line(fmt::format(
        "inline void columns_{}(const ObservationBatch& data, std::complex<double>* const* columns) {{", b));
    code_.line("using Scalar = double;").line("using Complex = std::complex<double>;");
    std::set<std::string> outer_symbols, inner_symbols;
    for (const std::string& name : before.used_symbols()) outer_symbols.insert(name);
    for (const std::string& name : inside.used_symbols()) inner_symbols.insert(name);
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
      const std::string& name = model_.natural_frequencies[k];
      if (outer_symbols.count(name) || inner_symbols.count(name))
        code_.line(fmt::format("const Scalar {} = data.natural_frequency[{}];", safe_identifier(name), k));
    }
    if (outer_symbols.count("pi") || inner_symbols.count("pi")) code_.line("const Scalar pi = std::numbers::pi;");
    definitions(before);
    for (const std::string& constant : constants) code_.line(constant);
    code_.line("for (std::size_t i = 0; i < data.count; ++i) {");
    declare_data(used, "i", true);
    for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
      const std::string& name = model_.excitation_frequencies[j];
      if (inner_symbols.count(name))
        code_.line(fmt::format("const Scalar {} = data.excitation_frequency[{}][i];", safe_identifier(name), j));
    }
    std::set<std::string> known;
    for (const std::string& definition : before.definitions()) known.insert(definition);
    for (const std::string& definition : inside.definitions())
      if (!known.count(definition)) code_.line(definition);
    for (const std::string& constant : inner) code_.line(constant);
    for (const std::string& assignment : assignments) code_.line(assignment);
    code_.line("}").line("}").line();
  }

  // w_k - omega_k: the frame turns with w_k instead of omega_k.
  std::string rotation_code(const CanonicalCase& c, std::size_t k) const {
    std::string rotation;
    for (std::size_t i = 0; i < c.observed_frequency[k].size(); ++i) {
      CanonicalRatio r = c.observed_frequency[k][i];
      if (i == k) r.numerator -= r.denominator;
      if (r.numerator == 0) continue;
      const bool natural = i < model_.natural_frequencies.size();
      rotation +=
          (rotation.empty() ? "" : " + ") +
          fmt::format("Scalar({}.0) / Scalar({}.0) * {}", r.numerator, r.denominator,
                      natural ? safe_identifier(model_.natural_frequencies[i])
                              : fmt::format("excitation_frequency[{}]", i - model_.natural_frequencies.size()));
    }
    return rotation;
  }

  // Sum of the terms of dB_mode/dt, derived by B_along or its conjugate: "lumps[0] * -1.0 * (...) + ...".
  std::string derived_terms(const CanonicalCase& c, std::size_t mode, std::size_t along, bool by_conjugate,
                            CppWriter& writer, Used& used) const {
    std::string sum;
    int products = 0;
    for (const CanonicalBlock& block : c.blocks) {
      if (!block.modulation || block.mode != mode) continue;
      for (const CanonicalBlock::Column& column : block.columns)
        for (const CanonicalColumnTerm& term : column.terms) {
          const auto derived = amplitude_derivative(term.powers, along, by_conjugate);
          if (!derived) continue;
          std::string factor = writer.expression(term.factor);
          if (term.factor.numerator.size() > 1) factor = "(" + factor + ")";
          if (derived->weight.denominator != 1 || derived->weight.numerator != 1)
            factor += fmt::format(" * Scalar({})",
                                  static_cast<double>(derived->weight.numerator) / derived->weight.denominator);
          const std::string product =
              fmt::format("lumps[{}] * {} * ({})", column.lump, factor, monomial(derived->powers, used, products));
          sum += (sum.empty() ? "" : "\n + ") + rotated("(" + product + ")", term.imaginary);
        }
    }
    return sum;
  }

  void declare_modulation(const std::string& name, const std::string& result) {
    code_.line("template <class Scalar>");
    code_.line(fmt::format("void {}(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,",
                           name));
    code_.line("    [[maybe_unused]] const std::complex<Scalar>* amplitude,");
    code_.line(fmt::format("    [[maybe_unused]] const std::complex<Scalar>* forcing, {}) {{", result));
    code_.line("using Complex = std::complex<Scalar>;");
  }

  // One statement that may run over several lines.
  void statement(const std::string& text) {
    std::istringstream rows(text);
    bool first = true;
    for (std::string row; std::getline(rows, row); first = false) code_.line((first ? "" : "    ") + row);
  }

  void modulation_jacobian(const CanonicalCase& c) {
    const std::size_t modes = model_.coordinates.size();
    CppWriter writer(model_.order, "Scalar");
    Used used;
    struct Entry {
      std::size_t mode, along;
      std::string by_amplitude, by_conjugate;
    };
    std::vector<Entry> entries;
    bool rotates = false;
    for (std::size_t k = 0; k < modes; ++k)
      for (std::size_t j = 0; j < modes; ++j) {
        if (c.mode_at_rest[k] || c.mode_at_rest[j]) continue;
        Entry entry{k, j, derived_terms(c, k, j, false, writer, used), derived_terms(c, k, j, true, writer, used)};
        const std::string rotation = j == k ? rotation_code(c, k) : "";
        if (!rotation.empty())
          entry.by_amplitude +=
              (entry.by_amplitude.empty() ? "-" : "\n - ") + ("Complex(Scalar(0), " + rotation + ")");
        rotates = rotates || !rotation.empty();
        if (!entry.by_amplitude.empty() || !entry.by_conjugate.empty()) entries.push_back(std::move(entry));
      }
    code_.comment(fmt::format(
        "jacobian[i * {} + j] = d f_i / d z_j of dz/dt = f(z), z = (Re B_0, Im B_0, Re B_1, ...): what "
        "`modulation` computes, in Cartesian amplitudes. With f = dB_k/dt as a function of B_j and conj(B_j), "
        "d/dRe(B_j) = d/dB_j + d/dconj(B_j) and d/dIm(B_j) = i*(d/dB_j - d/dconj(B_j)). Regular at zero "
        "amplitude; a term that has no derivative there counts as zero.",
        2 * modes));
    declare_modulation("modulation_jacobian", "Scalar* jacobian");
    std::vector<std::string> symbols = writer.used_symbols();
    for (const std::string& name : model_.natural_frequencies)
      if (rotates && std::find(symbols.begin(), symbols.end(), name) == symbols.end()) symbols.push_back(name);
    unpack(symbols, "Scalar", "[[maybe_unused]] ");
    definitions(writer);
    code_.line(fmt::format("Scalar lumps[{}];", std::max<std::size_t>(1, c.lumps.size())));
    code_.line("evaluate_lumps(parameters, lumps);");
    declare_data(used, "", false);
    code_.line(fmt::format("for (std::size_t i = 0; i < {}; ++i) jacobian[i] = Scalar(0.0);", 4 * modes * modes));
    for (const Entry& entry : entries) {
      const std::string name = fmt::format("by_{}_{}", entry.mode, entry.along);
      statement(fmt::format("const Complex {} = {};", name,
                            entry.by_amplitude.empty() ? "Complex()" : entry.by_amplitude));
      statement(fmt::format("const Complex conj_{} = {};", name,
                            entry.by_conjugate.empty() ? "Complex()" : entry.by_conjugate));
      const std::size_t row = 4 * modes * entry.mode + 2 * entry.along, next = row + 2 * modes;
      code_.line(fmt::format("jacobian[{}] = {}.real() + conj_{}.real();", row, name, name));
      code_.line(fmt::format("jacobian[{}] = conj_{}.imag() - {}.imag();", row + 1, name, name));
      code_.line(fmt::format("jacobian[{}] = {}.imag() + conj_{}.imag();", next, name, name));
      code_.line(fmt::format("jacobian[{}] = {}.real() - conj_{}.real();", next + 1, name, name));
    }
    code_.line("}").line();
  }

  void modulation(const CanonicalCase& c) {
    code_.comment(
        "dB/dt of every mode in the frame that rotates with its observed frequency; zero at a steady state.");
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k) code_.comment(modulation_text(model_, c, k));
    CppWriter writer(model_.order, "Scalar");
    Used used;
    int complex_products = 0;
    std::vector<std::string> sums(model_.coordinates.size());
    for (const CanonicalBlock& block : c.blocks) {
      if (!block.modulation) continue;
      for (const CanonicalBlock::Column& column : block.columns)
        for (const CanonicalColumnTerm& term : column.terms) {
          std::string factor = writer.expression(term.factor);
          if (term.factor.numerator.size() > 1) factor = "(" + factor + ")";
          const std::string product = fmt::format("lumps[{}] * {} * ({})", column.lump, factor,
                                                  monomial(term.powers, used, complex_products));
          sums[block.mode] +=
              (sums[block.mode].empty() ? "" : "\n + ") + rotated("(" + product + ")", term.imaginary);
        }
    }
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k) used.amplitude.insert(k);
    code_.line("template <class Scalar>");
    code_.line("void modulation(const Scalar* parameters, [[maybe_unused]] const Scalar* excitation_frequency,");
    code_.line("                const std::complex<Scalar>* amplitude,");
    code_.line(
        "                [[maybe_unused]] const std::complex<Scalar>* forcing, std::complex<Scalar>* derivative) "
        "{");
    code_.line("using Complex = std::complex<Scalar>;");
    std::vector<std::string> symbols = writer.used_symbols();
    for (const std::string& name : model_.natural_frequencies)
      if (std::find(symbols.begin(), symbols.end(), name) == symbols.end()) symbols.push_back(name);
    unpack(symbols);
    definitions(writer);
    code_.line(fmt::format("Scalar lumps[{}];", std::max<std::size_t>(1, c.lumps.size())));
    code_.line("evaluate_lumps(parameters, lumps);");
    declare_data(used, "", false);
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
      if (c.mode_at_rest[k]) {
        code_.line(fmt::format("derivative[{}] = Complex();", k));
        continue;
      }
      const std::string rotation = rotation_code(c, k);
      std::string value = sums[k].empty() ? "Complex()" : sums[k];
      if (!rotation.empty())
        value += fmt::format("\n - Complex(Scalar(0), {}) * A_{}", rotation, model_.coordinates[k]);
      std::istringstream rows(fmt::format("derivative[{}] = {};", k, value));
      bool first = true;
      for (std::string row; std::getline(rows, row); first = false) code_.line((first ? "" : "    ") + row);
    }
    code_.line("}").line();
  }

  // ---- tables ----
  std::string ratios(const std::vector<CanonicalRatio>& values) const {
    std::string text;
    for (const CanonicalRatio& r : values)
      text += (text.empty() ? "" : ", ") + fmt::format("{{{}, {}}}", r.numerator, r.denominator);
    return text;
  }

  std::string dimension_table(const std::string& name, const CanonicalDimension& dimension) {
    if (!dimension) return "{}";
    code_.line(fmt::format("constexpr Ratio {}[] = {{{}}};", name, ratios(*dimension)));
    return name;
  }

  template <class Values, class Text>
  static std::string listed(const Values& values, Text text) {
    std::string result;
    for (const auto& value : values) result += (result.empty() ? "" : ", ") + text(value);
    return result;
  }

  void tables() {
    const auto as_text = [](const std::string& s) { return quoted(s); };
    code_.line(
        fmt::format("constexpr std::string_view coordinates[] = {{{}}};", listed(model_.coordinates, as_text)));
    if (!model_.excitations.empty()) {
      code_.line(
          fmt::format("constexpr std::string_view excitations[] = {{{}}};", listed(model_.excitations, as_text)));
      code_.line(fmt::format("constexpr std::string_view excitation_frequencies[] = {{{}}};",
                             listed(model_.excitation_frequencies, as_text)));
    }
    std::vector<std::string> symbol_rows;
    for (std::size_t p = 0; p < model_.parameters.size(); ++p)
      symbol_rows.push_back(
          fmt::format("{{{}, {}}},", quoted(model_.parameters[p]),
                      dimension_table(fmt::format("dimension_{}", p), model_.parameter_dimensions[p])));
    code_.line("constexpr CompiledSymbol symbols[] = {");
    for (const std::string& row : symbol_rows) code_.line(row);
    code_.line("};");
    code_.line(fmt::format("constexpr double nominal[] = {{{}}};",
                           listed(model_.nominal, [](const std::optional<double>& value) {
                             return value && std::isfinite(*value) ? fmt::format("{}", *value)
                                                                   : "std::numeric_limits<double>::quiet_NaN()";
                           })));
    code_.line();
    for (std::size_t i = 0; i < model_.cases.size(); ++i) case_tables(model_.cases[i], fmt::format("case_{}", i));
    if (model_.cases.empty()) return;
    code_.line("constexpr CompiledCase cases[] = {");
    for (std::size_t i = 0; i < model_.cases.size(); ++i) case_row(model_.cases[i], fmt::format("case_{}", i));
    code_.line("};").line();
  }

  void case_tables(const CanonicalCase& c, const std::string& id) {
    const auto number = [](int n) { return std::to_string(n); };
    std::vector<int> relations;
    for (const CanonicalRelation& relation : c.relations)
      relations.insert(relations.end(), relation.multiples.begin(), relation.multiples.end());
    if (!relations.empty())
      code_.line(fmt::format("constexpr int {}_relations[] = {{{}}};", id, listed(relations, number)));
    std::vector<CanonicalRatio> observed;
    for (const auto& row : c.observed_frequency) observed.insert(observed.end(), row.begin(), row.end());
    code_.line(fmt::format("constexpr Ratio {}_observed_frequency[] = {{{}}};", id, ratios(observed)));
    code_.line(fmt::format("constexpr bool {}_mode_at_rest[] = {{{}}};", id,
                           listed(c.mode_at_rest, [](bool b) { return std::string(b ? "true" : "false"); })));
    std::vector<std::string> lump_rows;
    for (std::size_t l = 0; l < c.lumps.size(); ++l)
      lump_rows.push_back(fmt::format("{{{}, {}, {}}},", quoted(c.lumps[l].name),
                                      quoted(formula_text(c.lumps[l].definition, model_.order)),
                                      dimension_table(fmt::format("{}_lump_{}", id, l), c.lumps[l].dimension)));
    if (!lump_rows.empty()) {
      code_.line(fmt::format("constexpr CompiledLump {}_lumps[] = {{", id));
      for (const std::string& row : lump_rows) code_.line(row);
      code_.line("};");
    }
    for (std::size_t b = 0; b < c.blocks.size(); ++b) {
      code_.line(fmt::format("constexpr int {}_block_{}_lumps[] = {{{}}};", id, b,
                             listed(c.blocks[b].columns, [](const CanonicalBlock::Column& column) {
                               return std::to_string(column.lump);
                             })));
      if (!c.blocks[b].modulation)
        code_.line(
            fmt::format("constexpr int {}_block_{}_phase[] = {{{}}};", id, b, listed(c.blocks[b].phase, number)));
    }
    if (c.blocks.empty()) return void(code_.line());
    code_.line(fmt::format("constexpr RegressorBlock {}_blocks[] = {{", id));
    for (std::size_t b = 0; b < c.blocks.size(); ++b)
      code_.line(fmt::format("{{BlockKind::{}, {}, {}, {}, {}, {}_block_{}_lumps, {}::columns_{}}},",
                             c.blocks[b].modulation ? "modulation" : "harmonic", quoted(c.blocks[b].name),
                             c.blocks[b].mode, c.blocks[b].order,
                             c.blocks[b].modulation ? "{}" : fmt::format("{}_block_{}_phase", id, b), id, b,
                             space(c.name), b));
    code_.line("};").line();
  }

  void case_row(const CanonicalCase& c, const std::string& id) {
    code_.line("{");
    code_.line(fmt::format(".name = {},", quoted(c.name)));
    code_.line(fmt::format(".excited = {},", c.excited));
    code_.line(c.relations.empty() ? ".relations = {}," : fmt::format(".relations = {}_relations,", id));
    code_.line(fmt::format(".observed_frequency = {}_observed_frequency,", id));
    code_.line(fmt::format(".mode_at_rest = {}_mode_at_rest,", id));
    code_.line(c.lumps.empty() ? ".lumps = {}," : fmt::format(".lumps = {}_lumps,", id));
    code_.line(c.blocks.empty() ? ".blocks = {}," : fmt::format(".blocks = {}_blocks,", id));
    for (const char* function : {"evaluate_lumps", "evaluate_lumps_jacobian", "modulation", "modulation_jacobian"})
      code_.line(fmt::format(".{0} = {1}::{0}<double>,", function, space(c.name)));
    code_.line("},");
  }

  void model_table() {
    code_.line("extern const CompiledModel model;");
    code_.line("const CompiledModel model = {");
    code_.line(fmt::format(".name = {},", quoted(model_.name)));
    code_.line(fmt::format(".source = {},", quoted(model_.source)));
    code_.line(fmt::format(".fingerprint = {},", quoted(model_.fingerprint)));
    code_.line(".coordinates = coordinates,");
    const bool excited = !model_.excitations.empty();
    code_.line(excited ? ".excitations = excitations," : ".excitations = {},");
    code_.line(excited ? ".excitation_frequencies = excitation_frequencies," : ".excitation_frequencies = {},");
    code_.line(".symbols = symbols,").line(".nominal = nominal,");
    code_.line(model_.cases.empty() ? ".cases = {}," : ".cases = cases,");
    code_.line(".acceleration = accelerations<double>,").line("};").line();
  }

  const CanonicalModel& model_;
  CodeText code_;
};

}  // namespace

void refuse_unsupported_motion(const CanonicalModel& model) {
  using Kind = CanonicalFactor::Kind;
  for (const auto& equation : model.motion)
    for (const CanonicalMotionTerm& term : equation)
      for (const CanonicalFactor& f : term.factors)
        if (f.kind == Kind::clock_cos || f.kind == Kind::clock_sin)
          throw InputError(model.name, "equation of motion",
                           fmt::format("cos or sin of {}*t stands without {}",
                                       model.excitation_frequencies[f.index], model.excitations[f.index]),
                           "write the excitation as F*cos(Omega*t): its measured signal takes that place");
}

void refuse_unsupported(const CanonicalModel& model, const CanonicalCase& c) {
  if (!c.quadratures.empty())
    throw InputError(model.name, "case " + c.name,
                     "term " + factors_text(model, c.quadratures.front().factors) +
                         " goes to quadrature: the case has no regressor linear in lumps",
                     "leave the case out of the generated code, or use a nonsmooth function of one coordinate");
  if (c.observed_frequency.empty())
    throw InputError(model.name, "case " + c.name, "no rotating frame makes its modulation equations autonomous",
                     "generate code for cases with one steady state per excitation");
  for (const CanonicalBlock& block : c.blocks)
    for (const CanonicalBlock::Column& column : block.columns)
      for (const CanonicalColumnTerm& term : column.terms)
        for (std::size_t j = 0; j < model.excitations.size(); ++j) {
          const int net = term.powers.phase[model.coordinates.size() + j], total = term.powers.forcing[j];
          if (std::abs(net) > total || (total - net) % 2 != 0)
            throw InputError(model.name, "case " + c.name + ", term with " + model.excitations[j],
                             "a harmonic of " + model.excitation_frequencies[j] + " does not come from " +
                                 model.excitations[j] + "*cos(" + model.excitation_frequencies[j] + "*t)",
                             "write the excitation as F*cos(Omega*t)");
        }
}

std::vector<GeneratedFile> emit_cpp(const CanonicalModel& model) {
  ModelEmitter emitter(model);
  std::vector<GeneratedFile> files;
  files.push_back(emitter.header());
  files.push_back(emitter.table());
  return files;
}

std::vector<GeneratedFile> emit_registry(const std::vector<std::string>& model_names) {
  std::vector<std::string> names = model_names;
  std::sort(names.begin(), names.end());
  const std::string banner = "// Models compiled into this program: generated code, never edited by hand.\n";
  GeneratedFile header{"registry.hpp", banner + R"(#pragma once

#include <span>
#include <string_view>

#include "estimator/compiled_model.hpp"

namespace secular::generated {

/// All models, by name.
std::span<const CompiledModel* const> compiled_models();

/// The model of that name, or nullptr.
const CompiledModel* find_compiled_model(std::string_view name);

}  // namespace secular::generated
)"};
  std::string declarations, entries;
  for (const std::string& name : names) {
    const std::string space = safe_namespace(name);
    declarations += fmt::format("namespace {} {{\nextern const CompiledModel model;\n}}\n", space);
    entries += fmt::format("    &{}::model,\n", space);
  }
  GeneratedFile source{"registry.cpp",
                       banner + "#include \"generated/registry.hpp\"\n\nnamespace secular::generated {\n\n" +
                           declarations + R"(
std::span<const CompiledModel* const> compiled_models() {
  static const CompiledModel* const models[] = {
)" + entries + R"(  };
  return models;
}

const CompiledModel* find_compiled_model(std::string_view name) {
  for (const CompiledModel* model : compiled_models())
    if (model->name == name) return model;
  return nullptr;
}

}  // namespace secular::generated
)"};
  return {std::move(header), std::move(source)};
}

void write_generated(const std::vector<GeneratedFile>& files, const std::string& folder) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw InputError(folder, "", "cannot be made a folder", "name a folder that can be written");
  for (const GeneratedFile& file : files) {
    const fs::path target = fs::path(folder) / file.name;
    std::ifstream old(target, std::ios::binary);
    if (old) {
      std::ostringstream text;
      text << old.rdbuf();
      if (text.str() == file.text) continue;
    }
    const fs::path fresh = target.string() + ".new";
    {
      std::ofstream stream(fresh, std::ios::binary);
      stream << file.text;
      stream.flush();
      if (!stream) {
        fs::remove(fresh, error);
        throw InputError(target.string(), "", "cannot be written", "check the folder's permissions and space");
      }
    }
    fs::rename(fresh, target);
  }
}

}  // namespace secular
