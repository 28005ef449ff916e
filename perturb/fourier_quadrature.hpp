#pragma once

#include <complex>

namespace secular {

/// Coefficient of exp(i n phi) in |x| (`absolute`) or sgn(x), x = Re(phasor exp(i phi)):
///   (1/2 pi) int_0^{2 pi} f(x(phi)) exp(-i n phi) dphi,
/// by Gauss-Legendre quadrature between the sign changes of x. Shares nothing with the closed series.
std::complex<double> fourier_by_quadrature(std::complex<double> phasor, bool absolute, int n);

}  // namespace secular
