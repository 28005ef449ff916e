#include "estimator/signal/circular_hyperbolic.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// alpha_n ... alpha_2n of Eq. (4.28), scaled to alpha_2n = 1.
VectorXd symmetric_polynomial(const Eigen::Ref<const VectorXd>& y, Index n) {
  const Index rows = y.size() - 2 * n;
  MatrixXd columns(rows, n + 1);
  columns.col(0) = y.segment(n, rows);
  for (Index j = 1; j <= n; ++j) columns.col(j) = y.segment(n - j, rows) + y.segment(n + j, rows);
  VectorXd alpha(n + 1);
  alpha.head(n) = -columns.leftCols(n).colPivHouseholderQr().solve(columns.col(n));
  alpha(n) = 1;
  return alpha;
}

// Roots in w = z + 1/z of alpha_n + sum_j alpha_{n+j} (z^j + z^-j), with z^j + z^-j = C_j(w):
// C_0 = 2, C_1 = w, C_{j+1} = w C_j - C_{j-1}.
Eigen::VectorXcd pole_sums(const VectorXd& alpha) {
  const Index n = alpha.size() - 1;
  MatrixXd basis = MatrixXd::Zero(n + 1, n + 1);  // row j: coefficients of C_j, ascending
  basis(0, 0) = 2;
  basis(1, 1) = 1;
  for (Index j = 1; j < n; ++j) {
    basis.row(j + 1).tail(n) = basis.row(j).head(n);
    basis.row(j + 1) -= basis.row(j - 1);
  }
  VectorXd coefficients = basis.bottomRows(n).transpose() * alpha.tail(n);
  coefficients(0) += alpha(0);
  MatrixXd companion = MatrixXd::Zero(n, n);
  companion.col(n - 1) = -coefficients.head(n) / coefficients(n);
  companion.diagonal(-1).setOnes();
  return companion.eigenvalues();
}

// The columns of every family at times t_l = l / rate, in the order of the fit's lists.
MatrixXd basis_of(const CircularHyperbolicFit& fit, Index samples) {
  const auto circular = static_cast<Index>(fit.circular.size()),
             hyperbolic = static_cast<Index>(fit.hyperbolic.size()),
             nyquist = static_cast<Index>(fit.nyquist.size()), products = static_cast<Index>(fit.products.size());
  MatrixXd basis(samples, 2 * (circular + hyperbolic + nyquist) + 4 * products);
  const VectorXd t = VectorXd::LinSpaced(samples, 0, static_cast<double>(samples - 1)) / fit.sample_rate_hz;
  VectorXd alternating(samples);
  for (Index l = 0; l < samples; ++l) alternating(l) = l % 2 == 0 ? 1 : -1;
  Index column = 0;
  for (const CircularTerm& term : fit.circular) {
    basis.col(column++) = (term.frequency * t).array().cos();
    basis.col(column++) = (term.frequency * t).array().sin();
  }
  for (const HyperbolicTerm& term : fit.hyperbolic) {
    basis.col(column++) = (term.rate * t).array().cosh();
    basis.col(column++) = (term.rate * t).array().sinh();
  }
  for (const NyquistHyperbolicTerm& term : fit.nyquist) {
    basis.col(column++) = alternating.array() * (term.rate * t).array().cosh();
    basis.col(column++) = alternating.array() * (term.rate * t).array().sinh();
  }
  for (const ProductTerm& term : fit.products) {
    const Eigen::ArrayXd cosine = (term.frequency * t).array().cos(), sine = (term.frequency * t).array().sin();
    const Eigen::ArrayXd even = (term.rate * t).array().cosh(), odd = (term.rate * t).array().sinh();
    basis.col(column++) = cosine * even;
    basis.col(column++) = sine * even;
    basis.col(column++) = cosine * odd;
    basis.col(column++) = sine * odd;
  }
  return basis;
}

void set_amplitudes(CircularHyperbolicFit& fit, const VectorXd& values) {
  Index i = 0;
  for (CircularTerm& term : fit.circular) {
    term.p = values(i++);
    term.q = values(i++);
  }
  for (HyperbolicTerm& term : fit.hyperbolic) {
    term.a = values(i++);
    term.b = values(i++);
  }
  for (NyquistHyperbolicTerm& term : fit.nyquist) {
    term.c = values(i++);
    term.d = values(i++);
  }
  for (ProductTerm& term : fit.products) {
    term.e = values(i++);
    term.f = values(i++);
    term.g = values(i++);
    term.h = values(i++);
  }
}

VectorXd amplitudes_of(const CircularHyperbolicFit& fit) {
  std::vector<double> values;
  for (const CircularTerm& term : fit.circular) values.insert(values.end(), {term.p, term.q});
  for (const HyperbolicTerm& term : fit.hyperbolic) values.insert(values.end(), {term.a, term.b});
  for (const NyquistHyperbolicTerm& term : fit.nyquist) values.insert(values.end(), {term.c, term.d});
  for (const ProductTerm& term : fit.products) values.insert(values.end(), {term.e, term.f, term.g, term.h});
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

}  // namespace

VectorXd CircularHyperbolicFit::reconstruct(Index samples) const {
  return basis_of(*this, samples) * amplitudes_of(*this);
}

CircularHyperbolicFit circular_hyperbolic_decomposition(const Eigen::Ref<const VectorXd>& samples,
                                                        double sample_rate_hz, int order) {
  if (order < 1 || samples.size() < 3 * order)
    throw std::invalid_argument("circular-hyperbolic decomposition needs at least 3 samples for every order");
  if (!samples.allFinite())
    throw std::invalid_argument("circular-hyperbolic decomposition of samples that are not finite");
  CircularHyperbolicFit fit;
  fit.sample_rate_hz = sample_rate_hz;
  const Eigen::VectorXcd sums = pole_sums(symmetric_polynomial(samples, order));
  for (const std::complex<double>& w : sums) {
    // Eigenvalues of a real matrix: a real root has an imaginary part that is exactly zero.
    if (w.imag() == 0) {
      if (std::abs(w.real()) <= 2)
        fit.circular.push_back({std::acos(w.real() / 2) * sample_rate_hz, 0, 0});
      else if (w.real() > 2)
        fit.hyperbolic.push_back({std::acosh(w.real() / 2) * sample_rate_hz, 0, 0});
      else
        fit.nyquist.push_back({std::acosh(-w.real() / 2) * sample_rate_hz, 0, 0});
    } else if (w.imag() > 0) {
      std::complex<double> z = 0.5 * (w + std::sqrt(w * w - 4.0));
      if (std::abs(z) < 1) z = 1.0 / z;
      const std::complex<double> pole = std::log(z) * sample_rate_hz;
      fit.products.push_back({pole.real(), std::abs(pole.imag()), 0, 0, 0, 0});
    }
  }
  MatrixXd basis = basis_of(fit, samples.size());
  const Eigen::RowVectorXd scale =
      basis.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).cwiseInverse();
  const MatrixXd scaled = basis * scale.asDiagonal();
  const VectorXd amplitudes = scale.asDiagonal() * scaled.colPivHouseholderQr().solve(samples);
  set_amplitudes(fit, amplitudes);
  const VectorXd model = basis * amplitudes;
  const double left = (samples - model).squaredNorm(), power = model.squaredNorm();
  const double product = samples.dot(model), both = samples.squaredNorm() * power;
  fit.correlation = both > 0 ? product * product / both : 0;
  fit.signal_to_noise_db = left > 0 ? 10 * std::log10(power / left) : std::numeric_limits<double>::infinity();
  return fit;
}

}  // namespace secular
