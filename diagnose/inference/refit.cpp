#include "diagnose/inference/refit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Singular values of the scaled columns below this share of the largest count as zero: differences are not better.
constexpr double rank_tolerance = 1e-6;

/// Chi-squared to first order, in variances of the rows about the fit, that a free step from the end of a converged
/// one may still promise at most: explanations are compared in these variances, and none by so little.
constexpr double promise_kept = 0.1;

/// Differences are taken over changes of the rows by this to one over this standard deviations.
constexpr double least_change = 0.03;

// Minimum-norm solution in columns of unit length, and what it leaves undetermined.
struct Step {
  VectorXd step;
  Index rank = 0;
};

Step damped_step(const MatrixXd& jacobian, const VectorXd& rows, double damping) {
  const VectorXd length = jacobian.colwise().norm().cwiseMax(std::numeric_limits<double>::min()).transpose();
  const MatrixXd unit = jacobian * length.cwiseInverse().asDiagonal();
  const Eigen::BDCSVD<MatrixXd> svd(unit, Eigen::ComputeThinU | Eigen::ComputeThinV);
  Step result;
  VectorXd weighted = svd.matrixU().transpose() * rows;
  for (Index i = 0; i < weighted.size(); ++i) {
    const double s = svd.singularValues()(i);
    if (s > rank_tolerance * svd.singularValues()(0)) {
      weighted(i) *= s / (s * s + damping);
      ++result.rank;
    } else {
      weighted(i) = 0;
    }
  }
  result.step = -length.cwiseInverse().cwiseProduct(svd.matrixV() * weighted);
  return result;
}

// Unknowns after a step of those that are free, in units of their scales.
VectorXd moved_by(const Refit& fit, const VectorXd& step) {
  VectorXd moved = fit.unknowns;
  for (std::size_t f = 0; f < fit.free.size(); ++f)
    moved(static_cast<Index>(fit.free[f])) += fit.scale(static_cast<Index>(f)) * step(static_cast<Index>(f));
  return moved;
}

// Along a curved valley straight steps must be short. The second derivative of the rows in the direction of a step
// bends it (geodesic acceleration, Transtrum and Sethna 2012, with their numbers for the difference and for the
// longest bend by the step).
VectorXd bent(const Discrepancy& discrepancy, const Refit& fit, const VectorXd& step, double damping) {
  constexpr double part = 0.1, longest = 0.75;
  const VectorXd ahead = discrepancy(moved_by(fit, part * step));
  const VectorXd curvature = 2 / part * ((ahead - fit.rows) / part - fit.jacobian * step);
  if (!curvature.allFinite()) return step;
  const VectorXd bend = 0.5 * damped_step(fit.jacobian, curvature, damping).step;
  return 2 * bend.norm() > longest * step.norm() ? step : VectorXd(step + bend);
}

}  // namespace

double dispersion_of(double chi_squared, double freedom) {
  return freedom > 0 ? std::max(1.0, chi_squared / freedom) : 1;
}

UnitSlopes unit_slopes(const Discrepancy& discrepancy, const VectorXd& unknowns,
                       const std::vector<std::size_t>& which, const VectorXd& guess, unsigned threads) {
  const auto count = static_cast<Index>(which.size());
  UnitSlopes result{VectorXd::Zero(count), MatrixXd::Zero(discrepancy.size(), count)};
  VectorXd step(count);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < which.size(); ++i) {
    const auto u = static_cast<Index>(which[i]);
    const double value = std::abs(unknowns(u));
    step(static_cast<Index>(i)) = guess.size() > 0 && guess(u) > 0 ? guess(u) : value > 0 ? 1e-6 * value : 1e-9;
    open.push_back(i);
  }
  // Steps change by factors until the rows move by something near one.
  for (int attempt = 0; attempt < 20 && !open.empty(); ++attempt) {
    std::vector<std::size_t> tried;
    VectorXd steps(static_cast<Index>(open.size()));
    for (std::size_t o = 0; o < open.size(); ++o) {
      tried.push_back(which[open[o]]);
      steps(static_cast<Index>(o)) = step(static_cast<Index>(open[o]));
    }
    const MatrixXd columns = discrepancy.slopes(unknowns, tried, steps, threads);
    std::vector<std::size_t> still;
    for (std::size_t o = 0; o < open.size(); ++o) {
      const auto i = static_cast<Index>(open[o]);
      const double change = columns.col(static_cast<Index>(o)).norm();
      if (change > least_change && change < 1 / least_change) {
        result.scale(i) = step(i) / change;
        result.columns.col(i) = columns.col(static_cast<Index>(o)) / change;
        continue;
      }
      step(i) *= change < 1e-7 ? 1e3 : std::clamp(1 / change, 1e-6, 1e6);
      if (step(i) < 1e25) still.push_back(open[o]);
    }
    open = std::move(still);
  }
  return result;
}

