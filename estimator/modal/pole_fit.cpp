#include "estimator/modal/pole_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr Complex imaginary(0, 1);

// Real columns that multiply (Re R, Im R) of one pole, and their derivatives by real and imaginary part of the
// pole.
struct PoleColumns {
  MatrixXd columns, by_real, by_imaginary;  // rows x 2
};

// A separable problem: data = [pole columns, fixed columns] * real coefficients.
struct Separable {
  MatrixXd data;   // rows x signals
  MatrixXd fixed;  // rows x terms that no pole changes
  std::function<PoleColumns(Complex)> columns;
};

MatrixXd design_of(const Separable& problem, const VectorXcd& poles) {
  MatrixXd design(problem.data.rows(), 2 * poles.size() + problem.fixed.cols());
  for (Index r = 0; r < poles.size(); ++r) design.middleCols(2 * r, 2) = problem.columns(poles(r)).columns;
  design.rightCols(problem.fixed.cols()) = problem.fixed;
  return design;
}

void check(const Separable& problem, const VectorXcd& poles) {
  const Index unknowns = 2 * poles.size() + problem.fixed.cols();
  if (poles.size() == 0 || problem.data.cols() == 0)
    throw std::invalid_argument("pole fit: no poles or no signals");
  if (problem.data.rows() <= unknowns + 1) throw std::invalid_argument("pole fit: fewer samples than unknowns");
  if (!problem.data.allFinite() || !poles.allFinite()) throw std::invalid_argument("pole fit: not finite");
  for (const Complex pole : poles)
    if (!(pole.imag() > 0)) throw std::invalid_argument("pole fit: a pole is not in the upper half plane");
}

PoleFit residues_of(const Separable& problem, const VectorXcd& poles) {
  check(problem, poles);
  MatrixXd design = design_of(problem, poles);
  const VectorXd scale = design.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  design = design * scale.asDiagonal();
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(design);
  const MatrixXd coefficients = qr.solve(problem.data);
  const MatrixXd left = problem.data - design * coefficients;
  PoleFit fit;
  fit.status = FitStatus::converged;
  fit.poles = poles;
  fit.growth_sd = VectorXd::Zero(poles.size());
  fit.omega_sd = VectorXd::Zero(poles.size());
  fit.residues.resize(poles.size(), problem.data.cols());
  for (Index r = 0; r < poles.size(); ++r)
    for (Index s = 0; s < problem.data.cols(); ++s)
      fit.residues(r, s) = {coefficients(2 * r, s) * scale(2 * r), coefficients(2 * r + 1, s) * scale(2 * r + 1)};
  const auto freedom = static_cast<double>(problem.data.rows() - design.cols());
  fit.noise_sd = (left.colwise().squaredNorm() / freedom).cwiseSqrt().transpose();
  return fit;
}

FitReport refine_once(const Separable& problem, const VectorXd& weight, const VectorXcd& start) {
  const Index n = start.size(), rows = problem.data.rows(), signals = problem.data.cols();
  const MatrixXd data = problem.data * weight.asDiagonal();
  // In units of each pole's modulus, so that steps compare.
  const VectorXd unit = start.cwiseAbs();
  const auto poles_at = [&](const VectorXd& x) {
    VectorXcd poles(n);
    for (Index r = 0; r < n; ++r) poles(r) = start(r) + unit(r) * Complex(x(2 * r), x(2 * r + 1));
    return poles;
  };
  const ResidualFunction function = [&](const VectorXd& x, VectorXd& residual, MatrixXd& jacobian) {
    const VectorXcd poles = poles_at(x);
    MatrixXd design = design_of(problem, poles);
    const VectorXd scale = design.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
    design = design * scale.asDiagonal();
    const Eigen::HouseholderQR<MatrixXd> qr(design);
    const MatrixXd orthogonal = qr.householderQ() * MatrixXd::Identity(rows, design.cols());
    const MatrixXd coefficients = scale.asDiagonal() * qr.solve(data);
    const MatrixXd left = data - orthogonal * (orthogonal.transpose() * data);
    residual = Eigen::Map<const VectorXd>(left.data(), left.size());
    for (Index r = 0; r < n; ++r) {
      const PoleColumns derived = problem.columns(poles(r));
      const MatrixXd pair = coefficients.middleRows(2 * r, 2);
      MatrixXd by_real = derived.by_real * pair, by_imaginary = derived.by_imaginary * pair;
      by_real -= orthogonal * (orthogonal.transpose() * by_real);  // Kaufman's part of the Jacobian
      by_imaginary -= orthogonal * (orthogonal.transpose() * by_imaginary);
      jacobian.col(2 * r) = -unit(r) * Eigen::Map<const VectorXd>(by_real.data(), by_real.size());
      jacobian.col(2 * r + 1) = -unit(r) * Eigen::Map<const VectorXd>(by_imaginary.data(), by_imaginary.size());
    }
    for (const Complex pole : poles)
      if (!(pole.imag() > 0) || std::abs(pole.real()) > pole.imag())
        residual.setConstant(std::nan(""));  // a step too far, turned back
  };
  FitReport report = nonlinear_fit(function, rows * signals, VectorXd::Zero(2 * n), 60);
  for (Index r = 0; r < n; ++r) {
    report.parameters.segment(2 * r, 2) *= unit(r);
    report.covariance.middleRows(2 * r, 2) *= unit(r);
    report.covariance.middleCols(2 * r, 2) *= unit(r);
  }
  return report;
}

