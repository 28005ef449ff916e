#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace secular {

/// Kinds of terms whose poles come in reciprocal pairs, thesis Eq. (4.3); `constant` is the limit of zero
/// frequency.
enum class PoleFamily { constant, circular, hyperbolic, nyquist_hyperbolic, product };

/// One frequency of Eq. (4.3). Its functions, with time t from the origin and sample number l from 0:
///   constant             1
///   circular             cos(frequency t), sin(frequency t)                         amplitudes p, q
///   hyperbolic           cosh(rate t), sinh(rate t)                                 amplitudes a, b
///   nyquist_hyperbolic   (-1)^l cosh(rate t), (-1)^l sinh(rate t)                   amplitudes c, d
///   product              cos cosh, sin cosh, cos sinh, sin sinh (frequency, rate)   amplitudes e, f, g, h
struct Pole {
  PoleFamily family = PoleFamily::circular;
  double frequency = 0;  ///< rad/s, of circular and product
  double rate = 0;       ///< 1/s, of the hyperbolic families and product
  bool imposed = false;  ///< known beforehand, not an unknown of the estimation
};

/// Small matrices on the functions of one pole, without allocation.
using PoleMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 4, 4>;

/// Number of functions, 1, 2 or 4.
Eigen::Index function_count(const Pole& pole);
Eigen::Index function_count(std::span<const Pole> poles);

/// Unknowns of the pole itself: none if imposed or constant, frequency or rate, or (frequency, rate) for a product.
Eigen::Index parameter_count(const Pole& pole);
Eigen::Index parameter_count(std::span<const Pole> poles);

/// Matrix X with d/dparameter [c^T g(t)] = t (X c)^T g(t), g the pole's functions, c their amplitudes.
PoleMatrix generator(const Pole& pole, Eigen::Index parameter);

/// Matrix S with c^T g(t + shift) = (S c)^T g(t): amplitudes for an origin moved `shift` seconds later. The sign
/// (-1)^l of the Nyquist family stays with the sample.
PoleMatrix shift_matrix(const Pole& pole, double shift);

/// The functions at `samples` instants, the first at `first` seconds from the origin: samples x function_count.
Eigen::MatrixXd pole_functions(std::span<const Pole> poles, Eigen::Index samples, double sample_rate_hz,
                               double first);

}  // namespace secular
