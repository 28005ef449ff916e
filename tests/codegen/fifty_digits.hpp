#pragma once

// Everything that generated code computes, from the canonical form in CLN numbers of 60 digits, each with the sum
// of the absolute values of the terms it was made of: what its rounding errors are measured by. Derivatives are
// central differences in those digits (step 1e-17, error 1e-34), which shares nothing with the rules that the code
// uses.
#include <cln/cln.h>

#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/canonical/lump_gradient.hpp"
#include "codegen/canonical/motion_derivative.hpp"
#include "tests/runtime/compare_models.hpp"

namespace secular::test {

using Real = cln::cl_F;

inline Real exact(double x) {
  static const cln::float_format_t format = cln::float_format(60);
  return cln::cl_float(cln::cl_F(x), format);
}
inline double rounded(const Real& x) {
  return cln::double_approx(x);
}
inline double magnitude(const Real& x) {
  return std::abs(rounded(x));
}

/// A number and the sum of absolute values of what it is a sum of; quotients count the denominator's condition.
struct Bounded {
  Real value = exact(0);
  double size = 0;
};
inline Bounded bounded(const Real& x) {
  return {x, magnitude(x)};
}
inline Bounded operator+(const Bounded& a, const Bounded& b) {
  return {a.value + b.value, a.size + b.size};
}
inline Bounded operator-(const Bounded& a) {
  return {-a.value, a.size};
}
inline Bounded operator*(const Bounded& a, const Bounded& b) {
  return {a.value * b.value, a.size * b.size};
}
inline Bounded operator/(const Bounded& a, const Bounded& b) {
  const double below = magnitude(b.value);
  return {a.value / b.value, a.size / below * (b.size / below)};
}

struct BoundedComplex {
  Bounded real, imag;
};
inline BoundedComplex operator+(const BoundedComplex& a, const BoundedComplex& b) {
  return {a.real + b.real, a.imag + b.imag};
}
inline BoundedComplex operator*(const BoundedComplex& a, const BoundedComplex& b) {
  return {a.real * b.real + -(a.imag * b.imag), a.real * b.imag + a.imag * b.real};
}
inline BoundedComplex operator*(const Bounded& a, const BoundedComplex& b) {
  return {a * b.real, a * b.imag};
}
inline BoundedComplex times_i(const BoundedComplex& a) {
  return {-a.imag, a.real};
}
inline BoundedComplex conjugate(const BoundedComplex& a) {
  return {a.real, -a.imag};
}

/// A point in many digits: what Point is in doubles.
struct ExactPoint {
  std::vector<Real> parameters, excitation_frequency, displacement, velocity;
  std::vector<ExcitationSample> excitation;
  std::vector<Real> amplitude, forcing;  ///< real part, imaginary part, of every mode or excitation

  explicit ExactPoint(const Point& p) : excitation(p.excitation) {
    for (const auto& [from, to] :
         {std::pair(&p.parameters, &parameters), std::pair(&p.excitation_frequency, &excitation_frequency),
          std::pair(&p.displacement, &displacement), std::pair(&p.velocity, &velocity)})
      for (const double x : *from) to->push_back(exact(x));
    for (const auto& [from, to] : {std::pair(&p.amplitude, &amplitude), std::pair(&p.forcing, &forcing)})
      for (const Complex& z : *from) {
        to->push_back(exact(z.real()));
        to->push_back(exact(z.imag()));
      }
  }
};

class Reference {
 public:
  explicit Reference(const CanonicalModel& model) : model_(model) {}

  std::vector<Bounded> symbols(const ExactPoint& p) const {
    std::vector<Bounded> values(model_.order.size(), bounded(exact(1)));
    values.back() = bounded(cln::pi(cln::float_format(60)));
    for (std::size_t j = 0; j < p.excitation_frequency.size(); ++j)
      values[model_.coordinates.size() + j] = bounded(p.excitation_frequency[j]);
    for (std::size_t i = 0; i < p.parameters.size(); ++i) values[symbol(i)] = bounded(p.parameters[i]);
    return values;
  }
  std::size_t symbol(std::size_t parameter) const {
    return static_cast<std::size_t>(
        std::find(model_.order.begin(), model_.order.end(), model_.parameters[parameter]) - model_.order.begin());
  }

