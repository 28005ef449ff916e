#include "diagnose/verdict/simulated_check.hpp"

#include <cmath>
#include <memory>
#include <optional>

#include "diagnose/evidence/virtual_dwell.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Mean square of a channel's oscillating lines: half of the peak squared, 2 |c|^2, each; the mean's own is added.
VectorXd mean_square(const Condition& c, const Eigen::MatrixXcd& lines) {
  VectorXd sum = VectorXd::Zero(lines.rows());
  for (Index l = 0; l < lines.cols(); ++l)
    sum += (c.lines[static_cast<std::size_t>(l)] == 0 ? 1 : 2) * lines.col(l).cwiseAbs2();
  return sum;
}

std::vector<SimulatedError> errors_of(const SensorModel& sensors, const VectorXd& signal, const VectorXd& before,
                                      const VectorXd& after) {
  std::vector<SimulatedError> errors;
  for (std::size_t c = 0; c < sensors.response_names.size(); ++c) {
    const auto i = static_cast<Index>(c);
    errors.push_back(
        {sensors.response_names[c], std::sqrt(signal(i)), std::sqrt(before(i)), std::sqrt(after(i)), {}, {}});
  }
  return errors;
}

/// States of records are those that fit best to first order about the last fit: it is fitted again until this share
/// of the error is all that changes.
constexpr double settled = 1e-3;
constexpr int most_passes = 6;

// Mean squares by channel at the unknowns of `fit` that a window's records like best.
VectorXd least_mean_square(const SegmentEvidence& records, const Refit& fit, unsigned threads) {
  Discrepancy window;
  window.add(std::make_unique<SegmentEvidence>(records));
  RefitOptions options;
  options.threads = threads;
  VectorXd unknowns = fit.unknowns, least = records.mean_square_error(unknowns);
  for (int pass = 0; pass < most_passes; ++pass) {
    window.freeze(unknowns);
    unknowns = refit(window, unknowns, fit.free, options).unknowns;
    const VectorXd there = records.mean_square_error(unknowns);
    const bool rest = there.sum() > (1 - 2 * settled) * least.sum();
    if (there.sum() < least.sum()) least = there;
    if (rest) break;
  }
  return least;
}

}  // namespace

void fit_window(const SegmentEvidence& window, const Refit& before, const Refit& after, unsigned threads,
                std::vector<SimulatedError>& errors) {
  const VectorXd least_before = least_mean_square(window, before, threads),
                 least_after = least_mean_square(window, after, threads);
  for (std::size_t c = 0; c < errors.size(); ++c) {
    errors[c].before_fitted = std::sqrt(least_before(static_cast<Index>(c)));
    errors[c].after_fitted = std::sqrt(least_after(static_cast<Index>(c)));
  }
}

SimulatedCheck simulated_dwells(const ConditionModel& model, const std::vector<Condition>& conditions,
                                const VectorXd& before, const VectorXd& after, unsigned threads) {
  SimulatedCheck check;
  const SensorModel& sensors = model.sensors();
  const auto channels = static_cast<Index>(sensors.response_names.size());
  struct Pair {
    std::optional<Condition> before, after;
  };
  std::vector<Pair> steady(conditions.size());
  in_parallel(conditions.size(), threads, [&](std::size_t i) {
    steady[i].before = virtual_dwell(model, conditions[i], before, 1, 1);
    steady[i].after = virtual_dwell(model, conditions[i], after, 1, 1);
  });
  VectorXd signal = VectorXd::Zero(channels), off_before = signal, off_after = signal;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const Condition& c = conditions[i];
    if (c.torus->dimensions() != 1 || c.masters.empty() || c.fundamental == 0) continue;
    if (!steady[i].before || !steady[i].after) {
      ++check.lost;
      continue;
    }
    ++check.steady;
    signal += mean_square(c, c.response);
    off_before += mean_square(c, c.response - steady[i].before->response);
    off_after += mean_square(c, c.response - steady[i].after->response);
  }
  if (check.steady > 0) {
    const auto n = static_cast<double>(check.steady);
    check.dwells = errors_of(sensors, signal / n, off_before / n, off_after / n);
  }
  return check;
}

std::vector<SimulatedError> simulated_window(const SegmentEvidence& window, const SensorModel& sensors,
                                             const VectorXd& before, const VectorXd& after) {
  return errors_of(sensors, window.mean_square_signal(), window.mean_square_error(before),
                   window.mean_square_error(after));
}

}  // namespace secular
