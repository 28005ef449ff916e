#include "diagnose/inference/refit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "diagnose/inference/directions.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A step that brings less than this share of what it promised shows that slopes have changed on its way (the usual
/// bound of trust regions, Nocedal and Wright 2006, chapter 4).
constexpr double least_kept = 0.25;

/// A change of an unknown by so many times what moved the rows by one before, or its value, is no slope any more:
/// what moves them then is another motion (a contact that is hardly reached, behind which there is a wall).
constexpr double farthest = 1e6;

/// Differences are taken over changes of the rows by this to one over this standard deviations.
constexpr double least_change = 0.03;

// Along a curved valley straight steps must be short. The second derivative of the rows in the direction of a step
// bends it (geodesic acceleration, Transtrum and Sethna 2012, with their numbers for the difference and for the
// longest bend by the step).
VectorXd bent(const Discrepancy& discrepancy, const Refit& fit, const Directions& directions, const VectorXd& step,
              double damping) {
  constexpr double part = 0.1, longest = 0.75;
  const VectorXd ahead = discrepancy(unknowns_after(fit, fit.unknowns, part * step));
  const VectorXd curvature = 2 / part * ((ahead - fit.rows) / part - fit.jacobian * step);
  if (!curvature.allFinite()) return step;
  const VectorXd bend = 0.5 * directions.step(curvature, damping);
  return 2 * bend.norm() > longest * step.norm() ? step : VectorXd(step + bend);
}

// Steps of Levenberg and Marquardt. Slopes cost as much as many steps: after a step that brought what it promised
// they are corrected by what it showed of them (Broyden 1965), and taken anew where they led astray and at the end.
class Descent {
 public:
  Descent(const Discrepancy& discrepancy, const RefitOptions& options)
      : discrepancy_(discrepancy), options_(options), damping_(options.damping) {}

  // Until steps bring nothing more, at most so many; how many of these are left.
  int go(Refit& fit, int left) {
    for (; left > 0; --left) {
      const Directions directions(fit.jacobian);
      fit.rank = directions.rank();
      const VectorXd step = directions.step(fit.rows, damping_);
      const VectorXd taken = options_.bends ? bent(discrepancy_, fit, directions, step, damping_) : step;
      const VectorXd next = unknowns_after(fit, fit.unknowns, taken), rows = discrepancy_(next);
      const double chi_squared = rows.squaredNorm(), gain = fit.chi_squared - chi_squared,
                   promised = fit.chi_squared - (fit.rows + fit.jacobian * step).squaredNorm();
      if (std::isfinite(chi_squared) && gain >= 0) {
        const bool as_promised = !options_.bends && gain > least_kept * promised;
        if (as_promised) correct_slopes(fit.jacobian, taken, rows - fit.rows);
        fit.unknowns = next;
        fit.rows = rows;
        fit.chi_squared = chi_squared;
        damping_ = damping_ < 1e-6 ? 0 : damping_ / 30;
        const bool was_fresh = std::exchange(fresh_, false);
        if (gain < 1e-4 + 1e-7 * chi_squared) {
          stuck_ = was_fresh;
          return left - 1;
        }
        if (!as_promised) renew(fit);
      } else if (!fresh_) {
        renew(fit);
      } else {
        stuck_ = promised < 1e-3 + 1e-6 * fit.chi_squared || damping_ > 1e6;
        if (stuck_) return left - 1;
        damping_ = std::max(1e-4, 30 * damping_);
      }
    }
    return 0;
  }

  // Slopes where the fit is.
  void renew(Refit& fit) {
    if (!fresh_) fit.jacobian = discrepancy_.slopes(fit.unknowns, fit.free, fit.scale, options_.threads);
    fresh_ = true;
  }

  // Whether true slopes led to no better place.
  bool is_stuck() const { return stuck_; }

 private:
  const Discrepancy& discrepancy_;
  const RefitOptions& options_;
  double damping_;
  bool fresh_ = true, stuck_ = false;
};

