#include "codegen/runtime/monomial.hpp"

#include <algorithm>
#include <cstdlib>

#include "estimator/model/integer_power.hpp"

namespace secular {

using Complex = std::complex<double>;

Monomial::Monomial(const CanonicalPowers& powers) {
  const std::size_t modes = powers.amplitude.size();
  for (std::size_t k = 0; k < modes; ++k) {
    AmplitudePowers p;
    p.pairs = std::min(powers.amplitude[k], powers.conjugate[k]);
    const int turned = powers.amplitude[k] - p.pairs, returned = powers.conjugate[k] - p.pairs;
    p.turned = turned > returned;
    p.directions = std::min(std::max(turned, returned), std::max(0, -powers.modulus[k]));
    p.modulus = powers.modulus[k] + p.directions;
    p.forward = p.turned ? turned - p.directions : 0;
    p.backward = returned > turned ? returned - p.directions : 0;
    amplitudes_.push_back(p);
  }
  for (std::size_t j = 0; j < powers.forcing.size(); ++j) {
    const int net = powers.phase[modes + j];
    forcings_.push_back({(powers.forcing[j] - std::abs(net)) / 2, net});
  }
}

std::complex<double> Monomial::operator()(const std::complex<double>* amplitude,
                                          const std::complex<double>* forcing) const {
  Complex product(1);
  for (std::size_t k = 0; k < amplitudes_.size(); ++k) {
    const AmplitudePowers& p = amplitudes_[k];
    const Complex a = amplitude[k];
    if (p.pairs) product *= integer_power(std::norm(a), p.pairs);
    if (p.modulus || p.directions) {
      const double size = std::abs(a);
      if (p.modulus > 0) product *= integer_power(size, p.modulus);
      if (p.modulus < 0) product *= integer_power(size > 0 ? 1 / size : 0.0, -p.modulus);
      const Complex direction = size > 0 ? a / size : Complex();
      if (p.directions) product *= integer_power(p.turned ? direction : std::conj(direction), p.directions);
    }
    if (p.forward) product *= integer_power(a, p.forward);
    if (p.backward) product *= integer_power(std::conj(a), p.backward);
  }
  for (std::size_t j = 0; j < forcings_.size(); ++j) {
    const ForcingPowers& p = forcings_[j];
    if (p.pairs) product *= integer_power(std::norm(forcing[j]), p.pairs);
    if (p.net) product *= integer_power(p.net > 0 ? forcing[j] : std::conj(forcing[j]), std::abs(p.net));
  }
  return product;
}

}  // namespace secular
