#include "diagnose/refit.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "estimator/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Singular values of the scaled columns below this share of the largest count as zero: differences are not better.
constexpr double rank_tolerance = 1e-6;

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

}  // namespace

VectorXd natural_scales(const Discrepancy& discrepancy, const VectorXd& unknowns,
                        const std::vector<std::size_t>& which, unsigned threads) {
  const VectorXd base = discrepancy(unknowns);
  VectorXd scale = VectorXd::Zero(static_cast<Index>(which.size()));
  in_parallel(which.size(), threads, [&](std::size_t i) {
    const auto u = static_cast<Index>(which[i]);
    const double value = std::abs(unknowns(u));
    double step = value > 0 ? 1e-6 * value : 1e-9;
    VectorXd moved = unknowns;
    // Changes by factors until the rows move by something near one.
    for (int attempt = 0; attempt < 40; ++attempt) {
      moved(u) = unknowns(u) + step;
      const double change = (discrepancy(moved) - base).norm();
      if (change > 0.3 && change < 3) {
        scale(static_cast<Index>(i)) = step;
        return;
      }
      if (!std::isfinite(change) || change >= 3)
        step *= std::isfinite(change) ? std::max(1e-6, 1 / change) : 1e-3;
      else if (change < 1e-7)
        step *= 1e3;
      else
        step *= std::min(1e6, 1 / change);
      if (step > 1e25) return;
    }
    // Something that jumps: what the last step gave has to do.
    scale(static_cast<Index>(i)) = step;
  });
  return scale;
}

MatrixXd jacobian_of(const Discrepancy& discrepancy, const VectorXd& unknowns,
                     const std::vector<std::size_t>& which, const VectorXd& scale, unsigned threads) {
  MatrixXd jacobian = MatrixXd::Zero(discrepancy.size(), static_cast<Index>(which.size()));
  in_parallel(which.size(), threads, [&](std::size_t i) {
    const auto column = static_cast<Index>(i);
    const auto u = static_cast<Index>(which[i]);
    if (!(scale(column) > 0)) return;
    VectorXd moved = unknowns;
    moved(u) = unknowns(u) + 0.5 * scale(column);
    const VectorXd up = discrepancy(moved);
    moved(u) = unknowns(u) - 0.5 * scale(column);
    jacobian.col(column) = up - discrepancy(moved);
    if (!jacobian.col(column).allFinite()) jacobian.col(column).setZero();
  });
  return jacobian;
}

Refit refit(const Discrepancy& discrepancy, const VectorXd& start, const std::vector<std::size_t>& free,
            const RefitOptions& options) {
  Refit fit;
  fit.unknowns = start;
  fit.free = free;
  fit.rows = discrepancy(start);
  fit.chi_squared = fit.rows.squaredNorm();
  fit.scale = natural_scales(discrepancy, start, free, options.threads);
  double damping = 0;
  bool fresh = false;
  for (int i = 0; i < options.iterations && !free.empty(); ++i) {
    if (!fresh) {
      fit.jacobian = jacobian_of(discrepancy, fit.unknowns, free, fit.scale, options.threads);
      fresh = true;
    }
    const Step step = damped_step(fit.jacobian, fit.rows, damping);
    fit.rank = step.rank;
    VectorXd next = fit.unknowns;
    for (std::size_t f = 0; f < free.size(); ++f)
      next(static_cast<Index>(free[f])) += fit.scale(static_cast<Index>(f)) * step.step(static_cast<Index>(f));
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
      if (gain < 1e-4 + 1e-7 * chi_squared) {
        fit.converged = true;
        break;
      }
    } else {
      if (promised < 1e-3 + 1e-6 * fit.chi_squared || damping > 1e6) {
        fit.converged = true;
        break;
      }
      damping = std::max(1e-4, 30 * damping);
    }
  }
  if (!free.empty()) {
    fit.jacobian = jacobian_of(discrepancy, fit.unknowns, free, fit.scale, options.threads);
    const VectorXd length = fit.jacobian.colwise().norm().transpose();
    const VectorXd unit = length.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
    const Eigen::BDCSVD<MatrixXd> svd(fit.jacobian * unit.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
    VectorXd inverse = VectorXd::Zero(svd.singularValues().size());
    fit.rank = 0;
    fit.identifiable.assign(free.size(), true);
    for (Index i = 0; i < inverse.size(); ++i) {
      if (svd.singularValues()(i) > rank_tolerance * svd.singularValues()(0)) {
        inverse(i) = 1 / (svd.singularValues()(i) * svd.singularValues()(i));
        ++fit.rank;
      } else {
        for (std::size_t f = 0; f < free.size(); ++f)
          if (std::abs(svd.matrixV()(static_cast<Index>(f), i)) > 1e-3) fit.identifiable[f] = false;
      }
    }
    for (std::size_t f = 0; f < free.size(); ++f)
      if (!(length(static_cast<Index>(f)) > 0)) fit.identifiable[f] = false;
    const MatrixXd turned = fit.scale.cwiseProduct(unit).asDiagonal() * svd.matrixV();
    fit.covariance = turned * inverse.asDiagonal() * turned.transpose();
  } else {
    fit.converged = true;
    fit.jacobian.resize(fit.rows.size(), 0);
    fit.covariance.resize(0, 0);
  }
  return fit;
}

}  // namespace secular
