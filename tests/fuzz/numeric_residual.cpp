#include "tests/fuzz/numeric_residual.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace secular::fuzz {
namespace {

using Complex = std::complex<double>;

// c0 + c1 t + c2 t^2 about an instant.
struct Jet {
  Complex c[3] = {};

  static Jet wave(double frequency, double instant) {
    const Complex at = std::polar(1.0, frequency * instant), i(0, frequency);
    return {{at, i * at, i * i * at / 2.0}};
  }
  Jet conjugated() const { return {{std::conj(c[0]), std::conj(c[1]), std::conj(c[2])}}; }
  Jet& operator+=(const Jet& b) {
    for (int n = 0; n < 3; ++n) c[n] += b.c[n];
    return *this;
  }
};

Jet operator*(const Jet& a, const Jet& b) {
  return {
      {a.c[0] * b.c[0], a.c[0] * b.c[1] + a.c[1] * b.c[0], a.c[0] * b.c[2] + a.c[1] * b.c[1] + a.c[2] * b.c[0]}};
}

Jet operator*(Complex number, const Jet& a) {
  return {{number * a.c[0], number * a.c[1], number * a.c[2]}};
}

Jet power(const Jet& a, int exponent) {
  Jet product{{1, 0, 0}};
  for (int i = 0; i < exponent; ++i) product = product * a;
  return product;
}

Complex number(const GiNaC::ex& e, const GiNaC::exmap& symbols) {
  const GiNaC::ex value = e.subs(symbols).evalf();
  return {GiNaC::ex_to<GiNaC::numeric>(GiNaC::real_part(value)).to_double(),
          GiNaC::ex_to<GiNaC::numeric>(GiNaC::imag_part(value)).to_double()};
}

// Numbers of the model: nothing of them is near a resonance that no relation names.
double value_of(const std::string& coefficient) {
  const int i = std::stoi(coefficient.substr(1));
  return 0.7 + 0.3 * std::sin(2.3 * i);
}
constexpr double forcing = 0.83, natural[] = {1, 1.4953487812}, excitation = 0.6231234567, instants[] = {0.37, 2.9};

// Where eps is: frequencies as the relations say, so that detunings have their own values.
class At {
 public:
  At(const RandomModel& model, const Derivation& derivation, double eps)
      : model_(model), derivation_(derivation), eps_(eps), frequencies_(natural, natural + model.modes) {
    frequencies_.push_back(excitation);
    // Relations between natural frequencies move the second one, those with Omega move Omega.
    for (const bool excited : {false, true})
      for (const RandomRelation& r : model.relations)
        if ((r.multiples.back() != 0) == excited) solve(r);
    set_symbols();
  }

  // Left minus right sides of all equations at an instant, and what the terms come to in all.
  std::vector<Complex> residuals(double instant, double& terms) const {
    std::vector<Jet> amplitudes, coordinates;
    for (std::size_t k = 0; k < model_.modes; ++k)
      amplitudes.push_back({{std::polar(0.6 - 0.15 * static_cast<double>(k), 0.9 + static_cast<double>(k)), 0, 0}});
    // Each turn gives one more coefficient of time.
    for (int n = 1; n < 3; ++n) {
      std::vector<Jet> rates;
      for (std::size_t k = 0; k < model_.modes; ++k)
        rates.push_back(sum(derivation_.slow_derivative[k], amplitudes, instant, terms));
      for (std::size_t k = 0; k < model_.modes; ++k)
        amplitudes[k].c[n] = rates[k].c[n - 1] / static_cast<double>(n);
    }
    for (std::size_t k = 0; k < model_.modes; ++k)
      coordinates.push_back(sum(derivation_.response[k], amplitudes, instant, terms));
    std::vector<Complex> left;
    for (std::size_t k = 0; k < model_.modes; ++k) {
      Complex r = 2.0 * coordinates[k].c[2] + frequencies_[k] * frequencies_[k] * coordinates[k].c[0];
      for (const RandomTerm& term : model_.equations[k]) r -= value(term, coordinates, instant);
      left.push_back(r);
    }
    return left;
  }

