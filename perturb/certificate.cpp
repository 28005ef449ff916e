#include "perturb/certificate.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "input/input_error.hpp"
#include "perturb/formula_value.hpp"
#include "perturb/nonsmooth.hpp"

namespace secular {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

// Coefficients of eps^0, eps^1, ..., eps^N, each expanded.
using Series = std::vector<ex>;

struct NonsmoothCall {
  symbol value;  // stands for abs(argument) or sgn(argument)
  bool absolute = true;
  ex argument;  // in q, qd
};

// The equations as the file states them, in symbols for displacement, velocity, acceleration and excitation. Reads
// the parsed text itself: nothing here uses TermSum or Field products.
class Substitution {
 public:
  explicit Substitution(const Derivation& d) : d_(d), model_(*d.model), order_(d.resonance->expand_to) {
    const auto numbered = [](const char* stem, std::size_t i) { return symbol(stem + std::to_string(i)); };
    for (std::size_t k = 0; k < model_.modes.size(); ++k) {
      q_.push_back({numbered("q", k), numbered("qd", k), numbered("qdd", k)});
      amplitude_.push_back(numbered("A", k));
      conjugate_.push_back(numbered("Ac", k));
      modulus_.push_back(numbered("R", k));
    }
    for (std::size_t j = 0; j < model_.excitations.size(); ++j)
      u_.push_back({numbered("u", j), numbered("ud", j), numbered("udd", j)});
    for (std::size_t i = 0; i < model_.frequency_count(); ++i) wave_.push_back(numbered("E", i));
    solve_relations();
  }

  Certificate certify() {
    Certificate certificate;
    certificate.order = order_;
    certificate.holds = true;
    const std::vector<ex> equations = equations_in_symbols();
    make_response();
    for (std::size_t k = 0; k < equations.size(); ++k) check_equation(k, equations[k], certificate);
    return certificate;
  }

 private:
  // --- frequencies
  // ------------------------------------------------------------------------------------------------- Each relation
  // gives one frequency in terms of the others and eps^n*detuning, solved by GiNaC's lsolve.
  void solve_relations() {
    GiNaC::lst equations, unknowns;
    std::vector<bool> used(model_.frequency_count(), false);
    for (const ResonanceRelation& relation : d_.resonance->relations) {
      ex sum = 0;
      for (std::size_t i = 0; i < relation.multiples.size(); ++i)
        sum += relation.multiples[i] * model_.frequency(i);
      if (!relation.detuning.empty())
        sum -= relation.coefficient * GiNaC::pow(eps_, relation.order) * model_.symbols.at(relation.detuning);
      equations.append(sum == 0);
      for (std::size_t i = relation.multiples.size(); i-- > 0;) {
        if (relation.multiples[i] == 0 || used[i]) continue;
        used[i] = true;
        unknowns.append(model_.frequency(i));
        break;
      }
    }
    if (unknowns.nops() == 0) return;
    const ex solution = GiNaC::lsolve(equations, unknowns);
    for (std::size_t i = 0; i < solution.nops(); ++i)
      frequency_values_[solution.op(i).lhs()] = solution.op(i).rhs();
  }

  // A coefficient with dependent frequencies put in, as a series in eps from eps^first on.
  Series graded_coefficient(const ex& coefficient, int first) const {
    Series series(static_cast<std::size_t>(order_) + 1);
    const ex substituted = frequency_values_.empty() ? coefficient : coefficient.subs(frequency_values_);
    if (!substituted.has(eps_)) {
      if (first <= order_) series[static_cast<std::size_t>(first)] = substituted.expand();
      return series;
    }
    const ex expanded = GiNaC::series_to_poly(substituted.series(eps_ == 0, order_ - first + 1)).expand();
    for (int n = first; n <= order_; ++n)
      series[static_cast<std::size_t>(n)] = expanded.coeff(eps_, n - first).expand();
    return series;
  }

