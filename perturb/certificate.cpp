#include "perturb/certificate.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "perturb/formula_value.hpp"
#include "perturb/graded_polynomial.hpp"
#include "perturb/nonsmooth.hpp"
#include "perturb/prime_field.hpp"

namespace secular {
namespace {

// What the substitution needs of numbers, exact (prime field) or floating.
struct Exact {
  using Number = PrimeFieldComplex;
  static constexpr bool floating = false;
  std::uint64_t draw;
  Number number(const GiNaC::numeric& value) const { return Number(value); }
  Number pi() const { return random_value("Pi", draw); }
  Number symbol(const std::string& name) const { return random_value(name, draw); }
  static Number i() { return Number::i(); }
  static Number conjugate(const Number& value) { return value.conjugate(); }
  static Number inverse(const Number& value) { return value.inverse(); }
};

struct Floating {
  using Number = std::complex<double>;
  static constexpr bool floating = true;
  std::uint64_t draw;
  Number number(const GiNaC::numeric& value) const { return {value.real().to_double(), value.imag().to_double()}; }
  Number pi() const { return std::numbers::pi; }
  Number symbol(const std::string& name) const { return 0.5 + random_value(name, draw).fraction(); }
  static Number i() { return {0, 1}; }
  static Number conjugate(const Number& value) { return std::conj(value); }
  static Number inverse(const Number& value) { return 1.0 / value; }
};

// Highest harmonic of a nonsmooth function that the check integrates; smooth factors shift it by their degree.
constexpr int highest_integrated_harmonic = 2 * highest_nonsmooth_harmonic;

// The equations of motion as the file states them, evaluated on the expansion as a function of true time. Variables
// of the polynomials: exp(i f_j t) of every frequency | A_k | conj A_k | |A_k| | degree in the coordinates.
template <class Kind>
class Substitution {
 public:
  using Number = typename Kind::Number;
  using Series = EpsSeries<Number>;
  using Polynomial = GradedPolynomial<Number>;
  using Powers = typename Polynomial::Powers;

  Substitution(const Derivation& d, Kind kind)
      : d_(d), model_(*d.model), kind_(kind), size_(static_cast<std::size_t>(d.resonance->expand_to) + 1) {
    solve_relations();
    for (std::size_t k = 0; k < model_.modes.size(); ++k) {
      amplitude_rate_.push_back(graded(d.slow_derivative[k]));
      conjugate_rate_.push_back(conjugated(amplitude_rate_.back()));
    }
    for (std::size_t k = 0; k < model_.modes.size(); ++k) {
      const Polynomial position = graded(d.response[k], true);
      const Polynomial velocity = time_derivative(position);
      motion_.push_back({position, velocity, time_derivative(velocity)});
    }
  }

  bool nonsmooth() const { return nonsmooth_; }

  // What is left of mode k's equation; zero everywhere if the expansion solves it.
  Polynomial residual(std::size_t k) {
    Polynomial sum(static_cast<int>(size_) - 1);
    if (model_.lagrangian) {
      const Lagrangian& lagrangian = *model_.lagrangian;
      varied_ = k;
      const Jet kinetic = jet(lagrangian.kinetic, lagrangian.kinetic_source);
      const Jet potential = jet(lagrangian.potential, lagrangian.potential_source);
      varied_.reset();
      sum += time_derivative(kinetic.by_velocity);
      sum += kinetic.by_position.negated();
      sum += potential.by_position;
      sum += jet(*model_.modes[k].force, model_.modes[k].source).value.negated();
    } else {
      const Mode& mode = model_.modes[k];
      sum += jet(mode.equation->left, mode.source).value;
      sum += jet(mode.equation->right.front(), mode.source).value.negated();
    }
    return d_.resonance->degree_ordering ? ordered_by_degree(sum) : normal_form(sum);
  }

  // Sum over amplitude powers at random amplitudes, by harmonic.
  std::map<Powers, Number> at_amplitudes(const typename Polynomial::Terms& terms) const {
    std::map<Powers, Number> harmonics;
    for (const auto& [powers, value] : terms) {
      Number whole = value;
      for (std::size_t k = 0; k < model_.modes.size(); ++k) {
        const Number a = amplitude(k);
        whole *= std::pow(a, powers[at_amplitude(k)]) * std::pow(std::conj(a), powers[at_conjugate(k)]) *
                 std::pow(std::abs(a), powers[at_modulus(k)]);
      }
      harmonics[Powers(powers.begin(), powers.begin() + static_cast<std::ptrdiff_t>(model_.frequency_count()))] +=
          whole;
    }
    return harmonics;
  }

