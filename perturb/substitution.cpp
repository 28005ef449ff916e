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
#include "perturb/smooth_function.hpp"

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
  return normal_form(sum, motion_.variables(), d_.resonance->degree_ordering);
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

// A denominator of symbols and numbers only: a constant with one power of eps per symbol.
template <class Arithmetic>
auto Substitution<Arithmetic>::reciprocal_constant(const Jet& divisor) const -> Jet {
  const auto& orders = divisor.value.orders();
  EpsSeries<Number> value(orders.size());
  for (std::size_t n = 0; n < orders.size(); ++n)
    for (const auto& [powers, number] : orders[n]) value[n] += number;
  return still(Polynomial::constant(reciprocal(value, Arithmetic::inverse), motion_.variables().size()));
}

// --- functions

// Every term of a function is marked as coming out of one.
template <class Arithmetic>
auto Substitution<Arithmetic>::marked(const Polynomial& p) const -> Polynomial {
  Polynomial result = motion_.zero();
  for (std::size_t n = 0; n < p.orders().size(); ++n)
    for (const auto& [powers, value] : p.orders()[n]) {
      TrueTimePowers mark = powers;
      ++mark[motion_.variables().functions()];
      result.add(n, mark, value);
    }
  return result;
}

// Terms of degree d come in at eps^(d-1) or later.
template <class Arithmetic>
auto Substitution<Arithmetic>::by_degree(const Polynomial& p) const -> DegreeSeries<Arithmetic> {
  const TrueTimeVariables& variables = motion_.variables();
  return {p, variables.degree(), static_cast<std::size_t>(d_.resonance->expand_to) + 1, variables.size()};
}

template <class Arithmetic>
auto Substitution<Arithmetic>::composed(const Jet& argument, const DegreeSeries<Arithmetic>& value,
                                        const DegreeSeries<Arithmetic>& slope) const -> Jet {
  Jet result = still(marked(value.sum()));
  if (varied_) {
    const Polynomial factor = marked(slope.sum());
    result.by_position = factor * argument.by_position;
    result.by_velocity = factor * argument.by_velocity;
  }
  return result;
}

template <class Arithmetic>
auto Substitution<Arithmetic>::power_jet(const Jet& base, const GiNaC::numeric& exponent) const -> Jet {
  if (exponent.is_integer() && !exponent.is_negative()) {
    Jet whole = still(motion_.constant(1));
    for (int n = exponent.to_int(); n > 0; --n) whole = times(whole, base);
    return whole;
  }
  if (!DegreeSeries<Arithmetic>::moves(base.value, motion_.variables().degree())) {
    Jet whole = still(motion_.constant(1));
    const Jet inverse = reciprocal_constant(base);
    for (int n = exponent.to_int(); n < 0; ++n) whole = times(whole, inverse);
    return whole;
  }
  const DegreeSeries<Arithmetic> u = by_degree(base.value);
  const auto raised = [&](const GiNaC::numeric& p) {
    EpsSeries<Number> lead = eps_power(Number(1), 0, u.at_rest().size());  // of what is 1 at rest
    if (p.is_integer())
      for (int n = p.to_int(); n < 0; ++n) lead = product(lead, reciprocal(u.at_rest(), Arithmetic::inverse));
    return u.power(arithmetic_.number(p), lead);
  };
  return composed(base, raised(exponent), raised(exponent - 1).scaled(arithmetic_.number(exponent)));
}

template <class Arithmetic>
auto Substitution<Arithmetic>::function_jet(const std::string& name, const Jet& argument) const -> Jet {
  const DegreeSeries<Arithmetic> u = by_degree(argument.value);
  const EpsSeries<Number> one = eps_power(Number(1), 0, argument.value.orders().size());
  const Number minus = -Number(1);
  if (name == "exp") {
    const auto pair = u.second_order(1, 1, 1);
    return composed(argument, pair.f, pair.g);
  }
  if (name == "log") return composed(argument, u.logarithm(), u.power(minus, one));
  if (name == "atan") {
    DegreeSeries<Arithmetic> slope = u.arc_tangent();  // cos(atan(u))^2
    slope = slope.second_order(1, 0, -1).f;
    return composed(argument, u.arc_tangent(), slope * slope);
  }
  const bool hyperbolic = name.back() == 'h';
  const auto pair = u.second_order(0, 1, hyperbolic ? 1 : -1);  // sine and cosine
  if (name == "sin" || name == "sinh") return composed(argument, pair.f, pair.g);
  if (name == "cos" || name == "cosh")
    return composed(argument, pair.g, pair.f.scaled(hyperbolic ? Number(1) : minus));
  const DegreeSeries<Arithmetic> inverse = pair.g.power(minus, one);
  return composed(argument, u.riccati(hyperbolic ? -1 : 1), inverse * inverse);
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
      return times(jet(e.operands[0], source), power_jet(jet(e.operands[1], source), -1));
    case Expression::Kind::power:
      return power_jet(jet(e.operands[0], source),
                       GiNaC::ex_to<GiNaC::numeric>(formula_value(e.operands[1], source, [](const Expression&) {
                         return GiNaC::ex(0);  // an exponent holds no symbols
                       })));
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
  if (e.text == "sqrt") return power_jet(jet(e.operands[0], source), GiNaC::numeric(1, 2));
  if (smooth_kind(e.text)) {
    const std::vector<std::string> symbols = identifiers(e);
    if (std::find(symbols.begin(), symbols.end(), "t") != symbols.end()) return still(clock(e, source));
    return function_jet(e.text, jet(e.operands[0], source));
  }
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
