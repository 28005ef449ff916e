#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "perturb/field.hpp"

namespace secular::testing_fields {

using Complex = std::complex<double>;

/// Numbers for everything that a field is made of: what stands for the independent truth is arithmetic on these.
struct Point {
  GiNaC::exmap symbols;
  std::vector<double> phases;  ///< of the frequencies, then the slow phases
  std::vector<Complex> amplitudes;
  std::vector<double> forces;
};

inline Complex value(const GiNaC::ex& e, const GiNaC::exmap& symbols) {
  const GiNaC::ex number = e.subs(symbols).evalf();
  return {GiNaC::ex_to<GiNaC::numeric>(GiNaC::real_part(number)).to_double(),
          GiNaC::ex_to<GiNaC::numeric>(GiNaC::imag_part(number)).to_double()};
}

/// The sum that a field stands for.
inline Complex value(const Field& field, const FieldLayout& layout, const Point& at) {
  Complex sum = 0;
  for (const auto& [key, coefficient] : field.terms()) {
    double phase = 0;
    for (std::size_t i = 0; i < layout.amplitude(0); ++i) phase += key[i] * at.phases[i];
    Complex term = value(coefficient, at.symbols) * std::polar(1.0, phase);
    for (std::size_t k = 0; k < layout.modes; ++k)
      term *= std::pow(at.amplitudes[k], key[layout.amplitude(k)]) *
              std::pow(std::conj(at.amplitudes[k]), key[layout.conjugate(k)]) *
              std::pow(std::abs(at.amplitudes[k]), key[layout.modulus(k)]);
    for (std::size_t j = 0; j < layout.excitations; ++j) term *= std::pow(at.forces[j], key[layout.forcing(j)]);
    sum += term;
  }
  return sum;
}

/// A real field of random terms, each with its conjugate.
inline Field random_field(const FieldLayout& layout, int terms, std::mt19937& random) {
  std::uniform_int_distribution<int> phase(-3, 3), power(0, 2), part(-4, 4);
  Field field;
  for (int i = 0; i < terms; ++i) {
    FieldKey key(layout.size(), 0);
    for (std::size_t j = 0; j < layout.amplitude(0); ++j) key[j] = phase(random);
    for (std::size_t j = layout.amplitude(0); j < layout.size(); ++j) key[j] = power(random);
    Field one;
    one.add(key, GiNaC::numeric(part(random), 3) + GiNaC::I * GiNaC::numeric(1 + power(random), 5));
    field += one;
    field += one.conjugated(layout);
  }
  return field;
}

inline Point random_point(const FieldLayout& layout, std::mt19937& random) {
  std::uniform_real_distribution<double> number(0.5, 1.5);
  Point at;
  for (std::size_t i = 0; i < layout.amplitude(0); ++i) at.phases.push_back(4 * number(random));
  for (std::size_t k = 0; k < layout.modes; ++k)
    at.amplitudes.push_back(std::polar(number(random), 4 * number(random)));
  for (std::size_t j = 0; j < layout.excitations; ++j) at.forces.push_back(number(random));
  return at;
}

inline void expect_near(Complex a, Complex b, double relative) {
  EXPECT_LT(std::abs(a - b), relative * (1 + std::abs(b))) << a << " and " << b;
}

}  // namespace secular::testing_fields
