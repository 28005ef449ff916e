#include "perturb/true_time_motion.hpp"

#include <cmath>
#include <cstdlib>

#include "perturb/solved_frequencies.hpp"

namespace secular {
namespace {

// Rounding of floating numbers, relative to the largest coefficient.
constexpr double rounding = 1e-12;

template <class Arithmetic>
bool is_multiple(const GradedPolynomial<typename Arithmetic::Number>& x,
                 const GradedPolynomial<typename Arithmetic::Number>& of) {
  using Number = typename Arithmetic::Number;
  std::optional<Number> ratio;
  double scale = 0;
  for (std::size_t n = 0; n < of.orders().size(); ++n)
    for (const auto& [powers, value] : of.orders()[n]) {
      const auto found = x.orders()[n].find(powers);
      if (found == x.orders()[n].end()) {
        if (value == Number{}) continue;
        return false;
      }
      if (!ratio && value != Number{}) ratio = found->second * Arithmetic::inverse(value);
      if constexpr (Arithmetic::floating) scale = std::max(scale, std::abs(found->second));
    }
  if (!ratio) return false;
  GradedPolynomial<Number> difference = x;
  for (std::size_t n = 0; n < of.orders().size(); ++n)
    for (const auto& [powers, value] : of.orders()[n]) difference.add(n, powers, -(*ratio * value));
  for (const auto& terms : difference.orders())
    for (const auto& [powers, value] : terms) {
      if constexpr (Arithmetic::floating) {
        if (std::abs(value) > rounding * scale) return false;
      } else if (value != Number{}) {
        return false;
      }
    }
  return true;
}

}  // namespace

template <class Arithmetic>
TrueTimeMotion<Arithmetic>::TrueTimeMotion(const Derivation& d, Arithmetic arithmetic)
    : model_(d.model),
      arithmetic_(arithmetic),
      size_(static_cast<std::size_t>(d.resonance->expand_to) + 1),
      variables_{d.model->frequency_count(), d.model->modes.size()},
      frequency_(solved_frequencies(*d.model, *d.resonance, arithmetic)) {
  for (std::size_t k = 0; k < variables_.modes; ++k) {
    amplitude_rate_.push_back(in_true_time(d, d.slow_derivative[k], false));
    conjugate_rate_.push_back(conjugated<Arithmetic>(amplitude_rate_.back(), variables_));
  }
  for (std::size_t k = 0; k < variables_.modes; ++k) {
    const Polynomial position = in_true_time(d, d.response[k], true);
    const Polynomial velocity = time_derivative(position);
    motion_.push_back({position, velocity, time_derivative(velocity)});
  }
}

template <class Arithmetic>
auto TrueTimeMotion<Arithmetic>::constant(const Number& value, std::size_t order) const -> Polynomial {
  return Polynomial::constant(eps_power(value, order, size_), variables_.size());
}

template <class Arithmetic>
auto TrueTimeMotion<Arithmetic>::symbol(const std::string& name) const -> Series {
  for (std::size_t i = 0; i < variables_.frequencies; ++i)
    if (model_->frequency_name(i) == name) return frequency_[i];
  return eps_power(arithmetic_.symbol(name), 0, size_);
}

template <class Arithmetic>
auto TrueTimeMotion<Arithmetic>::coefficient(const GiNaC::ex& e) const -> Series {
  const auto number = [&](const Number& value) { return eps_power(value, 0, size_); };
  if (GiNaC::is_exactly_a<GiNaC::numeric>(e)) return number(arithmetic_.number(GiNaC::ex_to<GiNaC::numeric>(e)));
  if (GiNaC::is_exactly_a<GiNaC::constant>(e)) return number(arithmetic_.pi());
  if (GiNaC::is_exactly_a<GiNaC::add>(e)) {
    Series sum(size_);
    for (std::size_t i = 0; i < e.nops(); ++i) {
      const Series term = coefficient(e.op(i));
      for (std::size_t n = 0; n < size_; ++n) sum[n] += term[n];
    }
    return sum;
  }
  if (GiNaC::is_exactly_a<GiNaC::mul>(e)) {
    Series whole = number(1);
    for (std::size_t i = 0; i < e.nops(); ++i) whole = product(whole, coefficient(e.op(i)));
    return whole;
  }
  const auto known = computed_.find(e);
  return known != computed_.end() ? known->second : computed_.emplace(e, computed(e)).first->second;
}

template <class Arithmetic>
auto TrueTimeMotion<Arithmetic>::computed(const GiNaC::ex& e) const -> Series {
  if (GiNaC::is_a<GiNaC::symbol>(e)) return symbol(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
  Series whole = eps_power(Number(1), 0, size_);
  const int exponent = GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int();
  Series base = coefficient(e.op(0));
  if (exponent < 0) base = reciprocal(base, Arithmetic::inverse);
  for (int n = std::abs(exponent); n > 0; --n) whole = product(whole, base);
  return whole;
}

template <class Arithmetic>
auto TrueTimeMotion<Arithmetic>::in_true_time(const Derivation& d, const FieldSeries& fields, bool coordinate) const
    -> Polynomial {
  const FieldLayout& layout = d.layout;
  Polynomial sum = zero();
  for (std::size_t n = 0; n < fields.size(); ++n)
    for (const auto& [key, value] : fields[n].terms()) {
      TrueTimePowers powers(variables_.size(), 0);
      const Phase phase = d.full_phase(key);
      for (std::size_t i = 0; i < phase.size(); ++i) powers[i] = phase[i];
      for (std::size_t k = 0; k < layout.modes; ++k) {
        powers[variables_.amplitude(k)] = key[layout.amplitude(k)];
        powers[variables_.conjugate(k)] = key[layout.conjugate(k)];
        powers[variables_.modulus(k)] = key[layout.modulus(k)];
      }
      if (coordinate) powers[variables_.degree()] = 1;
      Series factor = coefficient(value);
      for (std::size_t j = 0; j < layout.excitations; ++j)
        for (int p = 0; p < key[layout.forcing(j)]; ++p)
          factor = product(factor, symbol(model_->excitations[j].amplitude));
      for (std::size_t m = 0; n + m < size_; ++m) sum.add(n + m, powers, factor[m]);
    }
  return sum;
}

template <class Arithmetic>
auto TrueTimeMotion<Arithmetic>::time_derivative(const Polynomial& p) const -> Polynomial {
  Polynomial sum = zero();
  const auto through = [&](std::size_t order, TrueTimePowers powers, const Number& value, std::size_t variable,
                           int lowered, const Polynomial& rate) {
    powers[variable] -= lowered;
    for (std::size_t n = 0; order + n < size_; ++n)
      for (const auto& [factor, number] : rate.orders()[n]) {
        TrueTimePowers whole = powers;
        for (std::size_t v = 0; v < whole.size(); ++v) whole[v] += factor[v];
        sum.add(order + n, whole, value * number);
      }
  };
  for (std::size_t n = 0; n < size_; ++n)
    for (const auto& [powers, value] : p.orders()[n]) {
      Series frequency(size_);
      for (std::size_t i = 0; i < variables_.frequencies; ++i)
        if (powers[i] != 0)
          for (std::size_t m = 0; m < size_; ++m) frequency[m] += Number(powers[i]) * frequency_[i][m];
      for (std::size_t m = 0; n + m < size_; ++m)
        if (frequency[m] != Number{}) sum.add(n + m, powers, Arithmetic::i() * value * frequency[m]);
      for (std::size_t k = 0; k < variables_.modes; ++k) {
        const std::size_t amplitude = variables_.amplitude(k), conjugate = variables_.conjugate(k),
                          modulus = variables_.modulus(k);
        if (const int power = powers[amplitude])
          through(n, powers, Number(power) * value, amplitude, 1, amplitude_rate_[k]);
        if (const int power = powers[conjugate])
          through(n, powers, Number(power) * value, conjugate, 1, conjugate_rate_[k]);
        if (const int power = powers[modulus]) {
          // d|A|/dt = (conj(A) dA/dt + A d conj(A)/dt)/(2|A|)
          const Number half = Number(power) * Arithmetic::inverse(Number(2)) * value;
          TrueTimePowers beside = powers;
          ++beside[conjugate];
          through(n, beside, half, modulus, 2, amplitude_rate_[k]);
          beside = powers;
          ++beside[amplitude];
          through(n, beside, half, modulus, 2, conjugate_rate_[k]);
        }
      }
    }
  return sum;
}

template <class Arithmetic>
std::optional<std::size_t> TrueTimeMotion<Arithmetic>::mode_of(const Polynomial& x) const {
  for (std::size_t k = 0; k < variables_.modes; ++k)
    for (std::size_t derivative = 0; derivative < 2; ++derivative)
      if (is_multiple<Arithmetic>(x, motion_[k][derivative])) return k;
  return std::nullopt;
}

template class TrueTimeMotion<ExactArithmetic>;
template class TrueTimeMotion<FloatingArithmetic>;

}  // namespace secular
