#pragma once

#include <complex>
#include <map>
#include <vector>

namespace secular::verify {

/// A quasi-periodic record with slowly moving harmonics, taken apart by least squares:
///   v(t) = sum over integer vectors n of c_n(t) exp(i n.omega t),
/// with c_n(t) a polynomial in time. Values and rates are those at the middle of the record.
struct Demodulation {
  std::map<std::vector<int>, std::complex<double>> harmonic;  ///< c_n
  std::map<std::vector<int>, std::complex<double>> rate;      ///< dc_n/dt
  double residual = 0;                                        ///< largest misfit of a sample
  double time = 0;                                            ///< the middle
};

/// `highest`: largest sum of |n|; `degree`: of the polynomials. Samples start at time 0.
Demodulation demodulated(const std::vector<double>& record, double step, const std::vector<double>& frequencies,
                         int highest, int degree);

}  // namespace secular::verify