  Bounded value(const std::vector<PolynomialTerm>& terms, const std::vector<Bounded>& symbols) const {
    Bounded sum;
    for (const PolynomialTerm& term : terms) {
      Bounded product = bounded(cln::cl_float(cln::cl_I(term.coefficient.c_str()), cln::float_format(60)));
      for (std::size_t s = 0; s < term.exponents.size(); ++s)
        for (int n = 0; n < term.exponents[s]; ++n) product = product * symbols[s];
      for (const DivisorPower& divisor : term.divisors) {
        const Bounded below = value(*divisor.sum, symbols);
        for (int n = 0; n < divisor.power; ++n) product = product / below;
      }
      sum = sum + product;
    }
    return sum;
  }
  Bounded value(const RationalFunction& f, const std::vector<Bounded>& symbols) const {
    return value(f.numerator, symbols) / value(f.denominator, symbols);
  }
  /// Sum of absolute values of d f/d p for every parameter, as the code writes derivatives.
  std::vector<double> gradient_size(const RationalFunction& f, const std::vector<Bounded>& symbols) const {
    std::vector<double> sizes(model_.parameters.size(), 0.0);
    for (const LumpGradient::Entry& entry : lump_gradient(model_, f).entries)
      sizes[entry.parameter] = value(entry.rate, symbols).size;
    return sizes;
  }

  // ---- cases ----
  std::vector<Bounded> lumps(const CanonicalCase& c, const ExactPoint& p) const {
    const std::vector<Bounded> s = symbols(p);
    std::vector<Bounded> values;
    for (const CanonicalLump& lump : c.lumps) values.push_back(value(lump.definition, s));
    return values;
  }

  BoundedComplex monomial(const CanonicalPowers& powers, const ExactPoint& p) const {
    const auto number = [](const std::vector<Real>& parts, std::size_t i) {
      return BoundedComplex{bounded(parts[2 * i]), bounded(parts[2 * i + 1])};
    };
    BoundedComplex product{bounded(exact(1)), bounded(exact(0))};
    const auto raise = [&](const BoundedComplex& base, int n) {
      for (int i = 0; i < n; ++i) product = product * base;
    };
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
      const BoundedComplex a = number(p.amplitude, k);
      raise(a, powers.amplitude[k]);
      raise(conjugate(a), powers.conjugate[k]);
      const Bounded modulus = bounded(cln::sqrt(a.real.value * a.real.value + a.imag.value * a.imag.value));
      for (int i = 0; i < powers.modulus[k]; ++i) product = modulus * product;
      for (int i = 0; i < -powers.modulus[k]; ++i) product = (bounded(exact(1)) / modulus) * product;
    }
    for (std::size_t j = 0; j < model_.excitations.size(); ++j) {
      const BoundedComplex f = number(p.forcing, j);
      const int net = powers.phase[model_.coordinates.size() + j], pairs = (powers.forcing[j] - std::abs(net)) / 2;
      raise(f, pairs);
      raise(conjugate(f), pairs);
      raise(net > 0 ? f : conjugate(f), std::abs(net));
    }
    return product;
  }

  BoundedComplex column(const CanonicalBlock::Column& column, const ExactPoint& p) const {
    const std::vector<Bounded> s = symbols(p);
    BoundedComplex sum;
    for (const CanonicalColumnTerm& term : column.terms) {
      const BoundedComplex product = value(term.factor, s) * monomial(term.powers, p);
      sum = sum + (term.imaginary ? times_i(product) : product);
    }
    return sum;
  }
  /// Sizes of d column/d(natural frequency): real and imaginary part together.
  std::vector<double> column_slope_size(const CanonicalBlock::Column& column, const ExactPoint& p) const {
    const std::vector<Bounded> s = symbols(p);
    std::vector<double> sizes(model_.parameters.size(), 0.0);
    for (const CanonicalColumnTerm& term : column.terms) {
      const BoundedComplex m = monomial(term.powers, p);
      const std::vector<double> rates = gradient_size(term.factor, s);
      for (std::size_t i = 0; i < rates.size(); ++i) sizes[i] += rates[i] * (m.real.size + m.imag.size);
    }
    return sizes;
  }

  Bounded turning(const CanonicalCase& c, std::size_t k, const std::vector<Bounded>& s) const {
    Bounded sum;
    for (std::size_t i = 0; i < c.observed_frequency[k].size(); ++i) {
      const CanonicalRatio r = c.observed_frequency[k][i];
      const Bounded weight =
          bounded(exact(r.numerator - (i == k ? r.denominator : 0))) / bounded(exact(r.denominator));
      sum = sum + weight * s[i];
    }
    return sum;
  }

  /// dB/dt of every mode.
  std::vector<BoundedComplex> modulation(const CanonicalCase& c, const ExactPoint& p) const {
    const std::vector<Bounded> s = symbols(p), l = lumps(c, p);
    std::vector<BoundedComplex> rate(model_.coordinates.size());
    for (const CanonicalBlock& block : c.blocks)
      if (block.modulation && !c.mode_at_rest[block.mode])
        for (const CanonicalBlock::Column& item : block.columns)
          rate[block.mode] = rate[block.mode] + l[item.lump] * column(item, p);
    for (std::size_t k = 0; k < rate.size(); ++k) {
      if (c.mode_at_rest[k]) continue;
      const BoundedComplex a{bounded(p.amplitude[2 * k]), bounded(p.amplitude[2 * k + 1])};
      rate[k] = rate[k] + -turning(c, k, s) * times_i(a);
    }
    return rate;
  }

