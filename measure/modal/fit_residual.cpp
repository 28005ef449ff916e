#include "measure/modal/fit_residual.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "measure/modal/motion_columns.hpp"
#include "measure/modal/record_scatter.hpp"
#include "numerics/distribution.hpp"
#include "numerics/orthonormal_span.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr int most_powers = 3;  // of time, in Eq. (M6)

// What amplitudes (Re, Im) of a pole's columns are times a residue.
Eigen::Matrix2d turned(Complex residue) {
  Eigen::Matrix2d turn;
  turn << residue.real(), -residue.imag(), residue.imag(), residue.real();
  return turn;
}

// Adds what one signal says of the columns, in which it moves as `turn` times them.
void add_signal(PoleInformation& sum, const MatrixXd& moments, const VectorXd& slopes, const MatrixXd& turn) {
  sum.hessian += turn.transpose() * moments * turn;
  sum.gradient += turn.transpose() * slopes;
}

}  // namespace

double ExplainedSquares::probability() const {
  return std::min(1.0, tests * chi_squared_upper_tail(gain, freedom));
}

FitResidual::FitResidual(const Eigen::Ref<const MatrixXd>& samples, double sample_rate_hz, const PoleFit& fit)
    : fit_(fit), rate_(sample_rate_hz) {
  const Index rows = samples.rows(), n = fit.poles.size();
  MatrixXd columns(rows, 2 * n + 1);
  for (Index r = 0; r < n; ++r)
    columns.middleCols(2 * r, 2) = motion_columns(exponential(rows, rate_, fit.poles(r)));
  columns.col(2 * n).setOnes();
  basis_ = orthonormal_span(columns);
  left_ = without_span(basis_, samples);
  const double floor = 1e-14 * samples.cwiseAbs().maxCoeff() + 1e-300;
  weight_ = fit.noise_sd.cwiseMax(floor).cwiseInverse();
}

// Those of the motion by a pole times powers of time, first one, then two, ...: rows x 2 each.
MatrixXd FitResidual::power_columns(Index pole, Index powers) const {
  const VectorXcd time = VectorXd::LinSpaced(left_.rows(), 0, 1).cast<Complex>();
  VectorXcd power = exponential(left_.rows(), rate_, fit_.poles(pole));
  MatrixXd columns(left_.rows(), 2 * powers);
  for (Index k = 0; k < powers; ++k) {
    power = power.cwiseProduct(time);
    columns.middleCols(2 * k, 2) = motion_columns(power);
  }
  return columns;
}

std::vector<ExplainedSquares> FitResidual::along_powers(Index pole) const {
  const MatrixXd columns = without_span(basis_, power_columns(pole, most_powers));
  std::vector<ExplainedSquares> found;
  for (int k = 1; k <= most_powers; ++k) {
    const MatrixXd span = orthonormal_span(columns.leftCols(2 * k));
    const double gain = (span.transpose() * left_ * weight_.asDiagonal()).squaredNorm();
    const auto freedom = static_cast<double>(span.cols() * left_.cols() - 2);  // the pole itself was fitted
    if (freedom > 0) found.push_back({gain, freedom, most_powers});
  }
  return found;
}

FitResidual::Noise FitResidual::noise() const {
  const Index rows = left_.rows(), n = fit_.poles.size();
  const Index powers = n > 0 ? std::min<Index>(most_powers, (rows / 4 - basis_.cols()) / (2 * n)) : 0;
  if (powers < 1) return {left_, basis_.cols()};
  MatrixXd columns(rows, 2 * n * powers);
  for (Index r = 0; r < n; ++r) columns.middleCols(2 * r * powers, 2 * powers) = power_columns(r, powers);
  const MatrixXd span = orthonormal_span(without_span(basis_, columns));
  return {left_ - span * (span.transpose() * left_), basis_.cols() + span.cols()};
}

// Those of the motion of residue one by its pole, each over the record's duration.
MatrixXd FitResidual::derivatives() const {
  const Index rows = left_.rows(), n = fit_.poles.size();
  MatrixXd columns(rows, 2 * n);
  const VectorXd time = VectorXd::LinSpaced(rows, 0, 1);
  for (Index r = 0; r < n; ++r)
    columns.middleCols(2 * r, 2) =
        motion_columns(exponential(rows, rate_, fit_.poles(r)).cwiseProduct(time.cast<Complex>()));
  return columns;
}

