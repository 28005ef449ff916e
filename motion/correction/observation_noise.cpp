#include "motion/correction/observation_noise.hpp"

#include <complex>
#include <cstddef>

#include "measure/observe/mode_frequencies.hpp"
#include "motion/simulate/noise.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

void add_noise(Observation& o, const ModeFrequencies& modes, NoiseStream& noise) {
  const auto complex_noise = [&](double sd) {
    const double real = noise.gaussian(), imaginary = noise.gaussian();
    return sd * Complex(real, imaginary);
  };
  for (std::size_t j = 0; j < o.forcing.size(); ++j) {
    o.excitation_frequency[j] += o.excitation_frequency_sd[j] * noise.gaussian();
    o.forcing[j] += complex_noise(o.forcing_sd[j]);
  }
  Eigen::VectorXd free(modes.coupling.cols());
  for (Index f = 0; f < free.size(); ++f) {
    const auto at = static_cast<std::size_t>(f);
    free(f) = o.rate[modes.free[at]].imag() + o.free_frequency_sd[at] * noise.gaussian();
  }
  const Eigen::VectorXd observed = modes.observed(free, o.excitation_frequency);
  for (std::size_t k = 0; k < o.amplitude.size(); ++k) {
    o.amplitude[k] += complex_noise(o.amplitude_sd[k]);
    o.rate[k] = Complex(o.rate[k].real(), observed(static_cast<Index>(k)));
  }
  for (std::size_t b = 0; b < o.harmonic.size(); ++b)
    if (o.harmonic_sd[b] > 0) o.harmonic[b] += complex_noise(o.harmonic_sd[b]);
}

}  // namespace

ObservationSet with_observation_noise(ObservationSet exact, std::uint64_t seed) {
  const ModeFrequencies modes = mode_frequencies(*exact.model, *exact.resonance);
  for (std::size_t i = 0; i < exact.observations.size(); ++i) {
    NoiseStream noise(seed, i, 0);
    add_noise(exact.observations[i], modes, noise);
  }
  return exact;
}

}  // namespace secular