  // Largest harmonic of mode k's acceleration: the scale of its equation.
  double largest_acceleration(std::size_t k) const {
    double largest = 0;
    for (const auto& terms : motion_[k][2].orders())
      for (const auto& [waves, value] : at_amplitudes(terms)) largest = std::max(largest, std::abs(value));
    return largest;
  }

  bool has_odd_modulus(const Powers& powers) const {
    for (std::size_t k = 0; k < model_.modes.size(); ++k)
      if (powers[at_modulus(k)] != 0) return true;
    return false;
  }

  std::string text(const Powers& powers) const {
    std::string product, phase;
    const auto factor = [&](const std::string& name, int power) {
      if (power == 0) return;
      product += (product.empty() ? "" : "*") + name + (power == 1 ? "" : "^" + std::to_string(power));
    };
    for (std::size_t k = 0; k < model_.modes.size(); ++k) {
      factor("A_" + model_.modes[k].coordinate, powers[at_amplitude(k)]);
      factor("conj(A_" + model_.modes[k].coordinate + ")", powers[at_conjugate(k)]);
      factor("abs(A_" + model_.modes[k].coordinate + ")", powers[at_modulus(k)]);
    }
    for (std::size_t i = 0; i < model_.frequency_count(); ++i) {
      if (powers[i] == 0) continue;
      phase += (powers[i] < 0 ? "-" : (phase.empty() ? "" : "+")) +
               (std::abs(powers[i]) == 1 ? "" : std::to_string(std::abs(powers[i])) + "*") +
               model_.frequency_name(i);
    }
    return (product.empty() ? "" : product + "*") + "exp(i*(" + (phase.empty() ? "0" : phase) + ")*t)";
  }

 private:
  // A value with its derivatives by the varied mode's coordinate and velocity (Lagrange's equations).
  struct Jet {
    Polynomial value, by_position, by_velocity;
  };

  std::size_t at_amplitude(std::size_t k) const { return model_.frequency_count() + k; }
  std::size_t at_conjugate(std::size_t k) const { return at_amplitude(model_.modes.size()) + k; }
  std::size_t at_modulus(std::size_t k) const { return at_conjugate(model_.modes.size()) + k; }
  std::size_t at_degree() const { return at_modulus(model_.modes.size()); }
  std::size_t variables() const { return at_degree() + 1; }

  Number amplitude(std::size_t k) const requires Kind::floating {
    const std::string& name = model_.modes[k].coordinate;
    return std::polar(kind_.symbol("abs " + name).real(),
                      2 * std::numbers::pi * kind_.symbol("arg " + name).real());
  }

  Series series(const Number& value, std::size_t order = 0) const {
    Series result(size_);
    if (order < size_) result[order] = value;
    return result;
  }
  Polynomial zero() const { return Polynomial(static_cast<int>(size_) - 1); }
  Polynomial constant(const Number& value, std::size_t order = 0) const {
    return Polynomial::constant(series(value, order), variables());
  }

  // --- frequencies: each relation gives one of them in terms of the others and eps^n*detuning