std::vector<PoleInformation> FitResidual::by_record(Index channels) const {
  const Index signals = left_.cols(), n = fit_.poles.size();
  if (channels < 1 || signals % channels != 0) throw std::invalid_argument("by_record: no whole records");
  const MatrixXd columns = without_span(basis_, derivatives());
  const double duration = static_cast<double>(left_.rows() - 1) / rate_;
  const MatrixXd moments = duration * duration * columns.transpose() * columns,
                 slopes = duration * columns.transpose() * left_;
  std::vector<PoleInformation> found(static_cast<std::size_t>(signals / channels),
                                     {MatrixXd::Zero(2 * n, 2 * n), VectorXd::Zero(2 * n)});
  for (Index s = 0; s < signals; ++s) {
    MatrixXd turn = MatrixXd::Zero(2 * n, 2 * n);
    for (Index r = 0; r < n; ++r) turn.block<2, 2>(2 * r, 2 * r) = turned(fit_.residues(r, s) * weight_(s));
    add_signal(found[static_cast<std::size_t>(s / channels)], moments, slopes.col(s) * weight_(s), turn);
  }
  return found;
}

ExplainedSquares FitResidual::along_laws(Index pole, const std::vector<double>& amplitudes, Index channels) const {
  const Index rows = left_.rows(), signals = left_.cols(), n = fit_.poles.size();
  if (signals != channels * static_cast<Index>(amplitudes.size()))
    throw std::invalid_argument("along_laws: channels and records do not make up the signals");
  constexpr int law_freedom = 4;
  MatrixXd columns(rows, 2 * n + law_freedom);
  columns.leftCols(2 * n) = derivatives();
  const VectorXd time = VectorXd::LinSpaced(rows, 0, static_cast<double>(rows - 1) / rate_);
  const double rate_of_decay = fit_.poles(pole).real(), largest_at = rate_of_decay > 0 ? time(rows - 1) : 0;
  VectorXcd motion = exponential(rows, rate_, fit_.poles(pole));
  for (int k = 1; k <= 2; ++k) {
    const double rate = k * rate_of_decay;
    VectorXcd turned_motion = motion;
    for (Index i = 0; i < rows; ++i) {
      const double t = time(i) - largest_at;
      turned_motion(i) *= (std::abs(rate * t) > 1e-9 ? std::expm1(rate * t) / rate : t) / time(rows - 1);
    }
    columns.middleCols(2 * (n + k - 1), 2) = motion_columns(turned_motion);
  }
  columns = without_span(basis_, columns);
  const MatrixXd moments = columns.transpose() * columns, slopes = columns.transpose() * left_;
  const double most = *std::max_element(amplitudes.begin(), amplitudes.end());
  if (!(most > 0)) return {0, law_freedom};
  PoleInformation sum{MatrixXd::Zero(columns.cols(), columns.cols()), VectorXd::Zero(columns.cols())};
  for (Index s = 0; s < signals; ++s) {
    const double share = amplitudes[static_cast<std::size_t>(s / channels)] / most;
    MatrixXd turn = MatrixXd::Zero(columns.cols(), columns.cols());
    for (Index r = 0; r < n; ++r) turn.block<2, 2>(2 * r, 2 * r) = turned(fit_.residues(r, s) * weight_(s));
    for (int k = 1; k <= 2; ++k)
      turn.block<2, 2>(2 * (n + k - 1), 2 * (n + k - 1)) =
          turned(fit_.residues(pole, s) * weight_(s) * std::pow(share, k));
    add_signal(sum, moments, slopes.col(s) * weight_(s), turn);
  }
  const double all = sum.gradient.dot(inverse_of_positive(sum.hessian) * sum.gradient);
  const MatrixXd poles_only = sum.hessian.topLeftCorner(2 * n, 2 * n);
  const VectorXd slope = sum.gradient.head(2 * n);
  return {std::max(0.0, all - slope.dot(inverse_of_positive(poles_only) * slope)), law_freedom};
}

}  // namespace secular
