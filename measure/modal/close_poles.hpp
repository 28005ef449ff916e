#pragma once

#include <Eigen/Core>
#include <complex>
#include <utility>

#include "measure/modal/pole_fit.hpp"

namespace secular {

/// Two poles in the place of the one at `row` of a fit to these samples (rows x signals): those of a grid over some
/// bandwidths that explain most beside the others.
std::pair<std::complex<double>, std::complex<double>> closest_pair(const Eigen::Ref<const Eigen::MatrixXd>& samples,
                                                                   double sample_rate_hz, const PoleFit& fit,
                                                                   Eigen::Index row);

/// Poles with those two in the place of the one: the second is the last.
Eigen::VectorXcd with_pair(const Eigen::VectorXcd& poles, Eigen::Index row,
                           const std::pair<std::complex<double>, std::complex<double>>& pair);

}  // namespace secular
