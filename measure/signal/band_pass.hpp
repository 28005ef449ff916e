#pragma once

#include <Eigen/Core>

namespace secular {

/// A band of frequencies, Hz.
struct Band {
  double low_hz = 0, high_hz = 0;
};

/// Half the length of band_pass's impulse response in samples: three over the width in which it falls off, which is
/// the band's own or, where that is less, the distance from its lower edge to zero.
Eigen::Index band_pass_reach(const Band& band, double sample_rate_hz);

/// Samples x channels without what lies outside of a band: a symmetric finite impulse response (windowed sinc,
/// Blackman), which delays nothing. What lies in the band stays within 3e-4; on both sides of it the response falls
/// to that within the width named above. A band from zero on is a low-pass; one whose fall ends above half the
/// sample rate passes everything from its lower edge on. Of the result only what is free of the record's ends is
/// returned: band_pass_reach samples fewer at the beginning and at the end; nothing where the record is shorter.
Eigen::MatrixXd band_pass(const Eigen::MatrixXd& samples, double sample_rate_hz, const Band& band);

/// Of the variance of white noise, what the band leaves.
double band_share_of_noise(const Band& band, double sample_rate_hz);

}  // namespace secular
