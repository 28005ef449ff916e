#pragma once

#include <Eigen/Core>

namespace secular {

/// A slower copy of a record, and where its samples lie.
struct Decimated {
  Eigen::MatrixXd samples;  ///< rows x channels
  double sample_rate_hz = 0;
  Eigen::Index factor = 1;  ///< row i is at original sample first + i * factor
  Eigen::Index first = 0;
  Eigen::Index half_length = 0;  ///< of the filter, original samples: a row sees that far to both sides
};

/// Largest factor that keeps everything up to `highest_hz` in the lower 80 % of the new band; one where the rate
/// allows no more.
Eigen::Index decimation_factor(double sample_rate_hz, double highest_hz);

/// The fewest samples that the filter fits into.
Eigen::Index fewest_to_decimate(Eigen::Index factor);

/// Linear-phase low-pass filter (Kaiser window, 80 dB beyond the new half rate, flat to 1e-4 up to 80 % of it) and
/// every factor-th sample, where the filter lies inside the record. A sum of exponentials stays one with the same
/// poles as long as the filter sees nothing else. Throws std::invalid_argument for a record shorter than the
/// filter.
Decimated decimate(const Eigen::Ref<const Eigen::MatrixXd>& samples, double sample_rate_hz, Eigen::Index factor);

}  // namespace secular
