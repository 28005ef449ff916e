#include "measure/signal/exponential_fit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

SpectrumPeak spectrum_peak(const Eigen::Ref<const VectorXd>& samples, double sample_rate_hz, double near) {
  const Index n = samples.size();
  if (n < 4) throw std::invalid_argument("too few samples for a spectrum");
  const double bin = two_pi * sample_rate_hz / static_cast<double>(n);
  const Index last = n / 2 - 1;
  // Three lines alone are wanted: a sum each, by a rotation that is exact again at every 64th sample.
  const auto line = [&](Index k) {
    const double turn = two_pi * static_cast<double>(k) / static_cast<double>(n);
    const Complex step = std::polar(1.0, -turn);
    Complex sum = 0, rotation = 1;
    for (Index i = 0; i < n; ++i) {
      rotation = i % 64 == 0 ? std::polar(1.0, -turn * static_cast<double>(i)) : rotation * step;
      sum += rotation * samples(i);
    }
    return sum;
  };
  const auto centre = static_cast<Index>(std::lround(near / bin));
  const Index low = std::clamp<Index>(centre - 1, 1, last), high = std::clamp<Index>(centre + 1, 1, last);
  Index at = low;
  Complex peak = line(low);
  for (Index k = low + 1; k <= high; ++k)
    if (const Complex other = line(k); std::norm(other) > std::norm(peak)) {
      peak = other;
      at = k;
    }
  const Complex value = peak * (2 / static_cast<double>(n));
  return {bin * static_cast<double>(at), value.real(), -value.imag()};
}

}  // namespace secular
