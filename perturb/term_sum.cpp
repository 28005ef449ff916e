#include "perturb/term_sum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "perturb/formula_value.hpp"
#include "perturb/smooth_reading.hpp"

namespace secular {

void TermSum::add(const FactorProduct& product, const GiNaC::ex& coefficient) {
  const auto [position, added] = terms_.try_emplace(product, coefficient);
  if (!added) position->second = (position->second + coefficient).expand();
  if (position->second.is_zero()) terms_.erase(position);
}

TermSum TermSum::constant(const GiNaC::ex& value) {
  TermSum sum;
  sum.add({}, value);
  return sum;
}

TermSum TermSum::factor(const Factor& factor) {
  TermSum sum;
  sum.add({{factor, 1}}, 1);
  return sum;
}

TermSum& TermSum::operator+=(const TermSum& other) {
  for (const auto& [product, coefficient] : other.terms_) add(product, coefficient);
  return *this;
}

TermSum operator*(const TermSum& left, const TermSum& right) {
  TermSum result;
  for (const auto& [left_product, left_coefficient] : left.terms_)
    for (const auto& [right_product, right_coefficient] : right.terms_) {
      FactorProduct product = left_product;
      for (const auto& [factor, power] : right_product) product[factor] += power;
      result.add(product, (left_coefficient * right_coefficient).expand());
    }
  return result;
}

TermSum TermSum::scaled(const GiNaC::ex& scale) const {
  return *this * constant(scale);
}

GiNaC::ex TermSum::constant_part() const {
  const auto found = terms_.find({});
  return found == terms_.end() ? GiNaC::ex(0) : found->second;
}

TermSum TermSum::power(int exponent) const {
  TermSum result = constant(1);
  for (int i = 0; i < exponent; ++i) result = result * *this;
  return result;
}

TermSum TermSum::time_derivative() const {
  TermSum result;
  for (const auto& [product, coefficient] : terms_)
    for (const auto& [factor, power] : product) {
      FactorProduct derived = product;
      if (--derived[factor] == 0) derived.erase(factor);
      if (factor.kind == Factor::Kind::smooth) {
        TermSum rest;
        rest.add(derived, coefficient * power);
        result += rest * factor.function.slope() * factor.function.argument().time_derivative();
        continue;
      }
      Factor raised = factor;
      ++raised.derivative;
      ++derived[raised];
      result.add(derived, coefficient * power);
    }
  return result;
}

TermSum TermSum::partial(const Factor& by) const {
  TermSum result;
  for (const auto& [product, coefficient] : terms_)
    for (const auto& [factor, power] : product) {
      const bool smooth = factor.kind == Factor::Kind::smooth;
      if (!smooth && factor != by) continue;
      FactorProduct derived = product;
      if (--derived[factor] == 0) derived.erase(factor);
      if (smooth) {
        const TermSum inner = factor.function.argument().partial(by);
        if (inner.empty()) continue;
        TermSum rest;
        rest.add(derived, coefficient * power);
        result += rest * factor.function.slope() * inner;
      } else {
        result.add(derived, coefficient * power);
      }
    }
  return result;
}

namespace {

// Reads one formula into a TermSum. F*cos(Omega*t) is one factor, recognised when a product is complete.
class TermReader {
 public:
  TermReader(const Model& model, const FormulaSource& source) : model_(model), source_(source) {}

  TermSum read(const Expression& expression) {
    return without_bare_amplitudes(value(expression), expression.place);
  }

 private:
  TermSum value(const Expression& e) {
    switch (e.kind) {
      case Expression::Kind::number:
        return TermSum::constant(exact_number(e.text));
      case Expression::Kind::symbol:
        return symbol(e);
      case Expression::Kind::sum: {
        TermSum sum;
        for (const Expression& operand : e.operands) sum += value(operand);
        return sum;
      }
      case Expression::Kind::product: {
        TermSum product = TermSum::constant(1);
        for (const Expression& operand : e.operands) product = limited(product * value(operand), e.place);
        return joined_excitation(product);
      }
      case Expression::Kind::quotient:
        return quotient(e);
      case Expression::Kind::power:
        return power(e);
      case Expression::Kind::negation:
        return value(e.operands[0]).scaled(-1);
      case Expression::Kind::call:
        return call(e);
    }
    return {};
  }

  TermSum limited(TermSum sum, const SourcePlace& place) const {
    if (sum.terms().size() > 20000)
      fail_at(source_, place, "expands to more than 20000 terms", "simplify the formula");
    return sum;
  }

