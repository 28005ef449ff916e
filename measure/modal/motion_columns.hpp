#pragma once

#include <Eigen/Core>
#include <complex>

namespace secular {

/// exp(pole t) at rows 0, 1/rate, 2/rate, ...; pole in 1/s, rate in Hz.
Eigen::VectorXcd exponential(Eigen::Index rows, double rate, std::complex<double> pole);

/// Real columns (rows x 2) of (Re R, Im R) in 2 Re(R motion).
Eigen::MatrixXd motion_columns(const Eigen::VectorXcd& motion);

}  // namespace secular
