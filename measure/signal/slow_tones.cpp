#include "measure/signal/slow_tones.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

namespace secular {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Columns 2 cos, -2 sin of every tone by powers of time over half the window, which keeps all of order one; those
// of zero frequency come last.
MatrixXd basis_of(Index samples, double rate, const std::vector<double>& frequencies, int degree,
                  int offset_degree) {
  const Index powers = degree + 1;
  const auto tones = static_cast<Index>(frequencies.size());
  const Index constant = 2 * tones * powers, unknowns = constant + offset_degree + 1;
  if (samples <= unknowns) throw std::invalid_argument("fewer samples than unknowns of slow tones");
  const double half = 0.5 * static_cast<double>(samples - 1) / rate;
  const ArrayXd u = ArrayXd::LinSpaced(samples, -1, 1);
  ArrayXXd cosine(samples, tones), sine(samples, tones);
  for (Index j = 0; j < tones; ++j) {
    const ArrayXd angle = u * (half * frequencies[static_cast<std::size_t>(j)]);
    cosine.col(j) = angle.cos();
    sine.col(j) = angle.sin();
  }
  MatrixXd basis(samples, unknowns);
  for (Index p = 0; p <= std::max<Index>(degree, offset_degree); ++p) {
    const ArrayXd power = p == 0 ? ArrayXd(ArrayXd::Ones(samples)) : ArrayXd(u.pow(static_cast<double>(p)));
    if (p <= offset_degree) basis.col(constant + p) = power;
    for (Index j = 0; j < tones && p < powers; ++j) {
      basis.col(2 * (p * tones + j)) = 2 * power * cosine.col(j);
      basis.col(2 * (p * tones + j) + 1) = -2 * power * sine.col(j);
    }
  }
  return basis;
}

}  // namespace

SlowToneFit fit_slow_tones(const Eigen::Ref<const MatrixXd>& channels, double rate,
                           const std::vector<double>& frequencies, int degree, int offset_degree) {
  const Index samples = channels.rows(), powers = degree + 1;
  const auto tones = static_cast<Index>(frequencies.size());
  const Index constant = 2 * tones * powers, unknowns = constant + offset_degree + 1;
  const double half = 0.5 * static_cast<double>(samples - 1) / rate;
  const MatrixXd basis = basis_of(samples, rate, frequencies, degree, offset_degree);
  const Eigen::HouseholderQR<MatrixXd> qr(basis);
  const MatrixXd coefficients = qr.solve(channels);
  const MatrixXd residual = channels - basis * coefficients;
  const MatrixXd upper = qr.matrixQR().topRows(unknowns).triangularView<Eigen::Upper>();
  const MatrixXd inverse =
      upper.triangularView<Eigen::Upper>().solve(MatrixXd(MatrixXd::Identity(unknowns, unknowns)));
  const VectorXd variance = inverse.rowwise().squaredNorm();  // over the noise's

  SlowToneFit fit;
  fit.degrees_of_freedom = samples - unknowns;
  fit.noise_sd =
      (residual.colwise().squaredNorm().transpose() / static_cast<double>(fit.degrees_of_freedom)).cwiseSqrt();
  double factor = 1;  // from the coefficient of u^p to the derivative of order p
  for (Index p = 0; p < powers; ++p) {
    if (p > 0) factor *= static_cast<double>(p) / half;
    Eigen::MatrixXcd value(tones, channels.cols());
    MatrixXd sd(tones, channels.cols());
    for (Index j = 0; j < tones; ++j) {
      const Index real = 2 * (p * tones + j);
      const double spread = std::sqrt(0.5 * (variance(real) + variance(real + 1)));
      for (Index c = 0; c < channels.cols(); ++c) {
        value(j, c) = factor * std::complex<double>(coefficients(real, c), coefficients(real + 1, c));
        sd(j, c) = factor * spread * fit.noise_sd(c);
      }
    }
    fit.derivative.push_back(std::move(value));
    fit.sd.push_back(std::move(sd));
  }
  fit.offset = coefficients.row(constant).transpose();
  fit.offset_sd = std::sqrt(variance(constant)) * fit.noise_sd;
  return fit;
}

SlowToneWeights slow_tone_weights(Index samples, double rate, const std::vector<double>& frequencies, int degree,
                                  int offset_degree) {
  const MatrixXd basis = basis_of(samples, rate, frequencies, degree, offset_degree);
  const Eigen::HouseholderQR<MatrixXd> qr(basis);
  const MatrixXd directions = qr.householderQ() * MatrixXd::Identity(samples, basis.cols());
  const MatrixXd upper = qr.matrixQR().topRows(basis.cols());
  const MatrixXd inverse = upper.triangularView<Eigen::Upper>().solve(MatrixXd(directions.transpose()));
  const double half = 0.5 * static_cast<double>(samples - 1) / rate;
  const auto tones = static_cast<Index>(frequencies.size());
  SlowToneWeights weights;
  double factor = 1;
  for (Index p = 0; p <= degree; ++p) {
    if (p > 0) factor *= static_cast<double>(p) / half;
    Eigen::MatrixXcd of_power(tones, samples);
    for (Index j = 0; j < tones; ++j) {
      const Index real = 2 * (p * tones + j);
      of_power.row(j).real() = factor * inverse.row(real);
      of_power.row(j).imag() = factor * inverse.row(real + 1);
    }
    weights.derivative.push_back(std::move(of_power));
  }
  weights.offset = inverse.row(2 * tones * (degree + 1));
  return weights;
}

}  // namespace secular
