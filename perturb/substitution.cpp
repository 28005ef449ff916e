#include "perturb/substitution.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>
#include <utility>

#include "perturb/formula_value.hpp"
#include "perturb/fourier_quadrature.hpp"
#include "perturb/nonsmooth.hpp"

namespace secular {
namespace {

// Highest harmonic of a nonsmooth function that the check integrates; smooth factors shift it by their degree.
constexpr int highest_integrated_harmonic = 2 * highest_nonsmooth_harmonic;

}  // namespace

template <class Arithmetic>
Substitution<Arithmetic>::Substitution(const Derivation& derivation, Arithmetic arithmetic)
    : d_(derivation), model_(*derivation.model), arithmetic_(arithmetic), motion_(derivation, arithmetic) {}

template <class Arithmetic>
auto Substitution<Arithmetic>::residual(std::size_t k) -> Polynomial {
  const Mode& mode = model_.modes[k];
  Polynomial sum = motion_.zero();
  if (model_.lagrangian) {
    const Lagrangian& lagrangian = *model_.lagrangian;
    varied_ = k;
    const Jet kinetic = jet(lagrangian.kinetic, lagrangian.kinetic_source);
    const Jet potential = jet(lagrangian.potential, lagrangian.potential_source);
    varied_.reset();
    sum += motion_.time_derivative(kinetic.by_velocity);
    sum += kinetic.by_position.negated();
    sum += potential.by_position;
    sum += jet(*mode.force, mode.source).value.negated();
  } else {
    sum += jet(mode.equation->left, mode.source).value;
    sum += jet(mode.equation->right.front(), mode.source).value.negated();
  }
  return d_.resonance->degree_ordering ? ordered_by_degree(sum, motion_.variables())
                                       : normal_form(sum, motion_.variables());
}

template <class Arithmetic>
std::vector<std::complex<double>> Substitution<Arithmetic>::amplitudes() const {
  std::vector<std::complex<double>> values;
  if constexpr (Arithmetic::floating)
    for (const Mode& mode : model_.modes)
      values.push_back(std::polar(arithmetic_.symbol("abs " + mode.coordinate).real(),
                                  2 * std::numbers::pi * arithmetic_.symbol("arg " + mode.coordinate).real()));
  return values;
}

// --- values with derivatives

template <class Arithmetic>
auto Substitution<Arithmetic>::still(Polynomial value) const -> Jet {
  return {std::move(value), motion_.zero(), motion_.zero()};
}

template <class Arithmetic>
auto Substitution<Arithmetic>::times(const Jet& a, const Jet& b) const -> Jet {
  Jet result = still(a.value * b.value);
  if (varied_) {
    result.by_position = a.by_position * b.value;
    result.by_position += a.value * b.by_position;
    result.by_velocity = a.by_velocity * b.value;
    result.by_velocity += a.value * b.by_velocity;
  }
  return result;
}

// d/dt of f(q, q'): its derivative by q' is df/dq, by q the time derivative of df/dq.
template <class Arithmetic>
auto Substitution<Arithmetic>::derived(const Jet& inner) const -> Jet {
  Jet result = still(motion_.time_derivative(inner.value));
  if (varied_) {
    result.by_position = motion_.time_derivative(inner.by_position);
    result.by_velocity = inner.by_position;
    result.by_velocity += motion_.time_derivative(inner.by_velocity);
  }
  return result;
}

// Denominators hold symbols and numbers only: a constant with one power of eps per symbol.
template <class Arithmetic>
auto Substitution<Arithmetic>::reciprocal_constant(const Jet& divisor) const -> Jet {
  const auto& orders = divisor.value.orders();
  EpsSeries<Number> value(orders.size());
  for (std::size_t n = 0; n < orders.size(); ++n)
    for (const auto& [powers, number] : orders[n]) value[n] += number;
  return still(Polynomial::constant(reciprocal(value, Arithmetic::inverse), motion_.variables().size()));
}

// --- the equations, node by node

template <class Arithmetic>
auto Substitution<Arithmetic>::jet(const Expression& e, const FormulaSource& source) -> Jet {
  switch (e.kind) {
    case Expression::Kind::number:
      return still(motion_.constant(arithmetic_.number(exact_number(e.text))));
    case Expression::Kind::symbol:
      return symbol_jet(e);
    case Expression::Kind::sum: {
      Jet sum = still(motion_.zero());
      for (const Expression& operand : e.operands) {
        const Jet addend = jet(operand, source);
        sum.value += addend.value;
        sum.by_position += addend.by_position;
        sum.by_velocity += addend.by_velocity;
      }
      return sum;
    }
    case Expression::Kind::product: {
      Jet whole = jet(e.operands.front(), source);
      for (std::size_t i = 1; i < e.operands.size(); ++i) whole = times(whole, jet(e.operands[i], source));
      return whole;
    }
    case Expression::Kind::quotient:
      return times(jet(e.operands[0], source), reciprocal_constant(jet(e.operands[1], source)));
    case Expression::Kind::power: {
      const int exponent = integer_exponent(e, source);
      Jet base = jet(e.operands[0], source), whole = still(motion_.constant(1));
      if (exponent < 0) base = reciprocal_constant(base);
      for (int n = std::abs(exponent); n > 0; --n) whole = times(whole, base);
      return whole;
    }
    case Expression::Kind::negation: {
      const Jet inner = jet(e.operands[0], source);
      return {inner.value.negated(), inner.by_position.negated(), inner.by_velocity.negated()};
    }
    case Expression::Kind::call:
      break;
  }
  return call_jet(e, source);
}

template <class Arithmetic>
auto Substitution<Arithmetic>::symbol_jet(const Expression& e) const -> Jet {
  for (std::size_t k = 0; k < model_.modes.size(); ++k)
    if (model_.modes[k].coordinate == e.text) {
      Jet coordinate = still(motion_.of_mode(k, 0));
      if (varied_ == k) coordinate.by_position = motion_.constant(1);
      return coordinate;
    }
  if (e.text == "Pi") return still(motion_.constant(arithmetic_.pi()));
  const auto entry = d_.resonance->order.find(e.text);
  if (entry != d_.resonance->order.end() && entry->second > 0)
    return still(motion_.constant(arithmetic_.symbol(e.text), static_cast<std::size_t>(entry->second)));
  return still(Polynomial::constant(motion_.symbol(e.text), motion_.variables().size()));
}

template <class Arithmetic>
auto Substitution<Arithmetic>::call_jet(const Expression& e, const FormulaSource& source) -> Jet {
  if (e.text == "cos" || e.text == "sin") return still(clock(e, source));
  if (e.text == "D") return derived(jet(e.operands[0], source));
  if (e.text == "D2") {
    // The coordinates' own accelerations are at hand.
    if (e.operands[0].kind == Expression::Kind::symbol)
      for (std::size_t k = 0; k < model_.modes.size(); ++k)
        if (model_.modes[k].coordinate == e.operands[0].text) return still(motion_.of_mode(k, 2));
    return derived(derived(jet(e.operands[0], source)));
  }
  // With several symbols in its argument it is a quadrature term, whatever their motions add up to.
  std::set<std::string> names;
  for (const Expression& operand : e.operands)
    for (const std::string& name : identifiers(operand)) names.insert(name);
  const bool alone = names.size() == 1;
  const Polynomial argument = jet(e.operands[0], source).value;
  if (e.text == "max" || e.text == "min") {  // max(a, b) = (a + b + |a - b|)/2
    const Polynomial other = jet(e.operands[1], source).value;
    Polynomial difference = argument, sum = argument;
    difference += other.negated();
    sum += other;
    const Polynomial distance = alone ? nonsmooth_function(true, difference) : motion_.zero();
    sum += e.text == "max" ? distance : distance.negated();
    return still(sum * motion_.constant(Arithmetic::inverse(Number(2))));
  }
  return still(alone ? nonsmooth_function(e.text == "abs", argument) : motion_.zero());
}

// cos(n Omega t), sin(n Omega t).
template <class Arithmetic>
auto Substitution<Arithmetic>::clock(const Expression& e, const FormulaSource& source) const -> Polynomial {
  Polynomial wave = motion_.zero();
  if (!d_.resonance->excited) return wave;
  const GiNaC::symbol time("t");
  const GiNaC::ex phase = formula_value(e.operands[0], source, [&](const Expression& s) -> GiNaC::ex {
    return s.text == "t" ? GiNaC::ex(time) : model_.symbols.at(s.text);
  });
  for (std::size_t i = model_.modes.size(); i < model_.frequency_count(); ++i) {
    const GiNaC::ex multiple = (phase / (model_.frequency(i) * time)).normal();
    if (!GiNaC::is_a<GiNaC::numeric>(multiple)) continue;
    TrueTimePowers powers(motion_.variables().size(), 0);
    powers[i] = GiNaC::ex_to<GiNaC::numeric>(multiple).to_int();
    const bool cosine = e.text == "cos";
    const Number half = Arithmetic::inverse(Number(2)), turned = cosine ? half : -(half * Arithmetic::i());
    wave.add(0, powers, turned);
    powers[i] = -powers[i];
    wave.add(0, powers, cosine ? turned : -turned);
  }
  return wave;
}

// abs(x) or sgn(x). Without a closed Fourier series it is a quadrature term, which the expansion leaves open: zero.
template <class Arithmetic>
auto Substitution<Arithmetic>::nonsmooth_function(bool absolute, const Polynomial& x) -> Polynomial {
  Polynomial result = motion_.zero();
  const std::optional<std::size_t> mode = motion_.mode_of(x);
  if (!mode || d_.resonance->mode_at_rest[*mode] || d_.response[*mode][0].terms().size() > 2) return result;
  nonsmooth_ = true;
  if constexpr (Arithmetic::floating) {
    const TrueTimeVariables& variables = motion_.variables();
    const auto harmonics = [&](std::size_t order) {
      return at_amplitudes(x.orders()[order], variables, amplitudes());
    };
    Number phasor{};
    for (const auto& [waves, value] : harmonics(0))
      if (waves[*mode] == 1) phasor = 2.0 * value;
    const auto put = [&](std::size_t order, const TrueTimePowers& waves, int harmonic, const Number& value) {
      TrueTimePowers powers(variables.size(), 0);
      std::copy(waves.begin(), waves.end(), powers.begin());
      powers[*mode] += harmonic;
      if (absolute) powers[variables.degree()] = 1;
      result.add(order, powers, value);
    };
    const TrueTimePowers unmoved(variables.frequencies, 0);
    for (int n = -highest_integrated_harmonic; n <= highest_integrated_harmonic; ++n) {
      put(0, unmoved, n, fourier_by_quadrature(phasor, absolute, n));
      if (!absolute || x.orders().size() < 2) continue;
      // |x0 + eps x1| = |x0| + eps sgn(x0) x1 + ...
      const Number slope = fourier_by_quadrature(phasor, false, n);
      for (const auto& [waves, value] : harmonics(1)) put(1, waves, n, slope * value);
    }
  }
  return result;
}

template class Substitution<ExactArithmetic>;
template class Substitution<FloatingArithmetic>;

}  // namespace secular