 private:
  void solve(const RandomRelation& r) {
    std::size_t unknown = model_.modes;
    while (r.multiples[unknown] == 0) --unknown;
    double right = std::pow(eps_, r.order) * (0.4 + 0.2 * static_cast<double>(r.detuning.back() - '0'));
    for (std::size_t j = 0; j < unknown; ++j) right -= r.multiples[j] * frequencies_[j];
    frequencies_[unknown] = right / r.multiples[unknown];
  }

  void set_symbols() {
    const Model& m = *derivation_.model;
    for (std::size_t i = 0; i < m.frequency_count(); ++i) symbols_[m.frequency(i)] = frequencies_[i];
    for (const std::string& name : m.parameters) symbols_[m.symbols.at(name)] = value_of(name);
    for (const RandomRelation& r : model_.relations)
      symbols_[m.symbols.at(r.detuning)] = 0.4 + 0.2 * static_cast<double>(r.detuning.back() - '0');
  }

  Jet sum(const FieldSeries& series, const std::vector<Jet>& amplitudes, double instant, double& terms) const {
    const FieldLayout& layout = derivation_.layout;
    Jet all;
    for (std::size_t n = 0; n < series.size(); ++n)
      for (const auto& [key, coefficient] : series[n].terms()) {
        const Phase phase = derivation_.full_phase(key);
        double f = 0;
        for (std::size_t j = 0; j < phase.size(); ++j) f += phase[j] * frequencies_[j];
        Jet term = number(coefficient, symbols_) * Jet::wave(f, instant);
        for (std::size_t k = 0; k < layout.modes; ++k)
          term = term * power(amplitudes[k], key[layout.amplitude(k)]) *
                 power(amplitudes[k].conjugated(), key[layout.conjugate(k)]);
        for (std::size_t j = 0; j < layout.excitations; ++j)
          term = std::pow(forcing, key[layout.forcing(j)]) * term;
        terms += std::abs(term.c[0]);
        all += std::pow(eps_, static_cast<double>(n)) * term;
      }
    return all;
  }

  Complex value(const RandomTerm& term, const std::vector<Jet>& coordinates, double instant) const {
    Complex product = std::pow(eps_, term.order) * value_of(term.coefficient) * term.number / term.denominator;
    for (std::size_t k = 0; k < term.powers.size(); ++k)
      for (std::size_t d = 0; d < 3; ++d)
        product *= std::pow((d == 2 ? 2.0 : 1.0) * coordinates[k].c[d], term.powers[k][d]);
    const double angle = term.multiple * frequencies_.back() * instant;
    if (term.multiple > 0) product *= term.sine ? std::sin(angle) : std::cos(angle);
    if (term.is_forced()) product *= forcing;
    return product;
  }

  const RandomModel& model_;
  const Derivation& derivation_;
  double eps_;
  std::vector<double> frequencies_;
  GiNaC::exmap symbols_;
};

}  // namespace

NumericResidual numeric_residual(const RandomModel& model, const Derivation& derivation) {
  const double eps = 1.0 / 256;
  NumericResidual result;
  const At at[] = {At(model, derivation, eps), At(model, derivation, eps / 2), At(model, derivation, eps / 4)};
  for (const double instant : instants) {
    // residual/eps^N is c0 + c1 eps + c2 eps^2 + ...: three values of eps leave c0 alone.
    std::vector<Complex> limit(model.modes);
    double terms = 0;
    const double weights[] = {1.0 / 3, -2, 8.0 / 3};
    for (int i = 0; i < 3; ++i) {
      const std::vector<Complex> left = at[i].residuals(instant, terms);
      for (std::size_t k = 0; k < model.modes; ++k)
        limit[k] += weights[i] * left[k] / std::pow(eps * std::ldexp(1.0, -i), model.expand_to);
    }
    for (const Complex& c0 : limit) result.left = std::max(result.left, std::abs(c0));
    result.terms = std::max(result.terms, terms);
  }
  return result;
}

}  // namespace secular::fuzz