  TermSum symbol(const Expression& e) const {
    for (std::size_t i = 0; i < model_.modes.size(); ++i)
      if (model_.modes[i].coordinate == e.text)
        return TermSum::factor({Factor::Kind::coordinate, static_cast<int>(i), 0, 1});
    if (e.text == "t")
      fail_at(source_, e.place, "time stands outside cos and sin", "write for example F*cos(Omega*t)");
    if (e.text == "Pi") return TermSum::constant(GiNaC::Pi);
    return TermSum::constant(model_.symbols.at(e.text));
  }

  // Parameters and numbers only.
  static bool is_constant(const TermSum& sum) {
    return sum.terms().size() == 1 && sum.terms().begin()->first.empty();
  }

  TermSum smooth(const Expression& e, SmoothKind kind, std::pair<long, long> exponent, TermSum inside,
                 const Expression& argument) const {
    return smooth_term({&e, &argument, kind, exponent, std::move(inside)}, model_, source_);
  }

  TermSum quotient(const Expression& e) {
    const TermSum numerator = value(e.operands[0]), denominator = value(e.operands[1]);
    if (denominator.empty()) fail_at(source_, e.operands[1].place, "division by zero", "correct the denominator");
    if (is_constant(denominator))
      return joined_excitation(numerator.scaled(1 / denominator.terms().begin()->second));
    return joined_excitation(
        limited(numerator * smooth(e, SmoothKind::power, {-1, 1}, denominator, e.operands[1]), e.place));
  }

  TermSum power(const Expression& e) {
    const std::pair<long, long> exponent = rational_exponent(e, source_);
    const TermSum base = value(e.operands[0]);
    if (exponent.second != 1) return smooth(e, SmoothKind::power, exponent, base, e.operands[0]);
    if (exponent.first < 0) {
      if (base.empty()) fail_at(source_, e.operands[0].place, "division by zero", "correct the denominator");
      if (!is_constant(base)) return smooth(e, SmoothKind::power, exponent, base, e.operands[0]);
      return TermSum::constant(GiNaC::pow(base.terms().begin()->second, static_cast<int>(exponent.first)));
    }
    TermSum result = TermSum::constant(1);
    for (long i = 0; i < exponent.first; ++i) result = limited(result * base, e.place);
    return joined_excitation(result);
  }

  TermSum call(const Expression& e) {
    const Expression& argument = e.operands[0];
    if (e.text == "D" || e.text == "D2") {
      const TermSum inside = without_bare_amplitudes(value(argument), argument.place);
      for (const auto& [product, ignored] : inside.terms())
        for (const auto& [factor, power] : product)
          if (factor.nonsmooth() || factor.kind == Factor::Kind::clock_cos ||
              factor.kind == Factor::Kind::clock_sin)
            fail_at(source_, e.place, "derivative of abs, sgn, max, min or of cos or sin of time without F",
                    "write the derivative out");
      const TermSum derived = e.text == "D" ? inside.time_derivative() : inside.time_derivative().time_derivative();
      for (const auto& [product, ignored] : derived.terms())
        for (const auto& [factor, power] : product)
          if (factor.derivative > 2)
            fail_at(source_, e.place, "a time derivative above the second",
                    "equations of motion are of second order");
      return derived;
    }
    if (e.text == "abs" || e.text == "sgn") return nonsmooth(e.text == "abs", value(argument), e.place);
    if (e.text == "max" || e.text == "min") {  // max(a, b) = (a + b + |a - b|)/2
      const TermSum first = value(argument), second = value(e.operands[1]);
      TermSum difference = first, result = first;
      difference += second.scaled(-1);
      result += second;
      result += nonsmooth(true, difference, e.place).scaled(e.text == "max" ? 1 : -1);
      return result.scaled(GiNaC::numeric(1, 2));
    }
    if (e.text == "sqrt") return smooth(e, SmoothKind::power, {1, 2}, value(argument), argument);
    if ((e.text == "cos" || e.text == "sin") && holds_time(argument)) return clock(e);
    return smooth(e, smooth_kind(e.text).value(), {1, 1}, value(argument), argument);
  }