  // --- series arithmetic
  // -------------------------------------------------------------------------------------------
  Series constant(const ex& value) const {
    Series series(static_cast<std::size_t>(order_) + 1);
    series[0] = value;
    return series;
  }
  Series times(const Series& a, const Series& b) const {
    Series product(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; i + j < a.size(); ++j)
        if (!a[i].is_zero() && !b[j].is_zero()) product[i + j] += (a[i] * b[j]).expand();
    for (ex& e : product) e = e.expand();
    return product;
  }
  static void accumulate(Series& sum, const Series& addend) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = (sum[i] + addend[i]).expand();
  }

  // --- the expansion as a function of true time
  // --------------------------------------------------------------------
  ex monomial(const FieldKey& key) const {
    const FieldLayout& layout = d_.layout;
    ex product = 1;
    for (std::size_t k = 0; k < layout.modes; ++k)
      product *= GiNaC::pow(amplitude_[k], key[layout.amplitude(k)]) *
                 GiNaC::pow(conjugate_[k], key[layout.conjugate(k)]) *
                 GiNaC::pow(modulus_[k], key[layout.modulus(k)]);
    for (std::size_t j = 0; j < layout.excitations; ++j)
      product *= GiNaC::pow(model_.symbols.at(model_.excitations[j].amplitude), key[layout.forcing(j)]);
    const Phase phase = d_.full_phase(key);
    for (std::size_t i = 0; i < phase.size(); ++i) product *= GiNaC::pow(wave_[i], phase[i]);
    return product;
  }

  Series graded_field(const FieldSeries& fields) const {
    Series sum = constant(0);
    for (std::size_t n = 0; n < fields.size(); ++n)
      for (const auto& [key, coefficient] : fields[n].terms()) {
        const Series series = graded_coefficient(coefficient, static_cast<int>(n));
        const ex powers = monomial(key);
        for (std::size_t i = 0; i < sum.size(); ++i)
          if (!series[i].is_zero()) sum[i] += (series[i] * powers).expand();
      }
    for (ex& e : sum) e = e.expand();
    return sum;
  }

  void make_response() {
    for (std::size_t k = 0; k < model_.modes.size(); ++k) {
      amplitude_rate_.push_back(graded_field(d_.slow_derivative[k]));
      FieldSeries mirrored;
      for (const Field& field : d_.slow_derivative[k]) mirrored.push_back(field.conjugated(d_.layout));
      conjugate_rate_.push_back(graded_field(mirrored));
    }
    for (std::size_t i = 0; i < wave_.size(); ++i)
      wave_rate_.push_back(times(graded_coefficient(model_.frequency(i), 0), constant(GiNaC::I * wave_[i])));
    for (std::size_t k = 0; k < model_.modes.size(); ++k) {
      const Series x = graded_field(d_.response[k]), v = time_derivative(x), a = time_derivative(v);
      values_[q_[k][0]] = x;
      values_[q_[k][1]] = v;
      values_[q_[k][2]] = a;
    }
    for (std::size_t j = 0; j < u_.size(); ++j) {
      const symbol& wave = wave_[model_.modes.size() + j];
      const ex amplitude = model_.symbols.at(model_.excitations[j].amplitude);
      const Series x = constant(d_.resonance->excited ? (amplitude * (wave + 1 / wave) / 2).expand() : ex(0));
      const Series v = time_derivative(x);
      values_[u_[j][0]] = x;
      values_[u_[j][1]] = v;
      values_[u_[j][2]] = time_derivative(v);
    }
  }