  void solve_relations() {
    const std::size_t count = model_.frequency_count();
    for (std::size_t i = 0; i < count; ++i) frequency_.push_back(series(kind_.symbol(model_.frequency_name(i))));
    struct Row {
      std::vector<Number> multiples;
      Series right;
    };
    std::vector<Row> rows;
    for (const ResonanceRelation& relation : d_.resonance->relations) {
      Row row{std::vector<Number>(count), Series(size_)};
      for (std::size_t i = 0; i < relation.multiples.size(); ++i)
        row.multiples[i] = kind_.number(relation.multiples[i]);
      const auto order = static_cast<std::size_t>(relation.order);
      if (!relation.detuning.empty() && order < size_)
        row.right[order] = kind_.number(relation.coefficient) * kind_.symbol(relation.detuning);
      rows.push_back(std::move(row));
    }
    std::vector<std::pair<std::size_t, std::size_t>> pivots;  // row, frequency
    for (std::size_t r = 0; r < rows.size(); ++r) {
      std::size_t column = count;  // the last frequency not yet solved for, so that excitations come first
      while (column > 0 && rows[r].multiples[column - 1] == Number{}) --column;
      if (column == 0) continue;  // the lattice has refused dependent relations
      --column;
      const Number scale = Kind::inverse(rows[r].multiples[column]);
      for (Number& multiple : rows[r].multiples) multiple *= scale;
      for (Number& value : rows[r].right) value *= scale;
      for (std::size_t other = 0; other < rows.size(); ++other) {
        if (other == r || rows[other].multiples[column] == Number{}) continue;
        const Number lead = rows[other].multiples[column];
        for (std::size_t i = 0; i < count; ++i) rows[other].multiples[i] += -(lead * rows[r].multiples[i]);
        for (std::size_t n = 0; n < size_; ++n) rows[other].right[n] += -(lead * rows[r].right[n]);
        rows[other].multiples[column] = Number{};
      }
      pivots.emplace_back(r, column);
    }
    const std::vector<Series> free = frequency_;
    for (const auto& [r, column] : pivots) {
      Series value = rows[r].right;
      for (std::size_t i = 0; i < count; ++i)
        if (i != column) value[0] += -(rows[r].multiples[i] * free[i][0]);
      frequency_[column] = value;
    }
  }

