// Model duffing: generated code, never edited by hand.
// Holds rows of the case primary. Made by: secular generate duffing.
// Omega = omega0 + eps^2*sigma, multiple scales to eps^2. Valid near that resonance for small amplitudes; what
// is left out is of order eps^3.
#pragma once

#include "duffing.free.hpp"
#include "duffing.hpp"

namespace secular::generated::duffing {

namespace primary {

/// (rate - i*omega0)*A_x = -mu*A_x + i*conservative_x_A_x2_conjA_x*A_x^2*conj(A_x) - 1/(4*omega0)*i*e*F
struct modulation_of_x : BlockShape<3, 3, follows_modes | is_forced> {
  template <class Number>
  static NumberList<Number, 3> factors(const Model::Frequencies<Number>& frequencies) {
    const auto& [omega0, Omega] = frequencies;
    return {-1.0, 1.0, -1.0 / (4.0 * omega0)};
  }
  template <class Number, class Factors> [[gnu::always_inline]]
  static void row(const Model::Signals<Number>& signals, const Factors& factor, ComplexNumber<Number>* column) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    column[0] = factor[0] * A_x;  // mu
    column[1] = times_i(factor[1] * (norm_A_x * A_x));  // conservative_x_A_x2_conjA_x
    column[2] = times_i(factor[2] * F);  // e
  }
  static void slopes(const Model::Signals<double>& signals, const double* factor, const double* lump,
      ComplexNumber<double>* by, ComplexNumber<double>* by_conjugate) {
    const auto& [A_x, conj_A_x, norm_A_x, F, conj_F, norm_F] = signals;
    by[0] = ComplexNumber<double>(lump[0] * factor[0], 2.0 * lump[1] * factor[1] * norm_A_x);
    by_conjugate[0] = times_i(lump[1] * factor[1] * (A_x * A_x));
  }
};

inline constexpr BlockFunctions blocks[4] = {modulation_functions<Model, modulation_of_x>(),
    harmonic_functions<Model, free::harmonic_0_of_x>(), harmonic_functions<Model, free::harmonic_2_omega0_of_x>(),
    harmonic_functions<Model, free::harmonic_3_omega0_of_x>()};

}  // namespace primary
}  // namespace secular::generated::duffing