  /// The same from the solvability conditions as they were derived, with the detunings by their relations and the
  /// amplitudes at t = 0: shares nothing with lumps and columns.
  std::vector<BoundedComplex> derived_modulation(const CanonicalCase& c, const ExactPoint& p) const {
    std::vector<Bounded> s = symbols(p);
    for (const CanonicalRelation& relation : c.relations) {
      Bounded sum;
      for (std::size_t i = 0; i < relation.multiples.size(); ++i)
        sum = sum + bounded(exact(relation.multiples[i])) * s[i];
      const auto detuning = std::find(model_.order.begin(), model_.order.end(), relation.detuning);
      const Bounded coefficient =
          bounded(exact(relation.coefficient.numerator)) / bounded(exact(relation.coefficient.denominator));
      if (detuning != model_.order.end())
        s[static_cast<std::size_t>(detuning - model_.order.begin())] = sum / coefficient;
    }
    std::vector<BoundedComplex> rate(model_.coordinates.size());
    for (std::size_t k = 0; k < rate.size(); ++k) {
      if (c.mode_at_rest[k]) continue;
      for (const CanonicalTerm& term : c.slow_derivative[k])
        rate[k] =
            rate[k] + BoundedComplex{value(term.real, s), value(term.imaginary, s)} * monomial(term.powers, p);
      const BoundedComplex a{bounded(p.amplitude[2 * k]), bounded(p.amplitude[2 * k + 1])};
      rate[k] = rate[k] + -turning(c, k, s) * times_i(a);
    }
    return rate;
  }

