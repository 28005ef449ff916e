#include "perturb/fourier_quadrature.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace secular {

std::complex<double> fourier_by_quadrature(std::complex<double> phasor, bool absolute, int n) {
  const auto x = [&](double phi) { return (phasor * std::polar(1.0, phi)).real(); };
  const double zero = std::numbers::pi / 2 - std::arg(phasor);
  std::complex<double> sum = 0;
  constexpr int panels = 8;  // four to each sign, 20 nodes each
  for (int panel = 0; panel < panels; ++panel) {
    const double from = zero + 2 * std::numbers::pi * panel / panels, to = from + 2 * std::numbers::pi / panels;
    const double sign = x(0.5 * (from + to)) > 0 ? 1 : -1;
    const auto integral = [&](auto part) {
      return boost::math::quadrature::gauss<double, 20>::integrate(
          [&](double phi) { return (absolute ? sign * x(phi) : sign) * part(n * phi); }, from, to);
    };
    sum += std::complex<double>(integral([](double a) { return std::cos(a); }),
                                -integral([](double a) { return std::sin(a); }));
  }
  return sum / (2 * std::numbers::pi);
}

}  // namespace secular
