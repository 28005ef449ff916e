#include "codegen/document/print_text.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <utility>

#include "codegen/canonical/free_name.hpp"
#include "codegen/canonical/polar_form.hpp"
#include "codegen/document/cartesian_text.hpp"
#include "codegen/document/orders_text.hpp"
#include "codegen/document/plain_text.hpp"
#include "codegen/document/rest_lines.hpp"
#include "codegen/document/steady_statements.hpp"
#include "codegen/expression/cpp_expression.hpp"
#include "perturb/ordered_equation.hpp"

namespace secular {
namespace {

bool starts_negative(const RationalFunction& f) {
  return !f.numerator.empty() && f.numerator.front().coefficient.front() == '-' && f.numerator.size() == 1;
}

// Appends "+ coefficient*rest" with the sign drawn out and brackets where needed.
void append(std::string& sum, const RationalFunction& coefficient, const std::string& rest,
            const SymbolOrder& order) {
  if (coefficient.is_zero()) return;
  const bool negative = starts_negative(coefficient);
  const RationalFunction magnitude = negative ? scaled(coefficient, -1, 1) : coefficient;
  std::string text = formula_text(magnitude, order);
  if (rest.empty()) {
    // as it is
  } else if (magnitude.is_one()) {
    text = rest;
  } else {
    text = (reads_as_sum(magnitude) ? "(" + text + ")" : text) + "*" + rest;
  }
  sum += sum.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
  sum += text;
}

std::string column_sum(const CanonicalModel& model, const CanonicalCase& c, const CanonicalBlock& block) {
  std::string sum;
  for (const CanonicalBlock::Column& column : block.columns)
    for (const CanonicalColumnTerm& term : column.terms) {
      std::string rest = (term.imaginary ? "i*" : "") + c.lumps[column.lump].name;
      const std::string powers = powers_text(model, term.powers);
      if (!powers.empty()) rest += "*" + powers;
      append(sum, term.factor, rest, model.order);
    }
  return sum.empty() ? "0" : sum;
}

// The slow phase of a relation but for its integer multiple.
std::string slow_angle(const CanonicalRelation& relation) {
  const int divisor = relation.coefficient.denominator;
  return relation.detuning + "*t" + (divisor == 1 ? "" : "/" + std::to_string(divisor));
}

std::string slow_exponential(const CanonicalCase& c, const CanonicalPowers& powers) {
  std::string angle;
  for (std::size_t r = 0; r < c.relations.size(); ++r) {
    if (powers.slow_phase[r] == 0 || c.relations[r].detuning.empty()) continue;
    const int n = powers.slow_phase[r] * c.relations[r].coefficient.numerator;
    angle += fmt::format("{}{}{}", n < 0 ? "-" : (angle.empty() ? "" : "+"),
                         std::abs(n) == 1 ? "" : std::to_string(std::abs(n)) + "*", slow_angle(c.relations[r]));
  }
  return angle.empty()
             ? ""
             : "exp(i*" + (angle.find_first_of("+-") == std::string::npos ? angle : "(" + angle + ")") + ")";
}

std::string complex_modulation(const CanonicalModel& model, const CanonicalCase& c, std::size_t mode) {
  std::string sum;
  for (const CanonicalTerm& term : c.slow_derivative[mode]) {
    std::string rest = powers_text(model, term.powers);
    const std::string phase = slow_exponential(c, term.powers);
    if (!phase.empty()) rest += (rest.empty() ? "" : "*") + phase;
    append(sum, term.real, rest, model.order);
    append(sum, term.imaginary, "i" + (rest.empty() ? "" : "*" + rest), model.order);
  }
  return sum.empty() ? "0" : sum;
}

std::string polar_angle(const CanonicalModel& model, const CanonicalCase& c, const PolarTerm& term) {
  std::string angle;
  const auto add = [&](int multiple, const std::string& name) {
    if (multiple == 0) return;
    angle += fmt::format("{}{}{}", multiple < 0 ? "-" : (angle.empty() ? "" : "+"),
                         std::abs(multiple) == 1 ? "" : std::to_string(std::abs(multiple)) + "*", name);
  };
  for (std::size_t r = 0; r < c.relations.size(); ++r)
    if (!c.relations[r].detuning.empty())
      add(term.slow_phase[r] * c.relations[r].coefficient.numerator, slow_angle(c.relations[r]));
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) add(term.beta[k], "beta_" + model.coordinates[k]);
  return angle;
}

std::string polar_sum(const CanonicalModel& model, const CanonicalCase& c, const std::vector<PolarTerm>& terms) {
  std::string sum;
  for (const PolarTerm& term : terms) {
    std::string rest;
    for (std::size_t k = 0; k < model.coordinates.size(); ++k)
      append_power(rest, "a_" + model.coordinates[k], term.amplitude[k]);
    for (std::size_t j = 0; j < model.excitations.size(); ++j)
      append_power(rest, model.excitations[j], term.forcing[j]);
    if (term.function != PolarTerm::Trigonometric::one)
      append_power(
          rest,
          (term.function == PolarTerm::Trigonometric::cosine ? "cos(" : "sin(") + polar_angle(model, c, term) + ")",
          1);
    append(sum, term.coefficient, rest, model.order);
  }
  return sum.empty() ? "0" : sum;
}

// "v - gap", "D(v1) + 1/2*D(v2)".
std::string argument_text(const CanonicalFactor& f) {
  std::map<std::string, Factor::Weight> argument;
  for (const auto& [name, ratio] : f.argument) argument[name] = {ratio.numerator, ratio.denominator};
  return secular::argument_text(argument);
}

std::string function_text(const CanonicalModel& model, const CanonicalFactor& f) {
  const std::string argument = sum_text(model, f.inner);
  const CanonicalRatio& p = f.exponent;
  if (f.function != SmoothKind::power) return fmt::format("{}({})", name_of(f.function), argument);
  if (p == CanonicalRatio{1, 2}) return "sqrt(" + argument + ")";
  return fmt::format("({})^({}{})", argument, p.numerator,
                     p.denominator == 1 ? "" : "/" + std::to_string(p.denominator));
}

std::string factor_text(const CanonicalModel& model, const CanonicalFactor& f) {
  const auto derived = [](const std::string& inner, int derivative) {
    return derivative == 0 ? inner : (derivative == 1 ? "D(" : "D2(") + inner + ")";
  };
  std::string base;
  switch (f.kind) {
    case CanonicalFactor::Kind::displacement:
      base = model.coordinates[f.index];
      break;
    case CanonicalFactor::Kind::velocity:
      base = derived(model.coordinates[f.index], 1);
      break;
    case CanonicalFactor::Kind::acceleration:
      base = derived(model.coordinates[f.index], 2);
      break;
    case CanonicalFactor::Kind::excitation: {
      const std::string wave = model.excitations[f.index] + "*cos(" + model.excitation_frequencies[f.index] + "*t)";
      base = f.derivative == 0 && f.power == 1 ? wave
                                               : derived(f.derivative == 0 ? "(" + wave + ")" : wave, f.derivative);
      break;
    }
    case CanonicalFactor::Kind::absolute:
    case CanonicalFactor::Kind::sign:
      base = (f.kind == CanonicalFactor::Kind::absolute ? "abs(" : "sgn(") +
             (f.argument.empty() ? derived(model.coordinates[f.index], f.derivative) : argument_text(f)) + ")";
      break;
    case CanonicalFactor::Kind::clock_cos:
    case CanonicalFactor::Kind::clock_sin:
      base = fmt::format("{}({}{}*t)", f.kind == CanonicalFactor::Kind::clock_cos ? "cos" : "sin",
                         f.multiple == 1 ? "" : std::to_string(f.multiple) + "*",
                         model.excitation_frequencies[f.index]);
      break;
    case CanonicalFactor::Kind::smooth:
      base = function_text(model, f);
      if (f.power != 1 && f.function == SmoothKind::power) base = "(" + base + ")";
      break;
  }
  return base + (f.power == 1 ? "" : "^" + std::to_string(f.power));
}

std::string certificate_text(const CanonicalCertificate& c) {
  std::string text = fmt::format(
      "  {}: put back into the original equation as a function of true time, {} coefficients {} up to eps^{}.\n",
      c.holds ? "holds" : "DOES NOT HOLD", c.coefficients_checked, c.holds ? "vanish exactly" : "were checked",
      c.order);
  if (c.nonsmooth_harmonics > 0)
    text += fmt::format(
        "  Nonsmooth terms: Fourier integrals by quadrature up to harmonic {}, relative difference at most "
        "{:.0e}.\n",
        c.nonsmooth_harmonics, c.nonsmooth_error);
  for (const std::string& remainder : c.remainders) text += "  left over: " + remainder + "\n";
  return text;
}

std::string section_text(const typeset::StatementSection& section) {
  std::string text = "\n" + section.heading + "\n";
  for (const typeset::Statement& statement : section.statements) {
    text += "  " + typeset::plain_text(statement.says) + "\n";
    for (const typeset::Equation& equation : statement.equations)
      text += "    " + typeset::plain_text(equation.left) + " = " + typeset::plain_text(equation.right) + "\n";
  }
  return text;
}

std::string series_text(const CanonicalModel& model, const CanonicalSeries& series) {
  return fmt::format("{} = {} + terms of degree {} and above", function_text(model, series.function),
                     sum_text(model, series.terms), series.degree + 1);
}

std::string case_text(const CanonicalModel& model, const CanonicalCase& c) {
  std::string text = "\nCase " + c.name + "\n" + std::string(5 + c.name.size(), '=') + "\n";
  for (const CanonicalRelation& relation : c.relations) text += "  resonance: " + relation.text + "\n";
  text += fmt::format("  order of expansion: eps^{}{}\n", c.expand_to, c.excited ? "" : "; no excitation");
  if (!c.chosen_orders.empty()) text += "  orders: " + orders_text(c) + "\n";
  for (const std::string& warning : c.warnings) text += "  WARNING: " + warning + "\n";
  const std::size_t modes = model.coordinates.size();
  if (!c.series.empty()) text += "\nFunctions, by their series about rest as far as this case needs them\n";
  for (const CanonicalSeries& series : c.series) text += "  " + series_text(model, series) + "\n";
  text += "\nExpansion\n";
  for (std::size_t k = 0; k < modes; ++k) {
    const std::string& v = model.coordinates[k];
    text += fmt::format("  {0} = A_{0}*exp(i*{1}*t) + cc + the harmonics below (one of each conjugate pair)\n", v,
                        model.natural_frequencies[k]);
    for (const CanonicalTerm& term : c.harmonics[k]) {
      std::string sum;
      const std::string powers = powers_text(model, term.powers);
      append(sum, term.real, powers, model.order);
      append(sum, term.imaginary, "i" + (powers.empty() ? "" : "*" + powers), model.order);
      text +=
          fmt::format("    eps^{}  exp(i*({})*t):  {}\n", term.order, phase_text(model, term.powers.phase), sum);
    }
  }
  text += "\nSolvability: complex modulation equations (true time, eps = 1, all orders)\n";
  for (std::size_t k = 0; k < modes; ++k)
    text += fmt::format("  dA_{}/dt = {}\n", model.coordinates[k], complex_modulation(model, c, k));
  for (const CanonicalQuadrature& quadrature : c.quadratures)
    text += "  " + quadrature_text(model, quadrature) + "\n";
  text += "\nPolar form, A = (a/2)*exp(i*beta)\n";
  for (std::size_t k = 0; k < modes; ++k) {
    const PolarEquations polar = polar_equations(model, c, k);
    const std::string& v = model.coordinates[k];
    text += fmt::format("  da_{}/dt = {}\n", v, polar_sum(model, c, polar.amplitude_rate));
    text += fmt::format("  a_{0}*dbeta_{0}/dt = {1}\n", v, polar_sum(model, c, polar.phase_rate));
  }
  if (!c.observed_frequency.empty()) {
    text += "\nObserved frequencies (the frame in which the equations do not depend on time)\n";
    for (std::size_t k = 0; k < modes; ++k) {
      text += fmt::format("  {}: {} = {}\n", model.coordinates[k], observed_frequency_name(model, k),
                          frequency_text(model, c.observed_frequency[k]));
    }
    text += cartesian_text(model, c);
    for (const typeset::StatementSection& section : typeset::steady_sections(model, c))
      text += section_text(section);
    text += "\nLumps: what data near this resonance can see\n";
    for (const CanonicalLump& lump : c.lumps)
      text += fmt::format("  {} = {}\n", lump.name, formula_text(lump.definition, model.order));
    text += "\nEquations linear in the lumps\n";
    for (const CanonicalBlock& block : c.blocks)
      text += fmt::format("  {}:\n    {}\n", block.name, equation_text(model, c, block));
  }
  text += "\nCertificate\n" + certificate_text(c.certificate);
  return text;
}

}  // namespace