  // d/dt by the chain rule through everything that moves.
  Series time_derivative(const Series& x) const {
    Series sum = constant(0);
    const auto through = [&](const symbol& variable, const Series& rate) {
      Series partial(x.size());
      bool any = false;
      for (std::size_t n = 0; n < x.size(); ++n) {
        partial[n] = x[n].diff(variable);
        any = any || !partial[n].is_zero();
      }
      if (any) accumulate(sum, times(partial, rate));
    };
    for (std::size_t k = 0; k < amplitude_.size(); ++k) {
      through(amplitude_[k], amplitude_rate_[k]);
      through(conjugate_[k], conjugate_rate_[k]);
      Series modulus_rate = times(amplitude_rate_[k], constant(conjugate_[k] / modulus_[k] / 2));
      accumulate(modulus_rate, times(conjugate_rate_[k], constant(amplitude_[k] / modulus_[k] / 2)));
      through(modulus_[k], modulus_rate);
    }
    for (std::size_t i = 0; i < wave_.size(); ++i) through(wave_[i], wave_rate_[i]);
    return sum;
  }

  // --- the original equations
  // --------------------------------------------------------------------------------------
  std::vector<ex> equations_in_symbols() {
    std::vector<ex> equations;
    if (!model_.lagrangian) {
      for (const Mode& mode : model_.modes)
        equations.push_back(in_symbols(mode.equation->left, mode.source) -
                            in_symbols(mode.equation->right.front(), mode.source));
      return equations;
    }
    const Lagrangian& lagrangian = *model_.lagrangian;
    const ex difference = in_symbols(lagrangian.kinetic, lagrangian.kinetic_source) -
                          in_symbols(lagrangian.potential, lagrangian.potential_source);
    for (std::size_t k = 0; k < model_.modes.size(); ++k)
      equations.push_back(derived(difference.diff(q_[k][1])) - difference.diff(q_[k][0]) -
                          in_symbols(*model_.modes[k].force, model_.modes[k].source));
    return equations;
  }

  ex derived(const ex& value) const {
    ex sum = 0;
    for (const auto* group : {&q_, &u_})
      for (const std::vector<symbol>& levels : *group)
        for (std::size_t level = 0; level < 2; ++level) sum += value.diff(levels[level]) * levels[level + 1];
    return sum;
  }

  ex in_symbols(const Expression& e, const FormulaSource& source) {
    switch (e.kind) {
      case Expression::Kind::number:
        return exact_number(e.text);
      case Expression::Kind::symbol:
        for (std::size_t k = 0; k < model_.modes.size(); ++k)
          if (model_.modes[k].coordinate == e.text) return q_[k][0];
        if (e.text == "Pi") return GiNaC::Pi;
        return model_.symbols.at(e.text);
      case Expression::Kind::sum: {
        ex sum = 0;
        for (const Expression& operand : e.operands) sum += in_symbols(operand, source);
        return sum;
      }
      case Expression::Kind::product: {
        ex product = 1;
        for (const Expression& operand : e.operands) product *= in_symbols(operand, source);
        return joined(product);
      }
      case Expression::Kind::quotient:
        return joined(in_symbols(e.operands[0], source) / in_symbols(e.operands[1], source));
      case Expression::Kind::power:
        return joined(GiNaC::pow(in_symbols(e.operands[0], source), integer_exponent(e, source)));
      case Expression::Kind::negation:
        return -in_symbols(e.operands[0], source);
      case Expression::Kind::call:
        break;
    }
    if (e.text == "cos" || e.text == "sin") return clock(e, source);
    const ex argument = in_symbols(e.operands[0], source);
    if (e.text == "D") return derived(argument);
    if (e.text == "D2") return derived(derived(argument));
    nonsmooth_.push_back({symbol("N" + std::to_string(nonsmooth_.size())), e.text == "abs", argument});
    return nonsmooth_.back().value;
  }

