#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace secular {

/// p cos(frequency t) + q sin(frequency t), frequency in rad/s.
struct CircularTerm {
  double frequency = 0, p = 0, q = 0;
};
/// a cosh(rate t) + b sinh(rate t), rate in 1/s.
struct HyperbolicTerm {
  double rate = 0, a = 0, b = 0;
};
/// (-1)^l [c cosh(rate t) + d sinh(rate t)] at sample l.
struct NyquistHyperbolicTerm {
  double rate = 0, c = 0, d = 0;
};
/// e cos(w t) cosh(k t) + f sin(w t) cosh(k t) + g cos(w t) sinh(k t) + h sin(w t) sinh(k t).
struct ProductTerm {
  double rate = 0, frequency = 0, e = 0, f = 0, g = 0, h = 0;
};

/// A signal as a sum of circular and hyperbolic functions, thesis Eq. (4.3); t = 0 at the first sample.
struct CircularHyperbolicFit {
  std::vector<CircularTerm> circular;
  std::vector<HyperbolicTerm> hyperbolic;
  std::vector<NyquistHyperbolicTerm> nyquist;
  std::vector<ProductTerm> products;
  double correlation = 0;         ///< gamma^2 between samples and fit
  double signal_to_noise_db = 0;  ///< power of the fit over power of what is left
};

/// Circular-hyperbolic decomposition, least-squares variant (thesis section 4.3.1): the symmetric characteristic
/// polynomial of Eqs. (4.26)-(4.28), its poles as roots of a polynomial of degree `order` in z + 1/z (so that
/// reciprocal pairs are exact), residues by linear least squares (4.19), families by (4.29)-(4.42). A product of
/// circular and hyperbolic functions takes two of the `order`. The least-squares polynomial is biased by noise:
/// decompose() in decomposition.hpp offers the others and refinement. Throws std::invalid_argument for fewer than
/// 3*order samples or an order below one.
CircularHyperbolicFit circular_hyperbolic_decomposition(const Eigen::Ref<const Eigen::VectorXd>& samples,
                                                        double sample_rate_hz, int order);

}  // namespace secular
