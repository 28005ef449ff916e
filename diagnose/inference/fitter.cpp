#include "diagnose/inference/fitter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/thresholds.hpp"

namespace secular {
namespace {

using Eigen::VectorXd;

/// Errors taken anew at a fit that was made among others change what it leaves beyond noise by no more than this
/// factor, or that fit has run away with its own errors.
constexpr auto& reweighting = diagnose_thresholds().reweighting;

/// Errors of a fit are taken anew so often at each level; among the true ones of a model that leaves no more than
/// noise, until that changes less than chance does, and at most as often as this: each time with what the last fit
/// left of states and noise, which comes to rest slowly where these are large.
constexpr int usual_rounds = 6, most_rounds = 24;

}  // namespace

double most_of_noise(double freedom) {
  return freedom + diagnose_thresholds().least_structure * std::sqrt(2 * freedom);
}

bool is_within_noise(double chi_squared, double freedom) {
  return chi_squared <= most_of_noise(freedom);
}

bool is_missed(double chi_squared, double rows) {
  return chi_squared > diagnose_thresholds().most_residual * rows;
}

void Fitter::freeze(const VectorXd& at, double coarse, Lookout lookout) {
  frozen_ = {at, coarse};
  discrepancy_.freeze(at, coarse, lookout);
}

RefitOptions Fitter::options(unsigned threads) const {
  RefitOptions options;
  options.threads = threads;
  options.scale_guess = scales_.all();
  return options;
}

Refit Fitter::fit_own(const VectorXd& from, const std::vector<std::size_t>& free, double damping) {
  RefitOptions damped = options(threads_);
  damped.damping = damping;
  Refit fit = refit(discrepancy_, from, free, damped);
  scales_.remember(free, fit.scale);
  if (after_own_fit_) after_own_fit_();
  return fit;
}

LevelFit Fitter::at_level(VectorXd unknowns, const std::vector<std::size_t>& free, double coarse) {
  Refit fit;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most_rounds; ++round) {
    freeze(unknowns, coarse, round > 0 ? Lookout::close_by : Lookout::anywhere);
    Refit next = fit_own(unknowns, free, coarse > 0 ? diagnose_thresholds().first_damping : 0);
    if (next.chi_squared > reweighting * std::max(before, rows())) break;
    fit = std::move(next);
    unknowns = fit.unknowns;
    const bool holds = coarse == 0 && is_within_noise(fit.chi_squared, rows());
    const double change = std::abs(fit.chi_squared - before);
    if (round > 0 && change < (holds ? diagnose_thresholds().least_gain : 0.02 * before + 1)) break;
    if (round + 1 >= usual_rounds && !holds) break;
    before = fit.chi_squared;
  }
  return {std::move(fit), rows()};
}

std::vector<LevelFit> Fitter::from_coarse_to_fine(const VectorXd& start, const std::vector<std::size_t>& free,
                                                  double most) {
  std::vector<LevelFit> fits;
  for (const double coarse : coarse_levels) {
    fits.push_back(at_level(fits.empty() ? start : fits.back().fit.unknowns, free, coarse));
    if (!discrepancy_.measures_errors() && fits.back().fit.chi_squared > reweighting * most) break;
  }
  return fits;
}

void Fitter::return_to(const Place& place) {
  freeze(place.at, place.coarse);
  scales_ = place.scales;
}

}  // namespace secular