// Rank, covariance and ending of a fit, by the slopes where it is.
SolverEnding judge_end(const Discrepancy& discrepancy, Refit& fit) {
  const Directions directions(fit.jacobian);
  const VectorXd promised = directions.along(fit.rows);
  const MatrixXd& of_unknowns = directions.of_unknowns();
  VectorXd inverse = VectorXd::Zero(promised.size());
  fit.rank = directions.rank();
  for (Index i = 0; i < fit.rank; ++i) inverse(i) = 1 / (directions.value(i) * directions.value(i));
  const double promise = promised.head(fit.rank).squaredNorm();
  fit.identifiable.assign(fit.free.size(), true);
  for (std::size_t f = 0; f < fit.free.size(); ++f) {
    const auto row = static_cast<Index>(f);
    const bool seen = directions.per_length()(row) > 0;
    const auto beyond = of_unknowns.row(row).tail(of_unknowns.cols() - fit.rank);
    fit.identifiable[f] = seen && !(beyond.cwiseAbs().array() > least_part_of_direction).any();
  }
  const MatrixXd turned = fit.scale.cwiseProduct(directions.per_length()).asDiagonal() * of_unknowns;
  fit.covariance = turned * inverse.asDiagonal() * turned.transpose();
  // Damping makes every promise small: only what a free step promises tells whether this is the minimum.
  const double dispersion = dispersion_of(fit.chi_squared, static_cast<double>(discrepancy.freedom() - fit.rank));
  fit.ending = promise < promise_kept * dispersion ? SolverEnding::converged : SolverEnding::stalled;
  return fit.ending;
}

}  // namespace

VectorXd unknowns_after(const Refit& fit, VectorXd unknowns, const VectorXd& step) {
  for (std::size_t f = 0; f < fit.free.size(); ++f)
    unknowns(static_cast<Index>(fit.free[f])) += fit.scale(static_cast<Index>(f)) * step(static_cast<Index>(f));
  return unknowns;
}

double dispersion_of(double chi_squared, double freedom) {
  return freedom > 0 ? std::max(1.0, chi_squared / freedom) : 1;
}

UnitSlopes unit_slopes(const Discrepancy& discrepancy, const VectorXd& unknowns,
                       const std::vector<std::size_t>& which, const VectorXd& guess, unsigned threads) {
  const auto count = static_cast<Index>(which.size());
  UnitSlopes result{VectorXd::Zero(count), MatrixXd::Zero(discrepancy.size(), count)};
  VectorXd step(count), otherwise(count);  // otherwise: where a guess moves nothing
  VectorXd longest = VectorXd::Constant(count, 1e25);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < which.size(); ++i) {
    const auto u = static_cast<Index>(which[i]), place = static_cast<Index>(i);
    const double value = std::abs(unknowns(u));
    otherwise(place) = value > 0 ? 1e-6 * value : 1e-9;
    step(place) = otherwise(place);
    if (guess.size() > 0 && guess(u) > 0) {
      step(place) = guess(u);
      longest(place) = farthest * std::max(guess(u), value);
    }
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
      // A guess that moves nothing is of a place where the unknown hardly counted.
      if (change < 1e-7 && guess.size() > 0 && step(i) == guess(static_cast<Index>(which[open[o]])))
        step(i) = otherwise(i);
      else
        step(i) *= change < 1e-7 ? 1e3 : std::clamp(1 / change, 1e-6, 1e6);
      if (step(i) < longest(i)) still.push_back(open[o]);
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
  if (free.empty()) {
    fit.ending = SolverEnding::converged;
    fit.covariance.resize(0, 0);
    return fit;
  }
  Descent descent(discrepancy, options);
  int left = options.iterations;
  do {
    left = descent.go(fit, left);
    descent.renew(fit);
  } while (judge_end(discrepancy, fit) == SolverEnding::stalled && left > 0 && !descent.is_stuck());
  return fit;
}

}  // namespace secular