std::string sum_text(const CanonicalModel& model, const std::vector<CanonicalMotionTerm>& terms) {
  std::string sum;
  for (const CanonicalMotionTerm& term : terms) {
    std::string rest = factors_text(model, term.factors);
    if (term.acceleration_of)
      rest += (rest.empty() ? "" : "*") + ("D2(" + model.coordinates[*term.acceleration_of] + ")");
    append(sum, term.coefficient, rest, model.order);
  }
  return sum.empty() ? "0" : sum;
}

std::string factors_text(const CanonicalModel& model, const std::vector<CanonicalFactor>& factors) {
  std::string text;
  for (const CanonicalFactor& factor : factors) text += (text.empty() ? "" : "*") + factor_text(model, factor);
  return text;
}

std::string quadrature_text(const CanonicalModel& model, const CanonicalQuadrature& quadrature) {
  const std::string mean = fmt::format("mean[{}*exp(-i*{}*t)]", factors_text(model, quadrature.factors),
                                       model.natural_frequencies[quadrature.mode]);
  std::string sum;
  append(sum, quadrature.real, mean, model.order);
  append(sum, quadrature.imaginary, "i*" + mean, model.order);
  return fmt::format(
      "dA_{}/dt also holds {}: by quadrature, the mean taken over the fast phases of the leading motion "
      "(order eps^{})",
      model.coordinates[quadrature.mode], sum, quadrature.order);
}

