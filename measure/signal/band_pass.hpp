#pragma once

#include <Eigen/Core>

namespace secular {

/// A band of frequencies, Hz.
struct Band {
  double low_hz = 0, high_hz = 0;
};

/// Half the length of band_pass's impulse response in samples.
Eigen::Index band_pass_reach(const Band& band, double sample_rate_hz);

/// Samples x channels without what lies outside of a band: a symmetric finite impulse response (windowed sinc,
/// Hann), which delays nothing. A quarter of the band's width is lost at each edge. Of the result only what is free
/// of the record's ends is returned: band_pass_reach samples fewer at the beginning and at the end; nothing where
/// the record is shorter than that.
Eigen::MatrixXd band_pass(const Eigen::MatrixXd& samples, double sample_rate_hz, const Band& band);

}  // namespace secular
