#include "perturb/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "perturb/nonsmooth.hpp"
#include "perturb/substitution.hpp"

namespace secular {
namespace {

// Rounding of nonsmooth coefficients, over the largest harmonic of their equation.
constexpr double nonsmooth_rounding = 1e-10;

// Largest harmonic of a mode's acceleration: the scale of its equation.
double largest_acceleration(const Substitution<FloatingArithmetic>& substitution, std::size_t mode) {
  const TrueTimeMotion<FloatingArithmetic>& motion = substitution.motion();
  double largest = 0;
  for (const auto& terms : motion.of_mode(mode, 2).orders())
    for (const auto& [waves, value] : at_amplitudes(terms, motion.variables(), substitution.amplitudes()))
      largest = std::max(largest, std::abs(value));
  return largest;
}

// Floating check of the coefficients that nonsmooth terms touch.
void check_nonsmooth(const Derivation& d, Certificate& certificate) {
  certificate.nonsmooth_harmonics = highest_nonsmooth_harmonic;
  for (std::uint64_t draw = 11; draw < 14; ++draw) {
    Substitution<FloatingArithmetic> substitution(d, FloatingArithmetic{draw});
    for (std::size_t k = 0; k < d.model->modes.size(); ++k) {
      const auto residual = substitution.residual(k);
      const double largest = largest_acceleration(substitution, k);
      for (std::size_t n = 0; n < residual.orders().size(); ++n) {
        for (const auto& [waves, value] :
             at_amplitudes(residual.orders()[n], substitution.motion().variables(), substitution.amplitudes())) {
          const bool compared = std::all_of(waves.begin(), waves.end(),
                                            [&](int w) { return std::abs(w) <= d.nonsmooth_harmonics[n]; });
          if (!compared) continue;
          ++certificate.coefficients_checked;
          const double error = std::abs(value) / largest;
          certificate.nonsmooth_error = std::max(certificate.nonsmooth_error, error);
          if (error < nonsmooth_rounding) continue;
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
    Substitution<ExactArithmetic> substitution(d, ExactArithmetic{draw});
    certificate.coefficients_checked = 0;
    for (std::size_t k = 0; k < d.model->modes.size(); ++k) {
      const auto residual = substitution.residual(k);
      for (std::size_t n = 0; n < residual.orders().size(); ++n)
        for (const auto& [powers, value] : residual.orders()[n]) {
          if (has_odd_modulus(powers, substitution.motion().variables())) continue;
          ++certificate.coefficients_checked;
          if (value.is_zero()) continue;
          certificate.holds = false;
          const std::string left = "equation of " + d.model->modes[k].coordinate + ", eps^" + std::to_string(n) +
                                   ", coefficient of " + to_string(powers, *d.model);
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
