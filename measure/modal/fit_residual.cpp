#include "measure/modal/fit_residual.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// exp(pole t) at every row.
VectorXcd exponential(Index rows, double rate, Complex pole) {
  VectorXcd e(rows);
  for (Index i = 0; i < rows; ++i) e(i) = std::exp(pole * (static_cast<double>(i) / rate));
  return e;
}

// Real columns of (Re R, Im R) in 2 Re(R motion).
MatrixXd real_columns(const VectorXcd& motion) {
  MatrixXd columns(motion.size(), 2);
  columns << 2 * motion.real(), -2 * motion.imag();
  return columns;
}

// Orthonormal columns that span the given ones; those that depend on others to rounding are left out.
MatrixXd orthonormal_span(MatrixXd columns) {
  for (Index c = 0; c < columns.cols(); ++c) {
    const double norm = columns.col(c).norm();
    if (norm > 0) columns.col(c) /= norm;
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  qr.setThreshold(1e-9);
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), qr.rank());
}

// (Re, Im) of `factor` times a residue's columns, as amplitudes of these columns.
Eigen::Matrix2d turned(Complex residue) {
  Eigen::Matrix2d turn;
  turn << residue.real(), -residue.imag(), residue.imag(), residue.real();
  return turn;
}

MatrixXd inverse_of_positive(const MatrixXd& matrix) {
  const VectorXd shorten = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(
      MatrixXd(shorten.asDiagonal() * matrix * shorten.asDiagonal()));
  VectorXd values = spectrum.eigenvalues();
  const double least = 1e-10 * values.maxCoeff();
  for (double& v : values) v = v > least ? 1 / v : 0;
  return shorten.asDiagonal() *
         MatrixXd(spectrum.eigenvectors() * values.asDiagonal() * spectrum.eigenvectors().transpose()) *
         shorten.asDiagonal();
}

}  // namespace

FitResidual::FitResidual(const Eigen::Ref<const MatrixXd>& samples, double sample_rate_hz, const PoleFit& fit)
    : fit_(fit), rate_(sample_rate_hz) {
  const Index rows = samples.rows(), n = fit.poles.size();
  MatrixXd columns(rows, 2 * n + 1);
  for (Index r = 0; r < n; ++r) columns.middleCols(2 * r, 2) = real_columns(exponential(rows, rate_, fit.poles(r)));
  columns.col(2 * n).setOnes();
  basis_ = orthonormal_span(columns);
  left_ = samples - basis_ * (basis_.transpose() * samples);
  const double floor = 1e-14 * samples.cwiseAbs().maxCoeff() + 1e-300;
  weight_ = fit.noise_sd.cwiseMax(floor).cwiseInverse();
}

MatrixXd FitResidual::projected(const MatrixXd& columns) const {
  return columns - basis_ * (basis_.transpose() * columns);
}

double FitResidual::probability_of_one_exponential(Index pole) const {
  const Index rows = left_.rows(), signals = left_.cols();
  const VectorXcd motion = exponential(rows, rate_, fit_.poles(pole));
  const VectorXd time = VectorXd::LinSpaced(rows, 0, 1);
  constexpr int powers = 3;
  MatrixXd columns(rows, 2 * powers);
  VectorXcd power = motion;
  double least = 1;
  for (int k = 1; k <= powers; ++k) {
    power = power.cwiseProduct(time.cast<Complex>());
    columns.middleCols(2 * (k - 1), 2) = real_columns(power);
    const MatrixXd span = orthonormal_span(projected(columns.leftCols(2 * k)));
    const double gain = (span.transpose() * left_ * weight_.asDiagonal()).squaredNorm();
    const auto freedom = static_cast<double>(span.cols() * signals - 2);  // the pole itself was fitted
    if (freedom > 0) least = std::min(least, powers * chi_squared_upper_tail(gain, freedom));
  }
  return least;
}

double FitResidual::law_gain(Index pole, const std::vector<double>& amplitudes, Index channels) const {
  const Index rows = left_.rows(), signals = left_.cols(), n = fit_.poles.size();
  if (signals != channels * static_cast<Index>(amplitudes.size()))
    throw std::invalid_argument("law_gain: channels and records do not make up the signals");
  MatrixXd columns(rows, 2 * n + law_freedom);
  const VectorXd time = VectorXd::LinSpaced(rows, 0, static_cast<double>(rows - 1) / rate_);
  for (Index r = 0; r < n; ++r)
    columns.middleCols(2 * r, 2) =
        real_columns(exponential(rows, rate_, fit_.poles(r)).cwiseProduct(time.cast<Complex>()) / time(rows - 1));
  const double rate_of_decay = fit_.poles(pole).real(), largest_at = rate_of_decay > 0 ? time(rows - 1) : 0;
  VectorXcd motion = exponential(rows, rate_, fit_.poles(pole));
  for (int k = 1; k <= 2; ++k) {
    const double rate = k * rate_of_decay;
    VectorXcd turned_motion = motion;
    for (Index i = 0; i < rows; ++i) {
      const double t = time(i) - largest_at;
      turned_motion(i) *= (std::abs(rate * t) > 1e-9 ? std::expm1(rate * t) / rate : t) / time(rows - 1);
    }
    columns.middleCols(2 * (n + k - 1), 2) = real_columns(turned_motion);
  }
  columns = projected(columns);
  const MatrixXd moments = columns.transpose() * columns, slopes = columns.transpose() * left_;
  const double most = *std::max_element(amplitudes.begin(), amplitudes.end());
  if (!(most > 0)) return 0;
  MatrixXd hessian = MatrixXd::Zero(columns.cols(), columns.cols());
  VectorXd gradient = VectorXd::Zero(columns.cols());
  for (Index s = 0; s < signals; ++s) {
    const double share = amplitudes[static_cast<std::size_t>(s / channels)] / most;
    MatrixXd turn = MatrixXd::Zero(columns.cols(), columns.cols());
    for (Index r = 0; r < n; ++r) turn.block<2, 2>(2 * r, 2 * r) = turned(fit_.residues(r, s) * weight_(s));
    for (int k = 1; k <= 2; ++k)
      turn.block<2, 2>(2 * (n + k - 1), 2 * (n + k - 1)) =
          turned(fit_.residues(pole, s) * weight_(s) * std::pow(share, k));
    hessian += turn.transpose() * moments * turn;
    gradient += turn.transpose() * slopes.col(s) * weight_(s);
  }
  const double all = gradient.dot(inverse_of_positive(hessian) * gradient);
  const MatrixXd poles_only = hessian.topLeftCorner(2 * n, 2 * n);
  const VectorXd slope = gradient.head(2 * n);
  return std::max(0.0, all - slope.dot(inverse_of_positive(poles_only) * slope));
}

}  // namespace secular
