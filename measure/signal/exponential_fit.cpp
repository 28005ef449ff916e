#include "measure/signal/exponential_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "measure/signal/symmetric_polynomial.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// Rows of the Hankel matrix of Eq. (4.14), all channels below each other.
MatrixXd hankel_rows(const Eigen::Ref<const MatrixXd>& channels, Index columns) {
  const Index rows = channels.rows() - columns + 1;
  MatrixXd hankel(rows * channels.cols(), columns);
  for (Index c = 0; c < channels.cols(); ++c)
    for (Index k = 0; k < columns; ++k) hankel.col(k).segment(c * rows, rows) = channels.col(c).segment(k, rows);
  return hankel;
}

VectorXcd roots_of_monic(const VectorXd& ascending) {
  const Index n = ascending.size();
  MatrixXd companion = MatrixXd::Zero(n, n);
  companion.diagonal(-1).setOnes();
  companion.col(n - 1) = -ascending;
  return companion.eigenvalues();
}

MatrixXcd powers(const VectorXcd& z, Index samples) {
  MatrixXcd table(samples, z.size());
  const Eigen::ArrayXcd exponent = z.array().log();
  for (Index l = 0; l < samples; ++l) table.row(l) = (static_cast<double>(l) * exponent).exp().matrix().transpose();
  return table;
}

ExponentialFit from_polynomial(const VectorXd& ascending, const Eigen::Ref<const MatrixXd>& channels, double rate,
                               Index used) {
  const VectorXcd z = roots_of_monic(ascending);
  ExponentialFit fit;
  fit.poles = z.array().log() * rate;
  MatrixXcd table = powers(z, used);
  const VectorXd scale = table.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  table = table * scale.cast<Complex>().asDiagonal();
  const MatrixXcd right = channels.topRows(used).cast<Complex>();
  fit.residues = scale.cast<Complex>().asDiagonal() * table.colPivHouseholderQr().solve(right);
  return fit;
}

}  // namespace

MatrixXd ExponentialFit::reconstruct(Index samples, double sample_rate_hz) const {
  const VectorXcd z = (poles / sample_rate_hz).array().exp();
  return (powers(z, samples) * residues).real();
}

ExponentialFit prony(const Eigen::Ref<const VectorXd>& samples, double sample_rate_hz, int pairs) {
  if (pairs < 1 || samples.size() != 4 * pairs)
    throw std::invalid_argument("Prony's method takes exactly four samples for every pair of exponentials");
  const Index order = 2 * pairs;
  const MatrixXd hankel = hankel_rows(samples, order + 1);
  const VectorXd polynomial = -hankel.leftCols(order).fullPivLu().solve(hankel.col(order));
  return from_polynomial(polynomial, samples, sample_rate_hz, order);
}

ExponentialFit complex_exponential(const Eigen::Ref<const MatrixXd>& channels, double sample_rate_hz, int pairs) {
  if (pairs < 1 || channels.rows() < 4 * pairs)
    throw std::invalid_argument("the complex exponential algorithm needs four samples for every pair");
  const Index order = 2 * pairs;
  const MatrixXd hankel = hankel_rows(channels, order + 1);
  const VectorXd polynomial = -hankel.leftCols(order).colPivHouseholderQr().solve(hankel.col(order));
  return from_polynomial(polynomial, channels, sample_rate_hz, channels.rows());
}

PisarenkoFit pisarenko(const Eigen::Ref<const VectorXd>& samples, double sample_rate_hz, int tones) {
  const Index lags = 2 * static_cast<Index>(tones) + 1, n = samples.size();
  if (tones < 1 || n < 2 * lags) throw std::invalid_argument("too few samples for Pisarenko's decomposition");
  // Unbiased autocorrelations: the biased ones of a tone are those of a tone that fades.
  VectorXd correlation(lags);
  for (Index k = 0; k < lags; ++k)
    correlation(k) = samples.head(n - k).dot(samples.tail(n - k)) / static_cast<double>(n - k);
  MatrixXd toeplitz(lags, lags);
  for (Index i = 0; i < lags; ++i)
    for (Index k = 0; k < lags; ++k) toeplitz(i, k) = correlation(std::abs(i - k));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(toeplitz);
  const VectorXd polynomial = spectrum.eigenvectors().col(0);
  // The eigenvector of a Toeplitz matrix is symmetric: its roots in z + 1/z lie in [-2, 2].
  VectorXd symmetric(tones + 1);
  for (Index j = 0; j <= tones; ++j) symmetric(j) = 0.5 * (polynomial(tones + j) + polynomial(tones - j));
  PisarenkoFit fit;
  fit.noise_variance = spectrum.eigenvalues()(0);
  std::vector<double> frequencies;
  for (const Pole& pole : poles_of(symmetric))
    frequencies.push_back((pole.family == PoleFamily::nyquist_hyperbolic ? std::numbers::pi : pole.frequency) *
                          sample_rate_hz);
  std::sort(frequencies.begin(), frequencies.end());
  fit.frequencies = Eigen::Map<const VectorXd>(frequencies.data(), static_cast<Index>(frequencies.size()));
  return fit;
}

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