  // abs(c*x) = |c| abs(x), sgn(c*x) = sgn(c) sgn(x) for a number c and x a sum of coordinates, velocities and
  // parameters.
  TermSum nonsmooth(bool absolute, const TermSum& inside, const SourcePlace& place) {
    const Factor::Kind kind = absolute ? Factor::Kind::absolute : Factor::Kind::sign;
    const auto unsupported = [&] {
      fail_at(source_, place, "nonsmooth function of something else than coordinates, velocities and parameters",
              "its argument is a sum of numbers times v, D(v) or a parameter");
    };
    Factor made{kind, 0, 0, 1};
    std::map<std::string, GiNaC::numeric> weights;
    bool moves = false;
    for (const auto& [product, whole] : inside.terms()) {
      if (product.empty()) {
        const GiNaC::ex sum = whole.expand();
        for (std::size_t i = 0; i < (GiNaC::is_a<GiNaC::add>(sum) ? sum.nops() : 1); ++i) {
          const GiNaC::ex term = GiNaC::is_a<GiNaC::add>(sum) ? sum.op(i) : sum;
          if (GiNaC::is_a<GiNaC::numeric>(term)) {
            weights["1"] = GiNaC::ex_to<GiNaC::numeric>(term);
            continue;
          }
          const auto name = std::find_if(
              model_.parameters.begin(), model_.parameters.end(),
              [&](const std::string& p) { return GiNaC::is_a<GiNaC::numeric>(term / model_.symbols.at(p)); });
          if (name == model_.parameters.end()) unsupported();
          weights[*name] = GiNaC::ex_to<GiNaC::numeric>(term / model_.symbols.at(*name));
        }
        continue;
      }
      const auto& [factor, power] = *product.begin();
      if (product.size() != 1 || power != 1 || factor.kind != Factor::Kind::coordinate || factor.derivative > 1 ||
          !GiNaC::is_a<GiNaC::numeric>(whole))
        unsupported();
      const std::string& coordinate = model_.modes[static_cast<std::size_t>(factor.index)].coordinate;
      if (moves) {  // the first of them stands for all where only a unit is asked for
        weights[factor.derivative == 0 ? coordinate : "D(" + coordinate + ")"] =
            GiNaC::ex_to<GiNaC::numeric>(whole);
        continue;
      }
      weights[factor.derivative == 0 ? coordinate : "D(" + coordinate + ")"] = GiNaC::ex_to<GiNaC::numeric>(whole);
      made.index = factor.index;
      made.derivative = factor.derivative;
      moves = true;
    }
    if (inside.empty()) return {};
    if (!moves)
      fail_at(source_, place, "nonsmooth function of a constant",
              "a coordinate or its velocity was expected in it");
    const GiNaC::numeric lead = weights.begin()->second;
    if (weights.size() > 1) {
      for (const auto& [name, weight] : weights) {
        const GiNaC::numeric relative = weight / lead;
        if (!relative.is_rational() || GiNaC::abs(relative.numer()) > 1000000 || relative.denom() > 1000000)
          unsupported();
        made.argument[name] = {relative.numer().to_long(), relative.denom().to_long()};
      }
    }
    if (absolute) return TermSum::factor(made).scaled(GiNaC::abs(lead));
    return TermSum::factor(made).scaled(lead.is_negative() ? -1 : 1);
  }

  // Outside the functions in it.
  static bool holds_time(const Expression& e) {
    if (e.kind == Expression::Kind::symbol) return e.text == "t";
    return e.kind != Expression::Kind::call && std::any_of(e.operands.begin(), e.operands.end(), holds_time);
  }

  // cos(n*Omega*t), sin(n*Omega*t) with an integer n.
  TermSum clock(const Expression& e) {
    const GiNaC::symbol time("t");
    const GiNaC::ex phase =
        formula_value(e.operands[0], source_, [&](const Expression& symbol) -> GiNaC::ex {
          if (symbol.text == "t") return time;
          if (model_.symbols.contains(symbol.text)) return model_.symbols.at(symbol.text);
          fail_at(source_, symbol.place, e.text + " of the coordinate '" + symbol.text + "' and of time",
                  "write it out by the addition theorem: cos(Omega*t) and " + e.text + "(" + symbol.text +
                      ") stand each for itself");
        }).expand();
    for (std::size_t i = 0; i < model_.excitations.size(); ++i) {
      const GiNaC::ex multiple = phase / (model_.symbols.at(model_.excitations[i].frequency) * time);
      if (!GiNaC::is_a<GiNaC::numeric>(multiple) || !GiNaC::ex_to<GiNaC::numeric>(multiple).is_integer()) continue;
      if (GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(multiple)) > largest_multiple)
        fail_at(source_, e.place, fmt::format("a multiple of a frequency beyond {}", largest_multiple),
                "a harmonic of the excitation that the motion has something of was expected");
      int n = GiNaC::ex_to<GiNaC::numeric>(multiple).to_int();
      const bool cosine = e.text == "cos";
      const int sign = n < 0 && !cosine ? -1 : 1;
      n = std::abs(n);
      if (n == 0) return cosine ? TermSum::constant(1) : TermSum();
      return TermSum::factor(
                 {cosine ? Factor::Kind::clock_cos : Factor::Kind::clock_sin, static_cast<int>(i), 0, n})
          .scaled(sign);
    }
    fail_at(source_, e.place, "the argument of " + e.text + " is not n*Omega*t",
            "write " + e.text + "(Omega*t) with the excitation frequency Omega and time t");
  }

