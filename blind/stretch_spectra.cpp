#include "blind/stretch_spectra.hpp"

#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <utility>

#include "blind/measurement.hpp"

namespace secular::blind {
namespace {

using Eigen::Index;

Index frequencies_of(const Stretch& stretch) {
  return static_cast<Index>(stretch.samples / 2 + 1);
}

double hz_of(const Stretch& stretch, Index k) {
  return static_cast<double>(k) * sample_rate_hz / static_cast<double>(stretch.samples);
}

State begin_of(const Stretch& stretch, const State& added) {
  State state = stretch.state;
  for (std::size_t i = 0; i < state.size(); ++i) state[i] += added[i];
  return state;
}

// Of the first mode, by response channel: response over excitation.
Eigen::VectorXcd receptance(const Specimen& specimen, double hz) {
  const ModeTerms& mode = specimen.structure.mode[0];
  const double w = two_pi * hz;
  const std::complex<double> displacement =
      mode.direct / std::complex<double>(mode.omega * mode.omega - w * w, 2 * specimen.decay_rate[0] * w);
  const std::complex<double> read = specimen.measurement.of_displacement ? displacement : -w * w * displacement;
  Eigen::VectorXcd channels(static_cast<Index>(specimen.measurement.shapes.size()));
  for (Index c = 0; c < channels.size(); ++c)
    channels(c) = specimen.measurement.shapes[static_cast<std::size_t>(c)][0] * read;
  return channels;
}

}  // namespace

double ChannelNoise::as_white(std::size_t channel, double hz) const {
  return std::hypot(sd[channel], disturbances.coloured_as_white(channel, hz));
}

std::vector<RowsOfStretch> rows_of_stretches(const Specimen& specimen) {
  const auto responses = static_cast<Index>(specimen.measurement.shapes.size());
  std::vector<RowsOfStretch> rows;
  for (const Stretch& stretch : specimen.stretches)
    rows.push_back(
        {rows.empty() ? 0 : rows.back().first + rows.back().count, 2 * responses * frequencies_of(stretch)});
  return rows;
}

Eigen::VectorXd stretch_spectra(const Specimen& specimen, const Reality& reality, const ChannelNoise& noise) {
  const std::vector<RowsOfStretch> rows = rows_of_stretches(specimen);
  const auto responses = static_cast<Index>(specimen.measurement.shapes.size());
  Eigen::VectorXd result = Eigen::VectorXd::Zero(rows.back().first + rows.back().count);
  Eigen::FFT<double> transform;
  for (std::size_t s = 0; s < rows.size(); ++s) {
    const Stretch& stretch = specimen.stretches[s];
    const State begun = reality.begun.empty() ? stretch.state : begin_of(stretch, reality.begun[s]);
    const Motion motion =
        recorded_motion(reality.structure, stretch.drive, begun, stretch.samples, specimen.settling.substeps);
    const auto samples = measured(reality.measurement, stretch.drive, motion, true);
    for (Index c = 0; c < responses; ++c) {
      std::vector<std::complex<double>> spectrum;
      transform.fwd(spectrum, samples[static_cast<std::size_t>(c + 1)]);
      for (Index k = 0; k < frequencies_of(stretch); ++k) {
        const bool alone = k == 0 || 2 * k == static_cast<Index>(stretch.samples);  // no conjugate beside it
        const double sd = noise.as_white(static_cast<std::size_t>(c + 1), hz_of(stretch, k)) *
                          std::sqrt(static_cast<double>(stretch.samples) / (alone ? 1 : 2));
        const Index at = rows[s].first + 2 * (k * responses + c);
        result(at) = spectrum[static_cast<std::size_t>(k)].real() / sd;
        result(at + 1) = alone ? 0 : spectrum[static_cast<std::size_t>(k)].imag() / sd;
      }
    }
  }
  return result;
}

Eigen::VectorXd beside_excitation_noise(const Specimen& specimen, const ChannelNoise& noise,
                                        Eigen::VectorXd change) {
  const std::vector<RowsOfStretch> rows = rows_of_stretches(specimen);
  const auto responses = static_cast<Index>(specimen.measurement.shapes.size());
  for (std::size_t s = 0; s < rows.size(); ++s) {
    const Stretch& stretch = specimen.stretches[s];
    if (!stretch.is_driven()) continue;
    for (Index k = 1; k + 1 < frequencies_of(stretch); ++k) {
      const double hz = hz_of(stretch, k);
      Eigen::VectorXcd h = noise.as_white(0, hz) * receptance(specimen, hz);
      for (Index c = 0; c < responses; ++c) h(c) /= noise.as_white(static_cast<std::size_t>(c + 1), hz);
      const double square = h.squaredNorm();
      if (square == 0) continue;
      Eigen::Map<Eigen::VectorXcd> here(
          reinterpret_cast<std::complex<double>*>(change.data() + rows[s].first + 2 * k * responses), responses);
      here -= h * (h.dot(here) / square * (1 - 1 / std::sqrt(1 + square)));
    }
  }
  return change;
}

}  // namespace secular::blind
