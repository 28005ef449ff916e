#include "measure/modal/pole_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "measure/modal/short_problem.hpp"
#include "numerics/nonlinear_fit.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr Complex imaginary(0, 1);

// Real columns that multiply (Re R, Im R) of one pole, and their derivatives by the pole's real part. Those by its
// imaginary part are the same two columns turned, (d2, -d1): the functions are analytic in the pole.
struct PoleColumns {
  MatrixXd columns, derivatives;  // rows x 2
};

// A separable problem: data = [pole columns, fixed columns] * real coefficients.
struct Separable {
  MatrixXd data;   // rows x signals
  MatrixXd fixed;  // rows x terms that no pole changes
  std::function<PoleColumns(Complex)> columns;
  double duration = 0;  // s, of samples in time
  double highest = 0;   // rad/s, of imaginary parts of poles
};

// Whether columns of the pole are finite, and those of no other pole.
bool within(const Separable& problem, Complex pole) {
  return pole.imag() > 0 && pole.imag() <= problem.highest && representable(pole, problem.duration);
}

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
  for (const Complex pole : poles)
    if (!(pole.imag() <= problem.highest))
      throw std::invalid_argument("pole fit: a pole is above half the sample rate");
  for (const Complex pole : poles)
    if (!representable(pole, problem.duration))
      throw std::invalid_argument("pole fit: a pole grows out of all numbers");
}

// Columns of unit length as orthonormal columns q times a triangle r.
struct Orthonormal {
  MatrixXd q, r;
};

// Cholesky's factor of the moments, twice (Y. Yamamoto, Y. Nakatsukasa, Y. Yanagisawa, T. Fukaya, Electron. Trans.
// Numer. Anal. 44, 2015, 306): as orthogonal as Householder's reflections as long as the columns are independent to
// the square root of rounding, and in products of matrices alone. Nothing for columns that are not.
std::optional<Orthonormal> by_cholesky(const MatrixXd& columns) {
  constexpr double independent = 1e-6;
  Orthonormal result{columns, MatrixXd::Identity(columns.cols(), columns.cols())};
  for (int pass = 0; pass < 2; ++pass) {
    MatrixXd moments = MatrixXd::Zero(columns.cols(), columns.cols());
    moments.selfadjointView<Eigen::Lower>().rankUpdate(result.q.transpose());
    const Eigen::LLT<MatrixXd> factor(moments);
    if (factor.info() != Eigen::Success || !(factor.matrixLLT().diagonal().minCoeff() > independent))
      return std::nullopt;
    factor.matrixU().solveInPlace<Eigen::OnTheRight>(result.q);
    result.r = factor.matrixU() * result.r;
  }
  return result;
}

Orthonormal orthonormal(const MatrixXd& columns) {
  if (std::optional<Orthonormal> found = by_cholesky(columns)) return std::move(*found);
  const Eigen::HouseholderQR<MatrixXd> qr(columns);
  return {qr.householderQ() * MatrixXd::Identity(columns.rows(), columns.cols()),
          qr.matrixQR().topRows(columns.cols()).triangularView<Eigen::Upper>()};
}

// Least squares; of columns that depend on each other some are left out.
MatrixXd solved(const MatrixXd& columns, const MatrixXd& data) {
  if (const std::optional<Orthonormal> basis = by_cholesky(columns))
    return basis->r.triangularView<Eigen::Upper>().solve(MatrixXd(basis->q.transpose() * data));
  return columns.colPivHouseholderQr().solve(data);
}

