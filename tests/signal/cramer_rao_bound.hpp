#pragma once

#include <Eigen/Core>
#include <span>

#include "measure/signal/folded_window.hpp"
#include "measure/signal/pole_covariance.hpp"
#include "measure/signal/pole_equations.hpp"

namespace secular::testing_support {

/// Cramer-Rao bound in the order of PoleCovariance::matrix: poles and amplitudes ([function][channel], origin at
/// the centre of the window) taken as true, noise_sd per channel.
inline Eigen::MatrixXd cramer_rao_bound(std::span<const Pole> poles,
                                        const Eigen::Ref<const Eigen::MatrixXd>& amplitudes,
                                        const Eigen::Ref<const Eigen::VectorXd>& noise_sd, Eigen::Index samples,
                                        double sample_rate_hz) {
  const FoldedWindow window(samples, sample_rate_hz);
  const FoldedFunctions functions(poles, window);
  return PoleCovariance(poles, PoleMoments(Gram(functions.gram()), functions.timed_moments()), amplitudes,
                        noise_sd.array().square(), window.half)
      .matrix();
}

}  // namespace secular::testing_support