  // cos(n Omega t) as a symbol of its own, joined with F to the excitation u.
  ex clock(const Expression& e, const FormulaSource& source) {
    const symbol time("t");
    const ex phase = formula_value(e.operands[0], source, [&](const Expression& s) -> ex {
      return s.text == "t" ? ex(time) : ex(model_.symbols.at(s.text));
    });
    for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
      const ex multiple = (phase / (model_.symbols.at(model_.excitations[j].frequency) * time)).normal();
      if (!GiNaC::is_a<GiNaC::numeric>(multiple)) continue;
      const auto [entry, added] = clocks_.try_emplace(
          {j, GiNaC::ex_to<GiNaC::numeric>(multiple).to_int(), e.text == "cos"}, symbol("clock"));
      return entry->second;
    }
    return 0;
  }

  ex joined(const ex& product) const {
    ex result = product;
    for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
      const auto cosine = clocks_.find({j, 1, true});
      if (cosine == clocks_.end() || !result.has(cosine->second)) continue;
      const ex amplitude = model_.symbols.at(model_.excitations[j].amplitude);
      result =
          result.expand().subs(GiNaC::lst{amplitude * cosine->second == u_[j][0]}, GiNaC::subs_options::algebraic);
    }
    return result;
  }

  // --- substitution
  // ------------------------------------------------------------------------------------------------
  Series graded(const ex& e) const {
    if (GiNaC::is_a<GiNaC::add>(e)) {
      Series sum = constant(0);
      for (std::size_t i = 0; i < e.nops(); ++i) accumulate(sum, graded(e.op(i)));
      return sum;
    }
    if (GiNaC::is_a<GiNaC::mul>(e)) {
      Series product = constant(1);
      for (std::size_t i = 0; i < e.nops(); ++i) product = times(product, graded(e.op(i)));
      return product;
    }
    if (GiNaC::is_a<GiNaC::power>(e) && GiNaC::is_a<GiNaC::numeric>(e.op(1)) &&
        GiNaC::ex_to<GiNaC::numeric>(e.op(1)).is_pos_integer()) {
      Series product = constant(1);
      const Series base = graded(e.op(0));
      for (int i = GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int(); i > 0; --i) product = times(product, base);
      return product;
    }
    const auto moving =
        std::find_if(values_.begin(), values_.end(), [&](const auto& entry) { return e.is_equal(entry.first); });
    if (moving != values_.end()) return moving->second;
    for (const auto& [key, clock_symbol] : clocks_)
      if (e.is_equal(clock_symbol)) {
        const auto& [j, multiple, cosine] = key;
        const ex wave = GiNaC::pow(wave_[model_.modes.size() + j], multiple);
        if (!d_.resonance->excited) return constant(0);
        return constant(cosine ? (wave + 1 / wave) / 2 : (wave - 1 / wave) / (2 * GiNaC::I));
      }
    if (GiNaC::is_a<symbol>(e)) {
      const auto entry = d_.resonance->order.find(GiNaC::ex_to<symbol>(e).get_name());
      const int order = entry == d_.resonance->order.end() ? 0 : entry->second;
      if (order > 0) {
        Series series = constant(0);
        if (order <= order_) series[static_cast<std::size_t>(order)] = e;
        return series;
      }
    }
    return graded_coefficient(e, 0);
  }

  // Terms of degree d in the coordinates start at eps^(d-1) where the case is ordered by degree.
  Series residual_of(const ex& equation) const {
    if (!d_.resonance->degree_ordering) return graded(equation.expand());
    const ex expanded = equation.expand();
    Series sum = constant(0);
    const bool is_sum = GiNaC::is_a<GiNaC::add>(expanded);
    for (std::size_t i = 0; i < (is_sum ? expanded.nops() : 1); ++i) {
      const ex term = is_sum ? expanded.op(i) : expanded;
      int degree = 0;
      for (const std::vector<symbol>& levels : q_)
        for (const symbol& level : levels) degree += term.degree(level);
      for (const NonsmoothCall& call : nonsmooth_)
        if (call.absolute) degree += term.degree(call.value);
      const auto shift = static_cast<std::size_t>(std::max(0, degree - 1));
      const Series series = graded(term);
      for (std::size_t n = shift; n < sum.size(); ++n) sum[n] += series[n - shift];
    }
    for (ex& e : sum) e = e.expand();
    return sum;
  }

  // Splits a sum into coefficients of distinct powers of waves, amplitudes and nonsmooth values.
  std::map<std::vector<int>, ex> collected(const ex& sum) const {
    std::vector<symbol> variables = wave_;
    variables.insert(variables.end(), amplitude_.begin(), amplitude_.end());
    variables.insert(variables.end(), conjugate_.begin(), conjugate_.end());
    variables.insert(variables.end(), modulus_.begin(), modulus_.end());
    for (const NonsmoothCall& call : nonsmooth_) variables.push_back(call.value);
    std::map<std::vector<int>, ex> parts;
    const bool is_sum = GiNaC::is_a<GiNaC::add>(sum);
    for (std::size_t i = 0; i < (is_sum ? sum.nops() : 1); ++i) {
      ex coefficient = is_sum ? sum.op(i) : sum;
      std::vector<int> powers;
      for (const symbol& variable : variables) {
        const int power = coefficient.degree(variable);
        powers.push_back(power);
        if (power != 0) coefficient = coefficient * GiNaC::pow(variable, -power);
      }
      parts[powers] += coefficient;
    }
    return parts;
  }

  void check_equation(std::size_t k, const ex& equation, Certificate& certificate) {
    const Series residual = residual_of(equation);
    for (std::size_t n = 0; n < residual.size(); ++n) {
      const bool nonsmooth = std::any_of(nonsmooth_.begin(), nonsmooth_.end(),
                                         [&](const NonsmoothCall& call) { return residual[n].has(call.value); });
      if (nonsmooth) {
        check_nonsmooth(k, residual[n], certificate);
        continue;
      }
      for (const auto& [powers, coefficient] : collected(residual[n])) {
        ++certificate.coefficients_checked;
        if (coefficient.expand().is_zero() || coefficient.normal().is_zero()) continue;
        certificate.holds = false;
        certificate.remainders.push_back("equation of " + model_.modes[k].coordinate + ", eps^" +
                                         std::to_string(n));
      }
    }
  }

  // Every harmonic of the residual, smooth part plus nonsmooth part by quadrature, at random values.
  void check_nonsmooth(std::size_t k, const ex& residual, Certificate& certificate) {
    std::mt19937_64 random(20240229 + k);
    const auto uniform = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    };
    certificate.nonsmooth_harmonics = highest_nonsmooth_harmonic;
    for (int draw = 0; draw < 3; ++draw) {
      GiNaC::exmap numbers;
      for (const std::string& name : model_.symbols.names()) numbers[model_.symbols.at(name)] = uniform(0.5, 1.5);
      std::vector<std::complex<double>> amplitudes;
      for (std::size_t m = 0; m < amplitude_.size(); ++m) {
        const std::complex<double> a = std::polar(uniform(0.5, 1.5), uniform(-3, 3));
        amplitudes.push_back(a);
        numbers[amplitude_[m]] = a.real() + GiNaC::I * a.imag();
        numbers[conjugate_[m]] = a.real() - GiNaC::I * a.imag();
        numbers[modulus_[m]] = std::abs(a);
      }
      // Waves other than the oscillator's own appear in the smooth part only and vanish coefficient by coefficient.
      std::map<std::vector<int>, std::complex<double>> harmonics;
      double largest = 0;
      const auto record = [&](const std::vector<int>& waves, std::complex<double> value) {
        harmonics[waves] += value;
        largest = std::max(largest, std::abs(value));
      };
      const auto number = [&](const ex& e) {
        const ex value = e.subs(numbers).evalf();
        const auto& n = GiNaC::ex_to<GiNaC::numeric>(value);
        return std::complex<double>(n.real().to_double(), n.imag().to_double());
      };
      for (const auto& [powers, coefficient] : collected(residual)) {
        const std::vector<int> waves(powers.begin(), powers.begin() + static_cast<std::ptrdiff_t>(wave_.size()));
        ex whole = coefficient;
        std::size_t at = wave_.size();
        for (const auto* group : {&amplitude_, &conjugate_, &modulus_})
          for (const symbol& variable : *group) whole = whole * GiNaC::pow(variable, powers[at++]);
        const NonsmoothCall* call = nullptr;
        for (const NonsmoothCall& candidate : nonsmooth_)
          if (powers[at++] != 0) call = &candidate;
        const std::complex<double> value = number(whole);
        if (!call) {
          record(waves, value);
          continue;
        }
        const auto [mode, samples] = fourier_integrals(*call, amplitudes, numbers);
        for (int n = -40; n <= 40; ++n) {
          std::vector<int> shifted = waves;
          shifted[mode] += n;
          if (std::abs(shifted[mode]) <= highest_nonsmooth_harmonic)
            record(shifted, value * samples[static_cast<std::size_t>(n + 40)]);
        }
      }
      for (const auto& [waves, value] : harmonics) {
        ++certificate.coefficients_checked;
        const double error = std::abs(value) / largest;
        certificate.nonsmooth_error = std::max(certificate.nonsmooth_error, error);
        if (error < 1e-9) continue;
        certificate.holds = false;
        certificate.remainders.push_back("equation of " + model_.modes[k].coordinate +
                                         ", harmonic of a nonsmooth term");
      }
    }
  }

  // Fourier coefficients -40..40 of abs(x) or sgn(x) for the leading motion x of one mode, over exp(i w t).
  std::pair<std::size_t, std::vector<std::complex<double>>> fourier_integrals(
      const NonsmoothCall& call, const std::vector<std::complex<double>>& amplitudes,
      const GiNaC::exmap& numbers) const {
    std::size_t mode = 0;
    std::size_t derivative = 0;
    for (std::size_t m = 0; m < q_.size(); ++m)
      for (std::size_t level = 0; level < 2; ++level)
        if (call.argument.has(q_[m][level])) {
          mode = m;
          derivative = level;
        }
    const double scale = GiNaC::ex_to<GiNaC::numeric>(call.argument.diff(q_[mode][derivative]).evalf()).to_double();
    const double omega = GiNaC::ex_to<GiNaC::numeric>(ex(model_.frequency(mode)).subs(numbers)).to_double();
    std::complex<double> phasor = 2.0 * scale * amplitudes[mode];
    if (derivative == 1) phasor *= std::complex<double>(0, omega);
    const auto x = [&](double phi) { return (phasor * std::polar(1.0, phi)).real(); };
    // cos(phi + arg) changes sign at phi = pi/2 - arg and one half turn later.
    const double zero = std::numbers::pi / 2 - std::arg(phasor);
    std::vector<std::complex<double>> coefficients;
    for (int n = -40; n <= 40; ++n) {
      std::complex<double> sum = 0;
      for (int half = 0; half < 2; ++half) {
        const double from = zero + half * std::numbers::pi, to = from + std::numbers::pi;
        const double sign = x(0.5 * (from + to)) > 0 ? 1 : -1;
        const auto integral = [&](auto part) {
          return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
              [&](double phi) { return (call.absolute ? sign * x(phi) : sign) * part(n * phi); }, from, to, 8,
              1e-13);
        };
        sum += std::complex<double>(integral([](double a) { return std::cos(a); }),
                                    -integral([](double a) { return std::sin(a); }));
      }
      coefficients.push_back(sum / (2 * std::numbers::pi));
    }
    return {mode, coefficients};
  }

  const Derivation& d_;
  const Model& model_;
  int order_;
  symbol eps_{"eps"};
  std::vector<std::vector<symbol>> q_, u_;  // [index][derivative]
  std::vector<symbol> amplitude_, conjugate_, modulus_, wave_;
  std::vector<Series> amplitude_rate_, conjugate_rate_, wave_rate_;
  std::map<ex, Series, GiNaC::ex_is_less> values_;
  std::map<std::tuple<std::size_t, int, bool>, symbol> clocks_;
  std::vector<NonsmoothCall> nonsmooth_;
  GiNaC::exmap frequency_values_;
};

}  // namespace

Certificate certify(const Derivation& derivation) {
  return Substitution(derivation).certify();
}

}  // namespace secular