PoleFit refined(const Separable& problem, const VectorXcd& start) {
  PoleFit fit = residues_of(problem, start);
  const double floor = 1e-14 * problem.data.cwiseAbs().maxCoeff() + 1e-300;
  for (int pass = 0; pass < 2; ++pass) {
    const VectorXd weight = fit.noise_sd.cwiseMax(floor).cwiseInverse();
    const FitReport report = refine_once(problem, weight, fit.poles);
    VectorXcd poles = fit.poles;
    for (Index r = 0; r < poles.size(); ++r)
      poles(r) += Complex(report.parameters(2 * r), report.parameters(2 * r + 1));
    fit = residues_of(problem, poles);
    fit.status = report.status;
    const Index points = problem.data.size();
    const Index unknowns = 2 * poles.size() + (2 * poles.size() + problem.fixed.cols()) * problem.data.cols();
    const double variance = 2 * report.cost / static_cast<double>(std::max<Index>(1, points - unknowns));
    for (Index r = 0; r < poles.size(); ++r) {
      fit.growth_sd(r) = std::sqrt(variance * report.covariance(2 * r, 2 * r));
      fit.omega_sd(r) = std::sqrt(variance * report.covariance(2 * r + 1, 2 * r + 1));
    }
  }
  return fit;
}

Separable in_time(const Eigen::Ref<const MatrixXd>& samples, double rate) {
  if (!(rate > 0)) throw std::invalid_argument("pole fit: the sample rate is not positive");
  const VectorXd time = VectorXd::LinSpaced(samples.rows(), 0, static_cast<double>(samples.rows() - 1)) / rate;
  // 2 Re(R e) = Re R * 2 Re e - Im R * 2 Im e
  return {samples, MatrixXd::Ones(samples.rows(), 1), [time](Complex pole) {
            const VectorXcd e = (time.cast<Complex>() * pole).array().exp();
            const VectorXcd te = time.cast<Complex>().cwiseProduct(e);
            PoleColumns c{MatrixXd(time.size(), 2), MatrixXd(time.size(), 2), MatrixXd(time.size(), 2)};
            c.columns << 2 * e.real(), -2 * e.imag();
            c.by_real << 2 * te.real(), -2 * te.imag();
            c.by_imaginary << -2 * te.imag(), -2 * te.real();  // of i t e
            return c;
          }};
}

MatrixXd stacked(const MatrixXcd& values) {
  MatrixXd rows(2 * values.rows(), values.cols());
  rows << values.real(), values.imag();
  return rows;
}

MatrixXcd outside_terms(const Eigen::Ref<const VectorXd>& omega, ResponseForm form) {
  MatrixXcd terms(omega.size(), 3);
  const double unit = omega.cwiseAbs().maxCoeff();  // powers of w/unit: columns of like size
  for (Index i = 0; i < omega.size(); ++i)
    for (int j = 0; j < 3; ++j) terms(i, j) = std::pow(imaginary * omega(i) / unit, j + static_cast<int>(form) - 2);
  return terms;
}

Separable in_frequency(const Eigen::Ref<const VectorXd>& omega, const Eigen::Ref<const MatrixXcd>& responses,
                       ResponseForm form) {
  if (omega.size() != responses.rows()) throw std::invalid_argument("pole fit: lines and responses differ");
  if (omega.size() > 0 && !(omega.minCoeff() > 0))
    throw std::invalid_argument("pole fit: the frequencies are not positive");
  const VectorXcd s = imaginary * omega.cast<Complex>();
  return {stacked(responses), stacked(outside_terms(omega, form)), [s](Complex pole) {
            const VectorXcd up = (s.array() - pole).inverse(), down = (s.array() - std::conj(pole)).inverse();
            const VectorXcd du = up.cwiseProduct(up), dd = down.cwiseProduct(down);
            MatrixXcd c(s.size(), 2), r(s.size(), 2), i(s.size(), 2);
            c << up + down, imaginary * (up - down);
            r << du + dd, imaginary * (du - dd);
            i << imaginary * (du - dd), -(du + dd);
            return PoleColumns{stacked(c), stacked(r), stacked(i)};
          }};
}

}  // namespace

PoleFit fit_residues(const Eigen::Ref<const MatrixXd>& samples, double sample_rate_hz,
                     const Eigen::Ref<const VectorXcd>& poles) {
  return residues_of(in_time(samples, sample_rate_hz), poles);
}

PoleFit refine_poles(const Eigen::Ref<const MatrixXd>& samples, double sample_rate_hz,
                     const Eigen::Ref<const VectorXcd>& start) {
  return refined(in_time(samples, sample_rate_hz), start);
}

PoleFit fit_residues(const Eigen::Ref<const VectorXd>& omega, const Eigen::Ref<const MatrixXcd>& responses,
                     ResponseForm form, const Eigen::Ref<const VectorXcd>& poles) {
  return residues_of(in_frequency(omega, responses, form), poles);
}

PoleFit refine_poles(const Eigen::Ref<const VectorXd>& omega, const Eigen::Ref<const MatrixXcd>& responses,
                     ResponseForm form, const Eigen::Ref<const VectorXcd>& start) {
  return refined(in_frequency(omega, responses, form), start);
}

MatrixXcd synthesise(const PoleFit& fit, const Eigen::Ref<const VectorXd>& omega,
                     const Eigen::Ref<const MatrixXcd>& responses, ResponseForm form) {
  const Separable problem = in_frequency(omega, responses, form);
  const MatrixXd design = design_of(problem, fit.poles);
  const VectorXd scale = design.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  const MatrixXd scaled = design * scale.asDiagonal();
  const MatrixXd values = scaled * scaled.colPivHouseholderQr().solve(problem.data);
  MatrixXcd result(omega.size(), responses.cols());
  result.real() = values.topRows(omega.size());
  result.imag() = values.bottomRows(omega.size());
  return result;
}

}  // namespace secular