  // ---- motion ----
  Bounded argument(const CanonicalFactor& f, const ExactPoint& p) const {
    if (f.argument.empty()) return bounded(f.derivative == 0 ? p.displacement[f.index] : p.velocity[f.index]);
    Bounded sum;
    for (const auto& [name, ratio] : f.argument) {
      Real x = exact(1);
      for (std::size_t i = 0; i < model_.parameters.size(); ++i)
        if (name == model_.parameters[i]) x = p.parameters[i];
      for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
        if (name == model_.coordinates[k]) x = p.displacement[k];
        if (name == "D(" + model_.coordinates[k] + ")") x = p.velocity[k];
      }
      sum = sum + bounded(exact(ratio.numerator)) / bounded(exact(ratio.denominator)) * bounded(x);
    }
    return sum;
  }

  Bounded product(const CanonicalMotionTerm& term, const ExactPoint& p, const std::vector<Bounded>& s) const {
    using Kind = CanonicalFactor::Kind;
    Bounded result = value(term.coefficient, s);
    for (const CanonicalFactor& f : term.factors) {
      Bounded x;
      if (f.kind == Kind::displacement) x = bounded(p.displacement[f.index]);
      if (f.kind == Kind::velocity) x = bounded(p.velocity[f.index]);
      if (f.kind == Kind::excitation) {
        const ExcitationSample& sample = p.excitation[f.index];
        x = bounded(exact(f.derivative == 0   ? sample.value
                          : f.derivative == 1 ? sample.first_derivative
                                              : sample.second_derivative));
      }
      if (f.kind == Kind::absolute || f.kind == Kind::sign) x = argument(f, p);
      if (f.kind == Kind::absolute) x.value = cln::abs(x.value);
      if (f.kind == Kind::sign) x = bounded(exact(rounded(x.value) > 0 ? 1 : -1));
      for (int i = 0; i < f.power; ++i) result = result * x;
    }
    return result;
  }

  /// [equation][mode] and, with the force that stands beside M*acceleration, the accelerations.
  std::vector<Bounded> mass(const ExactPoint& p) const {
    const std::size_t n = model_.coordinates.size();
    const std::vector<Bounded> s = symbols(p);
    std::vector<Bounded> result(n * n);
    for (std::size_t k = 0; k < n; ++k)
      for (const CanonicalMotionTerm& term : model_.motion[k])
        if (term.acceleration_of) {
          Bounded& entry = result[k * n + *term.acceleration_of];
          entry = entry + product(term, p, s);
        }
    return result;
  }
  std::vector<Bounded> acceleration(const ExactPoint& p) const {
    const std::size_t n = model_.coordinates.size();
    const std::vector<Bounded> s = symbols(p), m = mass(p);
    std::vector<Bounded> force(n);
    for (std::size_t k = 0; k < n; ++k)
      for (const CanonicalMotionTerm& term : model_.motion[k])
        if (!term.acceleration_of) force[k] = force[k] + -product(term, p, s);
    return solved(m, force);
  }
  /// Accelerations by `variables`, as sizes of what the code sums and solves.
  std::vector<double> slope_size(const ExactPoint& p, const std::vector<MotionVariable>& variables,
                                 const std::vector<Real>& slope) const {
    const std::size_t n = model_.coordinates.size();
    const std::vector<Bounded> s = symbols(p), m = mass(p), a = acceleration(p);
    std::vector<double> sizes(n * variables.size(), 0.0);
    for (std::size_t x = 0; x < variables.size(); ++x) {
      std::vector<double> right(n, 0.0);
      std::vector<Real> known;
      for (std::size_t k = 0; k < n; ++k) {
        known.push_back(slope[k * variables.size() + x]);
        for (const CanonicalMotionTerm& term : model_.motion[k])
          for (const WeightedMotionTerm& derived : motion_derivative(model_, term, variables[x]))
            right[k] += std::abs(static_cast<double>(derived.weight.numerator) / derived.weight.denominator) *
                        product(derived.term, p, s).size *
                        (derived.term.acceleration_of ? a[*derived.term.acceleration_of].size : 1.0);
      }
      const std::vector<double> column = solution_size(m, right, known);
      for (std::size_t k = 0; k < n; ++k) sizes[k * variables.size() + x] = column[k];
    }
    return sizes;
  }

 private:
  static std::vector<Real> inverse(const std::vector<Bounded>& m, std::size_t n) {
    std::vector<Real> a, b;
    for (std::size_t i = 0; i < n * n; ++i) {
      a.push_back(m[i].value);
      b.push_back(exact(i % (n + 1) == 0 ? 1 : 0));
    }
    for (std::size_t c = 0; c < n; ++c) {  // Gauss-Jordan: mass matrices have no vanishing leading minors
      const Real pivot = a[c * n + c];
      for (std::size_t j = 0; j < n; ++j) a[c * n + j] = a[c * n + j] / pivot, b[c * n + j] = b[c * n + j] / pivot;
      for (std::size_t r = 0; r < n; ++r) {
        if (r == c) continue;
        const Real scale = a[r * n + c];
        for (std::size_t j = 0; j < n; ++j) {
          a[r * n + j] = a[r * n + j] - scale * a[c * n + j];
          b[r * n + j] = b[r * n + j] - scale * b[c * n + j];
        }
      }
    }
    return b;
  }
  // |M^-1| (right + size(M) |x|): first-order effect of relative rounding errors of M and the right side.
  static std::vector<double> solution_size(const std::vector<Bounded>& m, const std::vector<double>& right,
                                           const std::vector<Real>& x) {
    const std::size_t n = right.size();
    const std::vector<Real> by = inverse(m, n);
    std::vector<double> residual = right, size(n, 0.0);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 0; j < n; ++j) residual[k] += m[k * n + j].size * magnitude(x[j]);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 0; j < n; ++j) size[k] += magnitude(by[k * n + j]) * residual[j];
    return size;
  }
  static std::vector<Bounded> solved(const std::vector<Bounded>& m, const std::vector<Bounded>& right) {
    const std::size_t n = right.size();
    const std::vector<Real> by = inverse(m, n);
    std::vector<Real> x(n, exact(0));
    std::vector<double> sizes;
    for (std::size_t k = 0; k < n; ++k) {
      sizes.push_back(right[k].size);
      for (std::size_t j = 0; j < n; ++j) x[k] = x[k] + by[k * n + j] * right[j].value;
    }
    const std::vector<double> size = solution_size(m, sizes, x);
    std::vector<Bounded> result;
    for (std::size_t k = 0; k < n; ++k) result.push_back({x[k], size[k]});
    return result;
  }

  const CanonicalModel& model_;
};

/// (f(x + h) - f(x - h))/(2h) of a list of numbers, x one of the numbers of a point.
inline std::vector<Real> central_difference(ExactPoint& point, Real& x,
                                            const std::function<std::vector<Real>(const ExactPoint&)>& f) {
  static const Real h = cln::cl_float(cln::cl_RA("1/100000000000000000"), cln::float_format(60));
  const Real middle = x;
  x = middle + h;
  const std::vector<Real> up = f(point);
  x = middle - h;
  const std::vector<Real> down = f(point);
  x = middle;
  std::vector<Real> slope;
  for (std::size_t i = 0; i < up.size(); ++i) slope.push_back((up[i] - down[i]) / (h + h));
  return slope;
}

}  // namespace secular::test
