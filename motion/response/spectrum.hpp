#pragma once

#include <Eigen/Core>

namespace secular {

/// Eigenvalues of the Jacobian at a fixed point.
struct Spectrum {
  Eigen::VectorXcd eigenvalues;  ///< by falling real part, positive imaginary part first
  int unstable = 0;              ///< with a real part above 1e-9 of the largest modulus
};

/// Not numbers, and none unstable, where the Jacobian is not finite.
Spectrum spectrum_of(const Eigen::Ref<const Eigen::MatrixXd>& jacobian);

/// Two eigenvalues seen through their sum and product. Both stay real-analytic functions of the matrix while the
/// two collide on the real axis, as long as the other eigenvalues keep away: a Hopf point has sum 0 and product
/// frequency^2 > 0, a neutral saddle sum 0 and product < 0, a double zero both 0.
struct EigenvaluePair {
  double sum = 0, product = 0;
};

/// The pair (real, or complex conjugate) with the smallest |sum|; needs two eigenvalues at least.
EigenvaluePair most_neutral_pair(const Spectrum& spectrum);

/// The pair nearest to the given one.
EigenvaluePair nearest_pair(const Spectrum& spectrum, const EigenvaluePair& reference);

/// Test function of Hopf points: the product over all pairs of their sums has its sign (it is the determinant of
/// the bialternate product 2J (.) I: Kuznetsov, Elements of Applied Bifurcation Theory, section 10.2), the smallest
/// |sum| over the largest modulus is its size. 0 for a single eigenvalue.
double hopf_test(const Spectrum& spectrum);

}  // namespace secular
