#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "measure/signal/pole.hpp"

namespace secular {

/// How the coefficients of the symmetric characteristic polynomial are estimated.
enum class PolynomialMethod {
  least_squares,      ///< thesis 4.3.1, Eqs. (4.27), (4.28); biased by noise
  noise_eigenvector,  ///< thesis 4.3.2, Eqs. (4.45)-(4.47); consistent in white noise
  lagged_covariance,  ///< thesis 4.3.3, Eqs. (4.49), (4.50); consistent in white noise
};

/// Coefficients of the symmetric polynomial alpha_n + sum_{j=1..n} alpha_{n+j} (z^j + z^-j) of Eq. (4.26).
struct SymmetricPolynomial {
  Eigen::VectorXd coefficients;    ///< alpha_n ... alpha_2n, imposed factors included
  Eigen::VectorXd free;            ///< the same without the imposed factors, from which the poles are taken
  Eigen::VectorXd channel_weight;  ///< weight of each channel's rows, unit 1/(unit of the channel)
  bool determined = true;          ///< false: the rows give no finite coefficients
  double noise_variance = 0;       ///< weighted; smallest eigenvalue of Eq. (4.47) by rows, noise_eigenvector only
};

/// The fewest samples for so many pairs, imposed ones among them.
Eigen::Index fewest_for_polynomial(Eigen::Index pairs, PolynomialMethod method);

/// Estimates the polynomial with `order` free pairs from samples x channels that share their poles: the rows of
/// Eq. (4.27) of all channels are stacked, each channel divided by the noise level that its own smallest eigenvalue
/// of (4.47) shows. `imposed` are known frequencies (rad per sample, 0 for a constant): the polynomial is their
/// product (z + 1/z - 2 cos imposed) times the free part, and the noise metric of (4.47) follows that product.
/// Throws std::invalid_argument for less than fewest_for_polynomial samples.
SymmetricPolynomial estimate_symmetric_polynomial(const Eigen::Ref<const Eigen::MatrixXd>& channels, int order,
                                                  std::span<const double> imposed, PolynomialMethod method);

/// Poles of alpha_0' + sum alpha_j' (z^j + z^-j): roots in z + 1/z, so that reciprocal pairs are exact, sorted into
/// the families of thesis Eqs. (4.29)-(4.42). Frequencies and rates per sample.
std::vector<Pole> poles_of(const Eigen::Ref<const Eigen::VectorXd>& symmetric);

}  // namespace secular