  // Replaces F*cos(Omega*t) by the excitation factor wherever both stand in one term.
  TermSum joined_excitation(const TermSum& sum) const {
    TermSum result;
    for (const auto& [product, whole] : sum.terms()) {
      FactorProduct factors = product;
      GiNaC::ex rest = whole;
      for (std::size_t i = 0; i < model_.excitations.size(); ++i) {
        const GiNaC::ex& amplitude = model_.symbols.at(model_.excitations[i].amplitude);
        const auto cosine = factors.find({Factor::Kind::clock_cos, static_cast<int>(i), 0, 1});
        if (cosine == factors.end()) continue;
        const int count = std::min(cosine->second, amplitude_power(rest, amplitude));
        if (count <= 0) continue;
        if ((cosine->second -= count) == 0) factors.erase(cosine);
        factors[{Factor::Kind::excitation, static_cast<int>(i), 0, 1}] += count;
        rest = (rest * GiNaC::pow(amplitude, -count)).expand();
      }
      TermSum term = TermSum::constant(rest);
      for (const auto& [factor, power] : factors) term = term * TermSum::factor(factor).power(power);
      result += term;
    }
    return result;
  }

  static int amplitude_power(const GiNaC::ex& coefficient, const GiNaC::ex& amplitude) {
    return coefficient.has(amplitude) ? coefficient.ldegree(amplitude) : 0;
  }

  TermSum without_bare_amplitudes(TermSum sum, const SourcePlace& place) const {
    for (const auto& [product, whole] : sum.terms())
      for (const Excitation& excitation : model_.excitations)
        if (whole.has(model_.symbols.at(excitation.amplitude)))
          fail_at(source_, place, excitation.amplitude + " without its cos(" + excitation.frequency + "*t)",
                  "the excitation enters as " + excitation.amplitude + "*cos(" + excitation.frequency +
                      "*t), written as one product; a second frequency is one of its own, F2*cos(Omega2*t), with a "
                      "relation as Omega2 = 2*Omega");
    return sum;
  }

  const Model& model_;
  const FormulaSource& source_;
};

TermSum read_terms(const Model& model, const FormulaSource& source, const Expression& expression) {
  return TermReader(model, source).read(expression);
}

std::vector<TermSum> lagrange_equations(const Model& model) {
  const Lagrangian& lagrangian = *model.lagrangian;
  const TermSum kinetic = read_terms(model, lagrangian.kinetic_source, lagrangian.kinetic);
  const TermSum potential = read_terms(model, lagrangian.potential_source, lagrangian.potential);
  for (const auto& [sum, source] :
       {std::pair(&kinetic, &lagrangian.kinetic_source), std::pair(&potential, &lagrangian.potential_source)})
    for (const auto& [product, ignored] : sum->terms())
      for (const auto& [factor, power] : product)
        if (factor.nonsmooth() || (factor.kind == Factor::Kind::coordinate && factor.derivative > 1))
          fail_at(*source, {source->first_line, 1}, "energy with abs, sgn or D2",
                  "energies are smooth functions of coordinates and velocities");
  std::vector<TermSum> equations;
  for (std::size_t i = 0; i < model.modes.size(); ++i) {
    const Factor position{Factor::Kind::coordinate, static_cast<int>(i), 0, 1};
    const Factor velocity{Factor::Kind::coordinate, static_cast<int>(i), 1, 1};
    TermSum equation = kinetic.partial(velocity).time_derivative();
    equation += kinetic.partial(position).scaled(-1);
    equation += potential.partial(position);
    equation += read_terms(model, model.modes[i].source, *model.modes[i].force).scaled(-1);
    equations.push_back(std::move(equation));
  }
  return equations;
}

}  // namespace

namespace {

std::vector<TermSum> stated_equations(const Model& model) {
  if (model.lagrangian) return lagrange_equations(model);
  std::vector<TermSum> equations;
  for (const Mode& mode : model.modes) {
    TermSum equation = read_terms(model, mode.source, mode.equation->left);
    equation += read_terms(model, mode.source, mode.equation->right.front()).scaled(-1);
    equations.push_back(std::move(equation));
  }
  return equations;
}

// About rest coefficients are fractions, which cancel over one denominator; inertia is one there.
TermSum about_rest(const TermSum& equation, std::size_t mode) {
  const Factor acceleration{Factor::Kind::coordinate, static_cast<int>(mode), 2, 1};
  const GiNaC::ex inertia = value_at_rest(equation.partial(acceleration)).normal();
  TermSum result;
  for (const auto& [product, coefficient] : equation.terms()) result.add(product, (coefficient / inertia).normal());
  return result;
}

}  // namespace

std::vector<TermSum> equations_of_motion(const Model& model) {
  std::vector<TermSum> equations = stated_equations(model);
  for (std::size_t k = 0; k < equations.size() && model.rest; ++k) equations[k] = about_rest(equations[k], k);
  return equations;
}

}  // namespace secular