  // A coefficient of the expansion, whose natural and excitation frequencies move with the detunings.
  Series coefficient(const GiNaC::ex& e) const {
    if (GiNaC::is_exactly_a<GiNaC::numeric>(e)) return series(kind_.number(GiNaC::ex_to<GiNaC::numeric>(e)));
    if (GiNaC::is_a<GiNaC::symbol>(e)) return symbol(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
    if (GiNaC::is_exactly_a<GiNaC::constant>(e)) return series(kind_.pi());
    if (GiNaC::is_exactly_a<GiNaC::add>(e)) {
      Series sum(size_);
      for (std::size_t i = 0; i < e.nops(); ++i) {
        const Series term = coefficient(e.op(i));
        for (std::size_t n = 0; n < size_; ++n) sum[n] += term[n];
      }
      return sum;
    }
    if (GiNaC::is_exactly_a<GiNaC::mul>(e)) {
      Series whole = series(1);
      for (std::size_t i = 0; i < e.nops(); ++i) whole = product(whole, coefficient(e.op(i)));
      return whole;
    }
    const int exponent = GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int();
    Series base = coefficient(e.op(0)), whole = series(1);
    if (exponent < 0) base = reciprocal(base, Kind::inverse);
    for (int n = std::abs(exponent); n > 0; --n) whole = product(whole, base);
    return whole;
  }

  Series symbol(const std::string& name) const {
    for (std::size_t i = 0; i < model_.frequency_count(); ++i)
      if (model_.frequency_name(i) == name) return frequency_[i];
    return series(kind_.symbol(name));
  }

  // --- the expansion as a function of true time

  Polynomial graded(const FieldSeries& fields, bool coordinate = false) const {
    const FieldLayout& layout = d_.layout;
    Polynomial sum = zero();
    for (std::size_t n = 0; n < fields.size(); ++n)
      for (const auto& [key, value] : fields[n].terms()) {
        Powers powers(variables(), 0);
        const Phase phase = d_.full_phase(key);
        for (std::size_t i = 0; i < phase.size(); ++i) powers[i] = static_cast<std::int8_t>(phase[i]);
        for (std::size_t k = 0; k < layout.modes; ++k) {
          powers[at_amplitude(k)] = static_cast<std::int8_t>(key[layout.amplitude(k)]);
          powers[at_conjugate(k)] = static_cast<std::int8_t>(key[layout.conjugate(k)]);
          powers[at_modulus(k)] = static_cast<std::int8_t>(key[layout.modulus(k)]);
        }
        if (coordinate) powers[at_degree()] = 1;
        Series factor = coefficient(value);
        for (std::size_t j = 0; j < layout.excitations; ++j)
          for (int p = 0; p < key[layout.forcing(j)]; ++p)
            factor = product(factor, series(kind_.symbol(model_.excitations[j].amplitude)));
        for (std::size_t m = 0; n + m < size_; ++m) sum.add(n + m, powers, factor[m]);
      }
    return sum;
  }

  Polynomial conjugated(const Polynomial& p) const {
    Polynomial result = zero();
    for (std::size_t n = 0; n < size_; ++n)
      for (const auto& [powers, value] : p.orders()[n]) {
        Powers mirrored = powers;
        for (std::size_t i = 0; i < model_.frequency_count(); ++i)
          mirrored[i] = static_cast<std::int8_t>(-powers[i]);
        for (std::size_t k = 0; k < model_.modes.size(); ++k)
          std::swap(mirrored[at_amplitude(k)], mirrored[at_conjugate(k)]);
        result.add(n, mirrored, Kind::conjugate(value));
      }
    return result;
  }

  // d/dt by the chain rule through everything that moves.
  Polynomial time_derivative(const Polynomial& p) const {
    Polynomial sum = zero();
    const auto through = [&](std::size_t order, Powers powers, const Number& value, std::size_t variable,
                             int lowered, const Polynomial& rate) {
      powers[variable] = static_cast<std::int8_t>(powers[variable] - lowered);
      for (std::size_t n = 0; order + n < size_; ++n)
        for (const auto& [factor, number] : rate.orders()[n]) {
          Powers whole = powers;
          for (std::size_t v = 0; v < whole.size(); ++v) whole[v] = static_cast<std::int8_t>(whole[v] + factor[v]);
          sum.add(order + n, whole, value * number);
        }
    };
    for (std::size_t n = 0; n < size_; ++n)
      for (const auto& [powers, value] : p.orders()[n]) {
        Series frequency(size_);
        for (std::size_t i = 0; i < model_.frequency_count(); ++i)
          if (powers[i] != 0)
            for (std::size_t m = 0; m < size_; ++m) frequency[m] += Number(powers[i]) * frequency_[i][m];
        for (std::size_t m = 0; n + m < size_; ++m)
          if (frequency[m] != Number{}) sum.add(n + m, powers, Kind::i() * value * frequency[m]);
        for (std::size_t k = 0; k < model_.modes.size(); ++k) {
          if (const int power = powers[at_amplitude(k)])
            through(n, powers, Number(power) * value, at_amplitude(k), 1, amplitude_rate_[k]);
          if (const int power = powers[at_conjugate(k)])
            through(n, powers, Number(power) * value, at_conjugate(k), 1, conjugate_rate_[k]);
          if (const int power = powers[at_modulus(k)]) {
            // d|A|/dt = (conj(A) dA/dt + A d conj(A)/dt)/(2|A|)
            const Number half = Number(power) * Kind::inverse(Number(2)) * value;
            Powers beside = powers;
            ++beside[at_conjugate(k)];
            through(n, beside, half, at_modulus(k), 2, amplitude_rate_[k]);
            beside = powers;
            ++beside[at_amplitude(k)];
            through(n, beside, half, at_modulus(k), 2, conjugate_rate_[k]);
          }
        }
      }
    return sum;
  }

  // |A|^2 = A conj(A), used so that |A| is left to the power 0 or 1; the degree is dropped.
  Powers normal_form(Powers powers) const {
    for (std::size_t k = 0; k < model_.modes.size(); ++k) {
      auto& modulus = powers[at_modulus(k)];
      const int odd = std::abs(modulus % 2), pairs = (modulus - odd) / 2;
      powers[at_amplitude(k)] = static_cast<std::int8_t>(powers[at_amplitude(k)] + pairs);
      powers[at_conjugate(k)] = static_cast<std::int8_t>(powers[at_conjugate(k)] + pairs);
      modulus = static_cast<std::int8_t>(odd);
    }
    powers[at_degree()] = 0;
    return powers;
  }
  Polynomial normal_form(const Polynomial& p) const {
    Polynomial result = zero();
    for (std::size_t n = 0; n < size_; ++n)
      for (const auto& [powers, value] : p.orders()[n]) result.add(n, normal_form(powers), value);
    return result;
  }
  // A term of degree d in the coordinates carries eps^(d-1).
  Polynomial ordered_by_degree(const Polynomial& p) const {
    Polynomial result = zero();
    for (std::size_t n = 0; n < size_; ++n)
      for (const auto& [powers, value] : p.orders()[n])
        result.add(n + static_cast<std::size_t>(std::max(0, powers[at_degree()] - 1)), normal_form(powers), value);
    return result;
  }

  // --- the original equations, node by node

  Jet still(Polynomial value) const { return {std::move(value), zero(), zero()}; }
  Jet times(const Jet& a, const Jet& b) const {
    Jet result = still(a.value * b.value);
    if (varied_) {
      result.by_position = a.by_position * b.value;
      result.by_position += a.value * b.by_position;
      result.by_velocity = a.by_velocity * b.value;
      result.by_velocity += a.value * b.by_velocity;
    }
    return result;
  }
  static void accumulate(Jet& sum, const Jet& addend) {
    sum.value += addend.value;
    sum.by_position += addend.by_position;
    sum.by_velocity += addend.by_velocity;
  }

  Jet jet(const Expression& e, const FormulaSource& source) {
    switch (e.kind) {
      case Expression::Kind::number:
        return still(constant(kind_.number(exact_number(e.text))));
      case Expression::Kind::symbol:
        return symbol_jet(e);
      case Expression::Kind::sum: {
        Jet sum = still(zero());
        for (const Expression& operand : e.operands) accumulate(sum, jet(operand, source));
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
        Jet base = jet(e.operands[0], source), whole = still(constant(1));
        if (exponent < 0) base = reciprocal_constant(base);
        for (int n = std::abs(exponent); n > 0; --n) whole = times(whole, base);
        return whole;
      }
      case Expression::Kind::negation: {
        Jet inner = jet(e.operands[0], source);
        return {inner.value.negated(), inner.by_position.negated(), inner.by_velocity.negated()};
      }
      case Expression::Kind::call:
        break;
    }
    if (e.text == "cos" || e.text == "sin") return still(clock(e, source));
    if (e.text == "D") return derived(jet(e.operands[0], source));
    if (e.text == "D2") {
      // The coordinates' own accelerations are at hand.
      if (e.operands[0].kind == Expression::Kind::symbol)
        for (std::size_t k = 0; k < model_.modes.size(); ++k)
          if (model_.modes[k].coordinate == e.operands[0].text) return still(motion_[k][2]);
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
      const Polynomial distance = alone ? function(true, difference) : zero();
      sum += e.text == "max" ? distance : distance.negated();
      return still(sum * constant(Kind::inverse(Number(2))));
    }
    return still(alone ? function(e.text == "abs", argument) : zero());
  }

  // The mode whose displacement or velocity, times a number, is x.
  std::optional<std::size_t> mode_of(const Polynomial& x) const {
    for (std::size_t k = 0; k < model_.modes.size(); ++k)
      for (std::size_t derivative = 0; derivative < 2; ++derivative)
        if (is_multiple(x, motion_[k][derivative])) return k;
    return std::nullopt;
  }
  static bool is_multiple(const Polynomial& x, const Polynomial& of) {
    std::optional<Number> ratio;
    double scale = 0;
    for (std::size_t n = 0; n < of.orders().size(); ++n)
      for (const auto& [powers, value] : of.orders()[n]) {
        const auto found = x.orders()[n].find(powers);
        if (found == x.orders()[n].end()) {
          if (value == Number{}) continue;
          return false;
        }
        if (!ratio && value != Number{}) ratio = found->second * Kind::inverse(value);
        if constexpr (Kind::floating) scale = std::max(scale, std::abs(found->second));
      }
    if (!ratio) return false;
    Polynomial difference = x;
    for (std::size_t n = 0; n < of.orders().size(); ++n)
      for (const auto& [powers, value] : of.orders()[n]) difference.add(n, powers, -(*ratio * value));
    for (const auto& terms : difference.orders())
      for (const auto& [powers, value] : terms) {
        if constexpr (Kind::floating) {
          if (std::abs(value) > 1e-12 * scale) return false;
        } else if (value != Number{}) {
          return false;
        }
      }
    return true;
  }

  // Denominators hold symbols and numbers only: a constant with one power of eps per symbol.
  Jet reciprocal_constant(const Jet& divisor) const {
    Series value(size_);
    for (std::size_t n = 0; n < size_; ++n)
      for (const auto& [powers, number] : divisor.value.orders()[n]) value[n] += number;
    return still(Polynomial::constant(reciprocal(value, Kind::inverse), variables()));
  }

  Jet symbol_jet(const Expression& e) const {
    for (std::size_t k = 0; k < model_.modes.size(); ++k)
      if (model_.modes[k].coordinate == e.text) {
        Jet coordinate = still(motion_[k][0]);
        if (varied_ == k) coordinate.by_position = constant(1);
        return coordinate;
      }
    if (e.text == "Pi") return still(constant(kind_.pi()));
    const auto entry = d_.resonance->order.find(e.text);
    if (entry != d_.resonance->order.end() && entry->second > 0)
      return still(constant(kind_.symbol(e.text), static_cast<std::size_t>(entry->second)));
    return still(Polynomial::constant(symbol(e.text), variables()));
  }

  // d/dt of f(q, q'): its derivative by q' is df/dq, by q the time derivative of df/dq.
  Jet derived(const Jet& inner) const {
    Jet result = still(time_derivative(inner.value));
    if (varied_) {
      result.by_position = time_derivative(inner.by_position);
      result.by_velocity = inner.by_position;
      result.by_velocity += time_derivative(inner.by_velocity);
    }
    return result;
  }

  // cos(n Omega t), sin(n Omega t).
  Polynomial clock(const Expression& e, const FormulaSource& source) const {
    Polynomial wave = zero();
    if (!d_.resonance->excited) return wave;
    const GiNaC::symbol time("t");
    const GiNaC::ex phase = formula_value(e.operands[0], source, [&](const Expression& s) -> GiNaC::ex {
      return s.text == "t" ? GiNaC::ex(time) : model_.symbols.at(s.text);
    });
    for (std::size_t i = model_.modes.size(); i < model_.frequency_count(); ++i) {
      const GiNaC::ex multiple = (phase / (model_.frequency(i) * time)).normal();
      if (!GiNaC::is_a<GiNaC::numeric>(multiple)) continue;
      Powers powers(variables(), 0);
      powers[i] = static_cast<std::int8_t>(GiNaC::ex_to<GiNaC::numeric>(multiple).to_int());
      const bool cosine = e.text == "cos";
      const Number half = Kind::inverse(Number(2)), turned = cosine ? half : -(half * Kind::i());
      wave.add(0, powers, turned);
      powers[i] = static_cast<std::int8_t>(-powers[i]);
      wave.add(0, powers, cosine ? turned : -turned);
    }
    return wave;
  }

  // abs(x) or sgn(x). Without a closed Fourier series it is a quadrature term, which the expansion leaves open:
  // zero. Exact arithmetic leaves it out too: it makes odd powers of |A| only, which are checked by numbers.
  Polynomial function(bool absolute, const Polynomial& x) {
    Polynomial result = zero();
    const std::optional<std::size_t> mode = mode_of(x);
    if (!mode || d_.resonance->mode_at_rest[*mode] || d_.response[*mode][0].terms().size() > 2) return result;
    nonsmooth_ = true;
    if constexpr (Kind::floating) {
      Number phasor{};
      for (const auto& [waves, value] : at_amplitudes(x.orders()[0]))
        if (waves[*mode] == 1) phasor = 2.0 * value;
      const auto put = [&](std::size_t order, const Powers& waves, int harmonic, const Number& value) {
        Powers powers(variables(), 0);
        std::copy(waves.begin(), waves.end(), powers.begin());
        powers[*mode] = static_cast<std::int8_t>(powers[*mode] + harmonic);
        if (absolute) powers[at_degree()] = 1;
        result.add(order, powers, value);
      };
      const Powers unmoved(model_.frequency_count(), 0);
      for (int n = -highest_integrated_harmonic; n <= highest_integrated_harmonic; ++n) {
        put(0, unmoved, n, fourier(phasor, absolute, n));
        if (!absolute || size_ < 2) continue;
        const Number slope = fourier(phasor, false, n);  // |x0 + eps x1| = |x0| + eps sgn(x0) x1 + ...
        for (const auto& [waves, value] : at_amplitudes(x.orders()[1])) put(1, waves, n, slope * value);
      }
    }
    return result;
  }

  // Coefficient of exp(i n phi) in |x| or sgn(x), x = Re(phasor exp(i phi)), integrated between the sign changes.
  static std::complex<double> fourier(std::complex<double> phasor, bool absolute, int n) {
    const auto x = [&](double phi) { return (phasor * std::polar(1.0, phi)).real(); };
    const double zero = std::numbers::pi / 2 - std::arg(phasor);
    std::complex<double> sum = 0;
    constexpr int panels = 8;  // four to each sign, 20 nodes each
    for (int panel = 0; panel < panels; ++panel) {
      const double from = zero + 2 * std::numbers::pi * panel / panels, to = from + 2 * std::numbers::pi / panels;
      const double sign = x(0.5 * (from + to)) > 0 ? 1 : -1;
      const auto integral = [&](auto part) {
        return boost::math::quadrature::gauss<double, 20>::integrate(
            [&](double phi) { return (absolute ? sign * x(phi) : sign) * part(n * phi); }, from, to);
      };
      sum += std::complex<double>(integral([](double a) { return std::cos(a); }),
                                  -integral([](double a) { return std::sin(a); }));
    }
    return sum / (2 * std::numbers::pi);
  }

  const Derivation& d_;
  const Model& model_;
  Kind kind_;
  std::size_t size_;
  std::vector<Series> frequency_;
  std::vector<Polynomial> amplitude_rate_, conjugate_rate_;
  std::vector<std::vector<Polynomial>> motion_;  // [mode][derivative]
  std::optional<std::size_t> varied_;
  bool nonsmooth_ = false;
};

// Floating check of the coefficients that nonsmooth terms touch.
void check_nonsmooth(const Derivation& d, Certificate& certificate) {
  certificate.nonsmooth_harmonics = highest_nonsmooth_harmonic;
  for (std::uint64_t draw = 11; draw < 14; ++draw) {
    Substitution<Floating> substitution(d, Floating{draw});
    for (std::size_t k = 0; k < d.model->modes.size(); ++k) {
      const auto residual = substitution.residual(k);
      const double largest = substitution.largest_acceleration(k);
      for (std::size_t n = 0; n < residual.orders().size(); ++n) {
        for (const auto& [waves, value] : substitution.at_amplitudes(residual.orders()[n])) {
          const bool compared = std::all_of(waves.begin(), waves.end(),
                                            [&](int w) { return std::abs(w) <= d.nonsmooth_harmonics[n]; });
          if (!compared) continue;
          ++certificate.coefficients_checked;
          const double error = std::abs(value) / largest;
          certificate.nonsmooth_error = std::max(certificate.nonsmooth_error, error);
          if (error < 1e-10) continue;
          certificate.holds = false;
          certificate.remainders.push_back("equation of " + d.model->modes[k].coordinate + ", eps^" +
                                           std::to_string(n) + ", harmonic of a nonsmooth term");
        }
      }
    }
  }
}

}  // namespace

Certificate certify(const Derivation& d) {
  Certificate certificate;
  certificate.order = d.resonance->expand_to;
  certificate.holds = true;
  bool nonsmooth = false;
  for (const std::uint64_t draw : {std::uint64_t{1}, std::uint64_t{2}}) {
    Substitution<Exact> substitution(d, Exact{draw});
    certificate.coefficients_checked = 0;
    for (std::size_t k = 0; k < d.model->modes.size(); ++k) {
      const auto residual = substitution.residual(k);
      for (std::size_t n = 0; n < residual.orders().size(); ++n)
        for (const auto& [powers, value] : residual.orders()[n]) {
          if (substitution.has_odd_modulus(powers)) continue;
          ++certificate.coefficients_checked;
          if (value.is_zero()) continue;
          certificate.holds = false;
          const std::string left = "equation of " + d.model->modes[k].coordinate + ", eps^" + std::to_string(n) +
                                   ", coefficient of " + substitution.text(powers);
          if (std::find(certificate.remainders.begin(), certificate.remainders.end(), left) ==
              certificate.remainders.end())
            certificate.remainders.push_back(left);
        }
    }
    nonsmooth = substitution.nonsmooth();
  }
  if (nonsmooth) check_nonsmooth(d, certificate);
  return certificate;
}

}  // namespace secular
