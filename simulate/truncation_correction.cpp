#include "simulate/truncation_correction.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "estimator/anderson_acceleration.hpp"
#include "input/input_error.hpp"

namespace secular {
namespace {

/// The correction is evaluated at the estimate, at the corrected one, and again while that still moves numbers by
/// more than a share of their error bars.
constexpr int most_truncation_passes = 12;
/// The pass that sees how the correction depends on what no lump tells: near enough to where it is used.
constexpr int unseen_pass = 2;
constexpr std::size_t remembered_passes = 6;
/// Values of a pass have errors of this share: differences that depend on one another so far say nothing.
constexpr double dependent_passes = 1e-3;
constexpr double settled_share = 0.1;
/// Of what is plausible: all of it may lead to quite another motion.
constexpr double displaced_share = 0.1;
/// A step after which motions grow beyond bounds is halved so often.
constexpr int most_returns = 4;

// By symbol: one over the standard deviation, 0 where there is no estimate.
Eigen::VectorXd inverse_sd(const Estimate& estimate) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(estimate.parameter_values.size());
  for (Eigen::Index p = 0; p < result.size(); ++p) {
    const EstimatedValue& value = estimate.parameters[static_cast<std::size_t>(p)];
    if (value.value && value.sd > 0) result(p) = 1 / value.sd;
  }
  return result;
}

// How the correction at `parameters` depends on what no lump tells of them: seen once, on motions replayed a
// part of the plausible way along each such direction, or back where that runs away. The number of directions in
// which both do.
int add_unseen(std::vector<ObservationSet>& corrected, std::span<const ObservationSet> measured,
               const Eigen::VectorXd& parameters, const Eigen::MatrixXd& directions, const ReplaySets& replay) {
  int unknown = 0;
  for (Eigen::Index d = 0; d < directions.cols(); ++d) {
    bool seen = false;
    for (const double sign : {1.0, -1.0}) {
      if (seen) break;
      const Eigen::VectorXd displaced = parameters + sign * displaced_share * directions.col(d);
      try {
        add_truncation_change(corrected, with_truncation(measured, replay(displaced), displaced));
        for (ObservationSet& set : corrected) set.truncation_change.back() /= displaced_share;
        seen = true;
      } catch (const InputError&) {
      }
    }
    if (!seen) ++unknown;
  }
  return unknown;
}

// At `parameters`, or where motions with these grow beyond bounds at the first on the way back to `good` ones with
// which they do not.
std::vector<ObservationSet> replay_near(Eigen::VectorXd& parameters, const Eigen::VectorXd& good, bool may_return,
                                        const ReplaySets& replay) {
  for (int step = 0;; ++step) {
    try {
      return replay(parameters);
    } catch (const InputError&) {
      if (!may_return || step == most_returns) throw;
      parameters = 0.5 * (parameters + good);
    }
  }
}

/// Sets as they were corrected at some parameters.
struct Pass {
  Eigen::VectorXd parameters;
  std::vector<ObservationSet> corrected;
};

// Symbols x moves: from earlier passes to the last one, and along the directions that no lump tells, with what each
// did to the last pass's correction.
Eigen::MatrixXd passed_moves(std::deque<Pass>& passes, const Eigen::MatrixXd& unseen) {
  Pass& last = passes.back();
  const auto earlier = static_cast<Eigen::Index>(passes.size()) - 1;
  const Eigen::Index directions =
      std::min(unseen.cols(), static_cast<Eigen::Index>(last.corrected.front().truncation_change.size()));
  Eigen::MatrixXd moves(last.parameters.size(), earlier + directions);
  for (Eigen::Index i = 0; i < earlier; ++i) {
    const Pass& before = passes[static_cast<std::size_t>(i)];
    moves.col(i) = last.parameters - before.parameters;
    add_passed(last.corrected, before.corrected);
  }
  moves.rightCols(directions) = unseen.leftCols(directions);
  for (ObservationSet& set : last.corrected)
    set.truncation_passed.insert(set.truncation_passed.end(), set.truncation_change.begin(),
                                 set.truncation_change.begin() + directions);
  return moves;
}

}  // namespace

TruncationCorrection correct_truncation(std::span<const ObservationSet> measured, const Estimate& raw,
                                        const MeasuredUnits& units, const EstimateOptions& options,
                                        const ReplaySets& replay, const StageDone& done) {
  TruncationCorrection result;
  result.estimate = raw;
  EstimateOptions quick = options;
  quick.bootstrap = 0;
  quick.damping_laws = quick.judge_fit = false;
  quick.keep_weights = !options.refine;
  EstimateOptions full = options;
  AndersonAcceleration acceleration(remembered_passes, dependent_passes);
  Eigen::VectorXd parameters = raw.parameter_values, next = parameters;
  bool settled = false;
  std::vector<ObservationSet> unseen;
  Eigen::MatrixXd unseen_directions;
  std::deque<Pass> passes;
  int unknown = 0;
  for (int pass = 1; pass <= most_truncation_passes && !settled; ++pass) {
    const Eigen::VectorXd good = parameters;
    parameters = next;
    result.replayed = replay_near(parameters, good, pass > 1, replay);
    std::vector<ObservationSet> corrected = with_truncation(measured, result.replayed, parameters);
    if (pass == unseen_pass) {
      unseen_directions = result.estimate.unseen;
      unknown = add_unseen(corrected, measured, parameters, unseen_directions, replay);
      unseen = corrected;
    } else if (pass > unseen_pass) {
      keep_truncation_change(corrected, unseen);
    }
    done("replay of the full equations");
    passes.push_back({parameters, std::move(corrected)});
    if (passes.size() > remembered_passes) passes.pop_front();
    quick.start = result.estimate.state;
    result.estimate = estimate(passes.back().corrected, units, quick);
    // With what no lump tells as an unknown it is another map: what was learnt of the first says nothing of it.
    if (pass == unseen_pass) acceleration = AndersonAcceleration(remembered_passes, dependent_passes);
    const Eigen::VectorXd weight = inverse_sd(result.estimate);
    next = acceleration.next(parameters, result.estimate.parameter_values, weight);
    const double move = weight.cwiseProduct(next - parameters).cwiseAbs().maxCoeff();
    settled = move < settled_share && (pass >= unseen_pass || result.estimate.unseen.cols() == 0);
    if (settled || pass == most_truncation_passes) {
      full.start = result.estimate.state;
      full.passed = passed_moves(passes, unseen_directions);
      result.estimate = estimate(passes.back().corrected, units, full);
    }
    done("regression");
  }
  result.estimate = with_correction_shown(std::move(result.estimate), raw);
  result.estimate = with_unsettled_correction(std::move(result.estimate), parameters, next);
  if (unknown > 0)
    result.estimate.warnings.emplace_back(
        "the correction for the expansion's truncation depends on parameters that cannot be told apart, and "
        "motions "
        "with other values of them grow beyond bounds: error bars do not contain that");
  done("regression");
  return result;
}

}  // namespace secular
