#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "blind/disturbances.hpp"
#include "blind/effect.hpp"
#include "blind/specimen.hpp"

namespace secular::blind {

/// Noise of the channels of a specimen's records.
struct ChannelNoise {
  std::vector<double> sd;  ///< white, by channel, in its unit
  Disturbances disturbances;

  /// Standard deviation of white noise with the density of all at `hz`.
  double as_white(std::size_t channel, double hz) const;
};

/// Fourier coefficients of the responses of all stretches in standard deviations of their noise: by stretch,
/// frequency and channel a real and an imaginary part, whose squares sum up to those of the samples.
Eigen::VectorXd stretch_spectra(const Specimen& specimen, const Reality& reality, const ChannelNoise& noise);

/// First row and number of rows of each stretch.
struct RowsOfStretch {
  Eigen::Index first = 0, count = 0;
};
std::vector<RowsOfStretch> rows_of_stretches(const Specimen& specimen);

/// A change of these with the noise of the excitation's reading counted as noise: what white noise of the reading
/// makes in the responses, by the linear receptance h (standard deviations of the responses per one of the
/// reading), has the covariance I + h h^*, whose inverse root is applied at every frequency.
Eigen::VectorXd beside_excitation_noise(const Specimen& specimen, const ChannelNoise& noise,
                                        Eigen::VectorXd change);

}  // namespace secular::blind