std::string phase_text(const CanonicalModel& model, const std::vector<int>& phase) {
  std::string text;
  for (std::size_t i = 0; i < phase.size(); ++i) {
    if (phase[i] == 0) continue;
    text += (phase[i] < 0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + "));
    text += (std::abs(phase[i]) == 1 ? "" : std::to_string(std::abs(phase[i])) + "*") + model.frequency_name(i);
  }
  return text.empty() ? "0" : text;
}

std::string powers_text(const CanonicalModel& model, const CanonicalPowers& powers) {
  std::string text;
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    append_power(text, "A_" + model.coordinates[k], powers.amplitude[k]);
    append_power(text, "conj(A_" + model.coordinates[k] + ")", powers.conjugate[k]);
    append_power(text, "abs(A_" + model.coordinates[k] + ")", powers.modulus[k]);
  }
  for (std::size_t j = 0; j < model.excitations.size(); ++j)
    append_power(text, model.excitations[j], powers.forcing[j]);
  return text;
}

std::string motion_text(const CanonicalModel& model, std::size_t mode) {
  return "0 = " + sum_text(model, model.motion[mode]);
}

std::string modulation_text(const CanonicalModel& model, const CanonicalCase& c, std::size_t mode) {
  std::string sum;
  for (const CanonicalBlock& block : c.blocks)
    if (block.modulation && block.mode == mode) sum = column_sum(model, c, block);
  return fmt::format("dB_{0}/dt + i*(w_{0} - {1})*B_{0} = {2} with A = B in that frame", model.coordinates[mode],
                     model.natural_frequencies[mode], sum.empty() ? "0" : sum);
}

std::string equation_text(const CanonicalModel& model, const CanonicalCase& c, const CanonicalBlock& block) {
  const std::string& v = model.coordinates[block.mode];
  const std::string left = block.modulation
                               ? fmt::format("(rate - i*{})*A_{}", model.natural_frequencies[block.mode], v)
                               : fmt::format("amplitude of exp(i*({})*t) in {}", phase_text(model, block.phase), v);
  return left + " = " + column_sum(model, c, block);
}

std::string derivation_text(const CanonicalModel& model) {
  std::string text = "Model " + model.name + "\n";
  if (!model.source.empty()) text += "Source: " + model.source + "\n";
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) text += "  " + motion_text(model, k) + "\n";
  const std::vector<std::string> rest = rest_lines(model);
  if (!rest.empty()) text += "Coordinates count from the rest position. With it the model as stated has\n";
  for (const std::string& line : rest) text += "  " + line + "\n";
  text +=
      "Conventions: A is half the peak amplitude (v = A exp(i w t) + conj); F is the peak excitation; frequencies "
      "in "
      "rad/s;\nA is the whole coefficient of exp(i w t), no correction contains that harmonic.\n";
  for (const CanonicalCase& c : model.cases) text += case_text(model, c);
  return text;
}

}  // namespace secular