Refit refit(const Discrepancy& discrepancy, const VectorXd& start, const std::vector<std::size_t>& free,
            const RefitOptions& options) {
  Refit fit;
  fit.unknowns = start;
  fit.free = free;
  fit.rows = discrepancy(start);
  fit.chi_squared = fit.rows.squaredNorm();
  UnitSlopes slopes = unit_slopes(discrepancy, start, free, options.scale_guess, options.threads);
  fit.scale = std::move(slopes.scale);
  fit.jacobian = std::move(slopes.columns);
  double damping = options.damping;
  bool fresh = true;
  for (int i = 0; i < options.iterations && !free.empty(); ++i) {
    if (!fresh) {
      fit.jacobian = discrepancy.slopes(fit.unknowns, free, fit.scale, options.threads);
      fresh = true;
    }
    const Step step = damped_step(fit.jacobian, fit.rows, damping);
    fit.rank = step.rank;
    const VectorXd next = moved_by(fit, options.bends ? bent(discrepancy, fit, step.step, damping) : step.step);
    const VectorXd rows = discrepancy(next);
    const double chi_squared = rows.squaredNorm();
    const double promised = fit.chi_squared - (fit.rows + fit.jacobian * step.step).squaredNorm();
    if (std::isfinite(chi_squared) && chi_squared <= fit.chi_squared) {
      const double gain = fit.chi_squared - chi_squared;
      fit.unknowns = next;
      fit.rows = rows;
      fit.chi_squared = chi_squared;
      fresh = false;
      damping = damping < 1e-6 ? 0 : damping / 30;
      if (gain < 1e-4 + 1e-7 * chi_squared) break;
    } else {
      if (promised < 1e-3 + 1e-6 * fit.chi_squared || damping > 1e6) break;
      damping = std::max(1e-4, 30 * damping);
    }
  }
  if (!free.empty()) {
    if (!fresh) fit.jacobian = discrepancy.slopes(fit.unknowns, free, fit.scale, options.threads);
    const VectorXd length = fit.jacobian.colwise().norm().transpose();
    const VectorXd unit = length.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
    const Eigen::BDCSVD<MatrixXd> svd(fit.jacobian * unit.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
    VectorXd inverse = VectorXd::Zero(svd.singularValues().size());
    const VectorXd promised = svd.matrixU().transpose() * fit.rows;
    double promise = 0;
    fit.rank = 0;
    fit.identifiable.assign(free.size(), true);
    for (Index i = 0; i < inverse.size(); ++i) {
      if (svd.singularValues()(i) > rank_tolerance * svd.singularValues()(0)) {
        inverse(i) = 1 / (svd.singularValues()(i) * svd.singularValues()(i));
        promise += promised(i) * promised(i);
        ++fit.rank;
      } else {
        for (std::size_t f = 0; f < free.size(); ++f)
          if (std::abs(svd.matrixV()(static_cast<Index>(f), i)) > 1e-3) fit.identifiable[f] = false;
      }
    }
    // Damping makes every promise small: only what a free step promises tells whether this is the minimum.
    const double dispersion = dispersion_of(fit.chi_squared, static_cast<double>(discrepancy.freedom() - fit.rank));
    if (promise < promise_kept * dispersion) fit.ending = FitEnding::converged;
    for (std::size_t f = 0; f < free.size(); ++f)
      if (!(length(static_cast<Index>(f)) > 0)) fit.identifiable[f] = false;
    const MatrixXd turned = fit.scale.cwiseProduct(unit).asDiagonal() * svd.matrixV();
    fit.covariance = turned * inverse.asDiagonal() * turned.transpose();
  } else {
    fit.ending = FitEnding::converged;
    fit.jacobian.resize(fit.rows.size(), 0);
    fit.covariance.resize(0, 0);
  }
  return fit;
}

}  // namespace secular
