#pragma once

#include <string>
#include <vector>

#include "perturb/field.hpp"
#include "perturb/model.hpp"
#include "perturb/resonance.hpp"
#include "perturb/term_sum.hpp"

namespace secular {

/// Which value an excitation frequency has inside coefficients. nominal: the one that the relations give it
/// (2*omega0), its difference acting through slow time; kept: its own symbol wherever the forcing put it.
enum class OmegaPolicy { nominal, kept };

/// A nonsmooth term of mode `mode`'s equation that has no closed Fourier series: several coordinates or an offset
/// in its argument, or a leading motion of several harmonics. It enters at the highest order only, where it adds
///   coefficient/(2 i w_k) * <product of factors * exp(-i w_k t)>
/// to dA_k/dt, the mean taken over the fast phases of the leading motion. That mean is left to numerical
/// quadrature; the harmonics that the term makes at that order are not expanded.
struct QuadratureTerm {
  std::size_t mode = 0;
  int order = 0;
  GiNaC::ex coefficient;
  FactorProduct factors;
};

/// A second- or higher-order expansion by the method of multiple scales.
///
/// v_k = A_k exp(i w_k t) + conj + sum_n eps^n v_{k,n}, dA_k/dt = sum_n eps^n D_n A_k.
/// Gauge: A_k is the whole coefficient of exp(i w_k t) in v_k; homogeneous solutions are left out at every order.
struct Derivation {
  const Model* model = nullptr;
  const ResonanceCase* resonance = nullptr;
  OmegaPolicy policy = OmegaPolicy::nominal;
  FieldLayout layout;
  ResonanceLattice lattice;
  std::vector<FieldSeries> response;  ///< [mode][order], order 0 with its leading oscillation
  std::vector<FieldSeries>
      slow_derivative;  ///< [mode][n] = D_n A_mode (empty at n = 0), phases reduced to slow ones
  std::vector<QuadratureTerm> quadratures;
  std::vector<int> nonsmooth_harmonics;  ///< [order] highest harmonic to which nonsmooth contributions are complete
  std::vector<std::string> warnings;     ///< small divisors and unlisted resonances at the nominal frequencies

  /// dA_mode/dt in true time, all orders summed with eps = 1.
  Field modulation(std::size_t mode) const;
  /// What multiplies the mean of a quadrature term in dA/dt: coefficient/(2 i w_k).
  GiNaC::ex quadrature_rate(const QuadratureTerm& quadrature) const;
  /// Phase of a key in true frequencies: its slow part put back as multiples of the relations.
  Phase full_phase(const FieldKey& key) const;
};

/// Throws InputError for what cannot be derived (see ordered_equations; nonsmooth terms that would have to be
/// expanded about their own infinitely many harmonics; resonances impossible at the nominal frequencies). `model`
/// must outlive the result.
Derivation derive(const Model& model, const ResonanceCase& resonance, OmegaPolicy policy = OmegaPolicy::nominal,
                  ProductCount products = ProductCount());

}  // namespace secular
