#include "measure/signal/bispectral_phase.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

#include "numerics/hertz.hpp"

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXcd;

BispectralPhase bispectral_phase(const Eigen::Ref<const VectorXcd>& excitation,
                                 const Eigen::Ref<const VectorXcd>& first,
                                 const Eigen::Ref<const VectorXcd>& second, const EnsembleLayout& layout,
                                 double false_alarm) {
  const Index count = excitation.size();
  if (count < 2 || first.size() != count || second.size() != count)
    throw std::invalid_argument("a bispectral phase needs two or more ensembles of all three amplitudes");
  const VectorXcd pair = first.cwiseProduct(second);
  const VectorXcd products = excitation.cwiseProduct(pair.conjugate());
  const Complex mean = products.mean();
  const double length = std::abs(mean);
  BispectralPhase result;
  const double power =
      excitation.squaredNorm() * pair.squaredNorm() / (static_cast<double>(count) * static_cast<double>(count));
  if (!(length > 0) || !(power > 0)) {
    result.gamma_sd = std::numeric_limits<double>::infinity();
    return result;
  }
  // Along and across the mean: the angle is across/along to second order.
  Eigen::MatrixXd turned(count, 2);
  for (Index k = 0; k < count; ++k) {
    const Complex value = products(k) * std::conj(mean) / (length * length);
    turned(k, 0) = value.real();
    turned(k, 1) = value.imag();
  }
  const EnsembleMean statistics = ensemble_mean(turned, layout);
  result.bias = -statistics.covariance(0, 1);
  result.gamma = std::remainder(std::arg(mean) - result.bias, two_pi);
  result.gamma_sd = std::sqrt(statistics.covariance(1, 1));
  result.degrees_of_freedom = statistics.degrees_of_freedom;
  result.bicoherence = std::min(1.0, length * length / power);
  // Independent phases: the bicoherence of K independent ensembles exceeds x with probability about exp(-K x).
  result.locked = std::exp(-statistics.independent * result.bicoherence) < false_alarm;
  return result;
}

}  // namespace secular