PoleFit residues_of(const Separable& problem, const VectorXcd& poles) {
  check(problem, poles);
  MatrixXd design = design_of(problem, poles);
  const VectorXd scale = design.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
  design = design * scale.asDiagonal();
  const MatrixXd coefficients = solved(design, problem.data);
  const MatrixXd left = problem.data - design * coefficients;
  PoleFit fit;
  fit.ending = SolverEnding::converged;
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

// Derivatives of the weighted residuals of signal s by the poles are the projected derivatives times this: unknowns
// (real and imaginary part of each pole in its `unit`) to amplitudes of the derivatives. `coefficients` are those
// of the weighted data, (Re R, Im R) of each pole.
MatrixXd turn_of(const Eigen::Ref<const VectorXd>& coefficients, const VectorXd& unit) {
  const Index n = unit.size();
  MatrixXd turn = MatrixXd::Zero(2 * n, 2 * n);
  for (Index r = 0; r < n; ++r) {
    const double p = -unit(r) * coefficients(2 * r), q = -unit(r) * coefficients(2 * r + 1);
    turn.block<2, 2>(2 * r, 2 * r) << p, -q, q, p;
  }
  return turn;
}

// Variable projection with Kaufman's Jacobian J. Its rows (samples x signals) are never formed: all of them are
// combinations of the projected derivatives, whose moments give J^T J = H and J^T r = g. The fit sees the shorter
// problem of the same H, g and |r|.
FitReport refine_once(const Separable& problem, const VectorXd& weight, const VectorXcd& start) {
  const Index n = start.size(), rows = problem.data.rows(), signals = problem.data.cols();
  const MatrixXd data = problem.data * weight.asDiagonal();
  // In units of each pole's modulus, so that steps compare.
  const VectorXd unit = start.cwiseAbs();
  const ResidualFunction function = [&](const VectorXd& x, VectorXd& residual, MatrixXd& jacobian) {
    MatrixXd design(rows, 2 * n + problem.fixed.cols()), derivatives(rows, 2 * n);
    design.rightCols(problem.fixed.cols()) = problem.fixed;
    for (Index r = 0; r < n; ++r) {
      const Complex pole = start(r) + unit(r) * Complex(x(2 * r), x(2 * r + 1));
      if (!within(problem, pole)) {
        residual.setConstant(std::nan(""));  // a step too far, turned back
        jacobian.setZero();
        return;
      }
      const PoleColumns columns = problem.columns(pole);
      design.middleCols(2 * r, 2) = columns.columns;
      derivatives.middleCols(2 * r, 2) = columns.derivatives;
    }
    const VectorXd scale = design.colwise().norm().cwiseMax(1e-300).cwiseInverse().transpose();
    design = design * scale.asDiagonal();
    const Orthonormal basis = orthonormal(design);
    const MatrixXd shadow = basis.q.transpose() * data;
    const MatrixXd coefficients =
        scale.asDiagonal() * MatrixXd(basis.r.triangularView<Eigen::Upper>().solve(shadow));
    const MatrixXd left = data - basis.q * shadow;
    derivatives -= basis.q * (basis.q.transpose() * derivatives);
    MatrixXd moments = MatrixXd::Zero(2 * n, 2 * n);
    moments.selfadjointView<Eigen::Lower>().rankUpdate(derivatives.transpose());
    moments.triangularView<Eigen::StrictlyUpper>() = moments.transpose();
    const MatrixXd slopes = derivatives.transpose() * left;
    MatrixXd hessian = MatrixXd::Zero(2 * n, 2 * n);
    VectorXd gradient = VectorXd::Zero(2 * n);
    for (Index s = 0; s < signals; ++s) {
      const MatrixXd turn = turn_of(coefficients.col(s), unit);
      hessian += turn.transpose() * (moments * turn);
      gradient += turn.transpose() * slopes.col(s);
    }
    fill_short_problem(hessian, gradient, left.squaredNorm(), residual, jacobian);
  };
  FitReport report = nonlinear_fit(function, 2 * n + 1, VectorXd::Zero(2 * n), 60);
  for (Index r = 0; r < n; ++r) {
    report.parameters.segment(2 * r, 2) *= unit(r);
    report.covariance.middleRows(2 * r, 2) *= unit(r);
    report.covariance.middleCols(2 * r, 2) *= unit(r);
  }
  return report;
}

// Noise below is rounding.
double noise_floor(const Separable& problem) {
  return 1e-14 * problem.data.cwiseAbs().maxCoeff() + 1e-300;
}

PoleFit refined(const Separable& problem, const VectorXcd& start) {
  PoleFit fit = residues_of(problem, start);
  const double floor = noise_floor(problem);
  for (int pass = 0; pass < 2; ++pass) {
    const VectorXd weight = fit.noise_sd.cwiseMax(floor).cwiseInverse();
    const FitReport report = refine_once(problem, weight, fit.poles);
    VectorXcd poles = fit.poles;
    for (Index r = 0; r < poles.size(); ++r)
      poles(r) += Complex(report.parameters(2 * r), report.parameters(2 * r + 1));
    fit = residues_of(problem, poles);
    fit.ending = report.ending;
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
  // 2 Re(R e) = Re R * 2 Re e - Im R * 2 Im e with e = exp(pole t): exact at every 32nd sample and for the offsets
  // in between, so that rounding does not grow along the record.
  return {samples, MatrixXd::Ones(samples.rows(), 1),
          [rows = samples.rows(), rate](Complex pole) {
            constexpr Index block = 32;
            Complex offset[block];
            for (Index j = 0; j < block; ++j) offset[j] = std::exp(pole * (static_cast<double>(j) / rate));
            PoleColumns c{MatrixXd(rows, 2), MatrixXd(rows, 2)};
            Complex start = 0;
            for (Index i = 0; i < rows; ++i) {
              const double t = static_cast<double>(i) / rate;
              if (i % block == 0) start = 2.0 * std::exp(pole * t);
              const Complex factor = offset[i % block];
              const double real = start.real() * factor.real() - start.imag() * factor.imag();
              const double imaginary_part = start.real() * factor.imag() + start.imag() * factor.real();
              c.columns(i, 0) = real;
              c.columns(i, 1) = -imaginary_part;
              c.derivatives(i, 0) = t * real;
              c.derivatives(i, 1) = -t * imaginary_part;
            }
            return c;
          },
          static_cast<double>(samples.rows()) / rate, std::numbers::pi * rate};
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

// Poles stay below the highest line, or the highest of those given: above it the lines show no peak.
Separable in_frequency(const Eigen::Ref<const VectorXd>& omega, const Eigen::Ref<const MatrixXcd>& responses,
                       ResponseForm form, double highest) {
  if (omega.size() != responses.rows()) throw std::invalid_argument("pole fit: lines and responses differ");
  if (omega.size() > 0 && !(omega.minCoeff() > 0))
    throw std::invalid_argument("pole fit: the frequencies are not positive");
  const VectorXcd s = imaginary * omega.cast<Complex>();
  return {stacked(responses), stacked(outside_terms(omega, form)),
          [s](Complex pole) {
            const VectorXcd up = (s.array() - pole).inverse(), down = (s.array() - std::conj(pole)).inverse();
            const VectorXcd du = up.cwiseProduct(up), dd = down.cwiseProduct(down);
            MatrixXcd c(s.size(), 2), d(s.size(), 2);
            c << up + down, imaginary * (up - down);
            d << du + dd, imaginary * (du - dd);
            return PoleColumns{stacked(c), stacked(d)};
          },
          0, std::max(highest, omega.size() > 0 ? omega.maxCoeff() : 0)};
}

}  // namespace

bool representable(Complex pole, double duration_s) {
  return pole.real() * duration_s < 300;
}

PoleFit fit_residues(const Eigen::Ref<const MatrixXd>& samples, double sample_rate_hz,
                     const Eigen::Ref<const VectorXcd>& poles) {
  return residues_of(in_time(samples, sample_rate_hz), poles);
}

PoleFit refine_poles(const Eigen::Ref<const MatrixXd>& samples, double sample_rate_hz,
                     const Eigen::Ref<const VectorXcd>& start) {
  return refined(in_time(samples, sample_rate_hz), start);
}

// By variable projection: the poles move by -H^-1 J^T e for errors e of the samples, J and H as in refine_once.
std::vector<PoleInfluence> pole_influences(const Eigen::Ref<const MatrixXd>& samples, double sample_rate_hz,
                                           const PoleFit& fit) {
  const Separable problem = in_time(samples, sample_rate_hz);
  check(problem, fit.poles);
  const Index n = fit.poles.size(), rows = samples.rows(), signals = samples.cols();
  const MatrixXd design = design_of(problem, fit.poles);
  MatrixXd derivatives(rows, 2 * n);
  for (Index r = 0; r < n; ++r) derivatives.middleCols(2 * r, 2) = problem.columns(fit.poles(r)).derivatives;
  const Eigen::HouseholderQR<MatrixXd> qr(design);
  const MatrixXd orthogonal = qr.householderQ() * MatrixXd::Identity(rows, design.cols());
  derivatives -= orthogonal * (orthogonal.transpose() * derivatives);
  const MatrixXd moments = derivatives.transpose() * derivatives;
  const double floor = noise_floor(problem);
  MatrixXd hessian = MatrixXd::Zero(2 * n, 2 * n);
  std::vector<MatrixXd> turns;
  for (Index s = 0; s < signals; ++s) {
    VectorXd coefficients(2 * n);
    for (Index r = 0; r < n; ++r)
      coefficients.segment(2 * r, 2) << fit.residues(r, s).real(), fit.residues(r, s).imag();
    turns.push_back(turn_of(coefficients / std::max(fit.noise_sd(s), floor), VectorXd::Ones(n)));
    hessian += turns.back().transpose() * (moments * turns.back());
  }
  const VectorXd shorten = hessian.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::LDLT<MatrixXd> scaled(MatrixXd(shorten.asDiagonal() * hessian * shorten.asDiagonal()));
  const MatrixXd inverse = shorten.asDiagonal() * MatrixXd(scaled.solve(MatrixXd(shorten.asDiagonal())));
  std::vector<PoleInfluence> result(static_cast<std::size_t>(n),
                                    {MatrixXd(rows, signals), MatrixXd(rows, signals)});
  for (Index s = 0; s < signals; ++s) {
    const MatrixXd moved = derivatives * (turns[static_cast<std::size_t>(s)] * inverse);
    for (Index r = 0; r < n; ++r) {
      result[static_cast<std::size_t>(r)].growth.col(s) = moved.col(2 * r);
      result[static_cast<std::size_t>(r)].omega.col(s) = moved.col(2 * r + 1);
    }
  }
  // As the fit says its noise, which it counts over all unknowns.
  for (Index r = 0; r < n; ++r) {
    PoleInfluence& influence = result[static_cast<std::size_t>(r)];
    influence.growth *= fit.growth_sd(r) / std::max(influence.growth.norm(), 1e-300);
    influence.omega *= fit.omega_sd(r) / std::max(influence.omega.norm(), 1e-300);
  }
  return result;
}

PoleFit refine_poles(const Eigen::Ref<const VectorXd>& omega, const Eigen::Ref<const MatrixXcd>& responses,
                     ResponseForm form, const Eigen::Ref<const VectorXcd>& start) {
  const double highest = start.size() > 0 ? start.imag().maxCoeff() : 0;
  return refined(in_frequency(omega, responses, form, highest), start);
}

}  // namespace secular
