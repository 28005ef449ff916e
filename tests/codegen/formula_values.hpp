#pragma once

// Typeset formulas as numbers.
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/document/latex_math.hpp"
#include "codegen/document/typeset_equations.hpp"

namespace secular {

using Complex = std::complex<double>;
using Formula = typeset::Expression;
using Kind = Formula::Kind;

/// Values of symbols by how they are typeset.
class Values {
 public:
  void set(const Formula& symbol, Complex value) { values_[typeset::latex_math(symbol)] = value; }
  void set(const std::string& identifier, Complex value) { set(typeset::symbol(identifier), value); }
  Complex operator[](const std::string& identifier) const { return of(typeset::symbol(identifier)); }

  Complex of(const Formula& formula) const {
    const auto part = [&](std::size_t i) { return of(formula.parts[i]); };
    switch (formula.kind) {
      case Kind::number:
        return std::stod(formula.text);
      case Kind::symbol:
      case Kind::indexed:
        return values_.at(typeset::latex_math(formula));
      case Kind::constant:
        if (formula.text == "i") return {0, 1};
        break;
      case Kind::accent:
        if (formula.text == "bar") return std::conj(part(0));
        break;
      case Kind::product: {
        Complex product = 1;
        for (const Formula& factor : formula.parts) product *= of(factor);
        return product;
      }
      case Kind::sum: {
        Complex sum = 0;
        for (std::size_t i = 0; i < formula.parts.size(); ++i) sum += formula.negative[i] ? -part(i) : part(i);
        return sum;
      }
      case Kind::fraction:
        return part(0) / part(1);
      case Kind::power:
        return std::pow(part(0), formula.exponent);
      case Kind::bracket:
        return part(0);
      case Kind::modulus:
        return std::abs(part(0));
      case Kind::root:
        return std::sqrt(part(0));
      case Kind::function:
        return formula.text == "cos" ? std::cos(part(0)) : std::sin(part(0));
      case Kind::exponential:
        return std::exp(part(0));
      case Kind::words:
      case Kind::mean:
        break;
    }
    throw std::invalid_argument("no value: " + typeset::latex_math(formula));
  }

 private:
  std::map<std::string, Complex> values_;
};

inline double value_of(const RationalFunction& f, const SymbolOrder& order, const Values& values) {
  const std::function<double(const std::vector<PolynomialTerm>&)> polynomial =
      [&](const std::vector<PolynomialTerm>& terms) {
        double sum = 0;
        for (const PolynomialTerm& term : terms) {
          double product = std::stod(term.coefficient);
          for (std::size_t i = 0; i < order.size(); ++i)
            product *= std::pow(values[order[i]].real(), term.exponents[i]);
          for (const DivisorPower& divisor : term.divisors)
            product /= std::pow(polynomial(*divisor.sum), divisor.power);
          sum += product;
        }
        return sum;
      };
  return polynomial(f.numerator) / polynomial(f.denominator);
}

inline Complex value_of(const CanonicalModel& model, const CanonicalCase& c, const CanonicalTerm& term,
                        const Values& values) {
  const CanonicalPowers& p = term.powers;
  Complex value{value_of(term.real, model.order, values), value_of(term.imaginary, model.order, values)};
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    const Complex a = values["A_" + model.coordinates[k]];
    value *=
        std::pow(a, p.amplitude[k]) * std::pow(std::conj(a), p.conjugate[k]) * std::pow(std::abs(a), p.modulus[k]);
  }
  for (std::size_t j = 0; j < model.excitations.size(); ++j)
    value *= std::pow(values[model.excitations[j]], p.forcing[j]);
  for (std::size_t r = 0; r < c.relations.size(); ++r) {
    const CanonicalRelation& relation = c.relations[r];
    if (relation.detuning.empty()) continue;
    const double rate = values[relation.detuning].real() * relation.coefficient.numerator /
                        static_cast<double>(relation.coefficient.denominator);
    value *= std::exp(Complex(0, p.slow_phase[r] * rate) * values["t"]);
  }
  return value;
}

/// Random values for everything in the model; amplitudes in all their forms.
inline Values random_values(const CanonicalModel& model, const CanonicalCase& c, double t, unsigned seed = 11) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> draw(0.3, 1.7);
  Values values;
  for (const std::string& name : model.order) values.set(name, draw(random));
  for (const std::string& name : model.excitations) values.set(name, draw(random));
  for (const CanonicalRelation& relation : c.relations)
    if (!relation.detuning.empty()) values.set(relation.detuning, draw(random));
  values.set("pi", std::acos(-1.0));
  values.set("t", t);
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    const double a = draw(random), beta = draw(random);
    values.set(typeset::amplitude(model, k), std::polar(a / 2, beta));
    values.set(typeset::named("B", model, k), std::polar(a / 2, beta));  // at time 0
    values.set(typeset::named("a", model, k), a);
    values.set(typeset::named("beta", model, k), beta);
    values.set(typeset::named("x", model, k), a * std::cos(beta));
    values.set(typeset::named("y", model, k), a * std::sin(beta));
  }
  for (std::size_t i = 0; i < c.lumps.size(); ++i)
    values.set(typeset::lump_symbol(model, c, i), value_of(c.lumps[i].definition, model.order, values));
  return values;
}

}  // namespace secular
