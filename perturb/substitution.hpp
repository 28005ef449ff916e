#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "perturb/degree_series.hpp"
#include "perturb/true_time_motion.hpp"

namespace secular {

/// The equations of motion as the file states them, read node by node from the parsed text and evaluated on an
/// expansion as a function of true time. Lagrange's equations are formed here,
///   d/dt dT/dq' - dT/dq + dV/dq - force,
/// with derivatives carried along every node. For ExactArithmetic and FloatingArithmetic.
template <class Arithmetic>
class Substitution {
 public:
  using Number = typename Arithmetic::Number;
  using Polynomial = GradedPolynomial<Number>;

  Substitution(const Derivation& derivation, Arithmetic arithmetic);

  const TrueTimeMotion<Arithmetic>& motion() const { return motion_; }

  /// What is left of mode k's equation, in normal form; zero everywhere if the expansion solves it. Exact
  /// arithmetic leaves out what nonsmooth terms add: odd powers of |A| only.
  Polynomial residual(std::size_t k);
  /// Whether any residual so far had a nonsmooth term with a Fourier series.
  bool nonsmooth() const { return nonsmooth_; }
  /// Random A_k at which nonsmooth terms are evaluated; exact arithmetic has none. (No requires-clause: clang 14
  /// instantiates the function all the same.)
  std::vector<std::complex<double>> amplitudes() const;

 private:
  // A value with its derivatives by the varied mode's coordinate and velocity (Lagrange's equations).
  struct Jet {
    Polynomial value, by_position, by_velocity;
  };

  Jet still(Polynomial value) const;
  Jet times(const Jet& a, const Jet& b) const;
  Jet derived(const Jet& inner) const;
  Jet reciprocal_constant(const Jet& divisor) const;

  Jet jet(const Expression& e, const FormulaSource& source);
  Jet symbol_jet(const Expression& e) const;
  Jet power_jet(const Jet& base, const GiNaC::numeric& exponent) const;
  Jet function_jet(const std::string& name, const Jet& argument) const;
  Jet composed(const Jet& argument, const DegreeSeries<Arithmetic>& value,
               const DegreeSeries<Arithmetic>& slope) const;
  Polynomial marked(const Polynomial& p) const;
  DegreeSeries<Arithmetic> by_degree(const Polynomial& p) const;
  Jet call_jet(const Expression& e, const FormulaSource& source);
  Polynomial clock(const Expression& e, const FormulaSource& source) const;
  Polynomial nonsmooth_function(bool absolute, const Polynomial& x);

  const Derivation& d_;
  const Model& model_;
  Arithmetic arithmetic_;
  TrueTimeMotion<Arithmetic> motion_;
  std::optional<std::size_t> varied_;
  bool nonsmooth_ = false;
};

}  // namespace secular
