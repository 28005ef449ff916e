#pragma once

#include <cmath>
#include <vector>

#include "numerics/hertz.hpp"

namespace secular::testing_support {

struct DrivenMode {
  double hz = 0, damping_ratio = 0;
};

/// Displacements of modes at rest that a signal drives, exact where the signal is constant from sample to sample.
/// `rate`: Hz.
inline std::vector<double> driven_response(const std::vector<double>& excitation,
                                           const std::vector<DrivenMode>& modes, double rate) {
  std::vector<double> response(excitation.size(), 0);
  for (const DrivenMode& mode : modes) {
    const double w = two_pi * mode.hz, decay = mode.damping_ratio * w, own = std::sqrt(w * w - decay * decay);
    const double e = std::exp(-decay / rate), c = std::cos(own / rate), s = std::sin(own / rate);
    double x = 0, v = 0;
    for (std::size_t i = 0; i < excitation.size(); ++i) {
      response[i] += x;
      const double y = x - excitation[i] / (w * w);
      x = e * (y * (c + decay / own * s) + v / own * s) + excitation[i] / (w * w);
      v = e * (v * (c - decay / own * s) - y * w * w / own * s);
    }
  }
  return response;
}

}  // namespace secular::testing_support
