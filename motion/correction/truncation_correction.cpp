#include "motion/correction/truncation_correction.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "estimator/identification/identified_lumps.hpp"
#include "input/numerical_failure.hpp"
#include "measure/observe/common_observations.hpp"
#include "motion/thresholds.hpp"
#include "numerics/anderson_acceleration.hpp"

namespace secular {
namespace {

/// Stages.
constexpr const char *full_equations = "motions of the full equations", *regression = "corrected regressions";
/// The correction is evaluated at the estimate, at the corrected one, and so on: first as it comes, until that
/// moves numbers by no more than a few error bars, then with how it depends on the parameters, until they rest.
constexpr int most_plain_passes = 5, most_passes = 18;
constexpr double near = 2;
/// The pass that sees how the correction depends on the null space: near enough to where it is used.
constexpr int null_space_pass = 2;
constexpr std::size_t remembered_passes = 6;
/// Values of a pass have errors of this share: differences that depend on one another so far say nothing.
constexpr double dependent_passes = 1e-3;
/// Of what is plausible, or of a standard deviation: all of it may lead to quite another motion.
constexpr double displaced_share = 0.02;
/// A step after which motions grow beyond bounds is halved so often; none goes further along the null space, of
/// what is plausible.
constexpr int most_returns = 8;
constexpr double longest_step = 8;
constexpr int most_halvings = 5;
/// Slopes hold this far around, in standard deviations (of what is plausible, along the null space); they are
/// seen so often.
constexpr double local = 1;
constexpr int most_slopes = 6;
/// Those along what lumps tell hold this much further, while the others are seen again.
constexpr double near_axes = 4;
/// Weights follow up to here: they may go around in a circle.
constexpr int last_weights = most_plain_passes + 6;
/// Motions up to these shares of the largest ones are tried where those grow beyond bounds.
constexpr double small_shares[] = {0.7, 0.5, 0.35};
/// A unit vector that null-space directions leave less than this of has no direction beside them (rounding, of
/// lengths about 1e-16).
constexpr double no_direction = 1e-6;
/// A step that leaves more than this share of the way to go tells of slopes that no longer hold.
constexpr double slow = 0.5;

// By symbol: one over the standard deviation, 0 where there is no estimate.
Eigen::VectorXd inverse_sd(const Estimate& estimate) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(estimate.parameter_values.size());
  for (Eigen::Index p = 0; p < result.size(); ++p) {
    const EstimatedValue& value = estimate.parameters[static_cast<std::size_t>(p)];
    if (value.value && value.sd > 0) result(p) = 1 / value.sd;
  }
  return result;
}

// Largest factor by which standard deviations are more than those in `sd`.
double growth(const Estimate& estimate, const Eigen::VectorXd& sd) {
  double largest = 1;
  for (Eigen::Index p = 0; p < sd.size(); ++p)
    if (sd(p) > 0 && estimate.parameters[static_cast<std::size_t>(p)].value)
      largest = std::max(largest, estimate.parameters[static_cast<std::size_t>(p)].sd / sd(p));
  return largest;
}

/// Changes of the correction, by direction and set, and the number of directions in which nothing is known of them.
struct Slopes {
  std::vector<std::vector<Eigen::MatrixXcd>> change;
  int unknown = 0;
};

/// Parameters that share of a direction away.
using Displaced = std::function<Eigen::VectorXd(Eigen::Index direction, double share)>;

// What of the correction of `corrected` sets changes from where it was made to `displaced`; nothing where motions
// grow beyond bounds.
std::optional<std::vector<Eigen::MatrixXcd>> change_towards(const Eigen::VectorXd& displaced,
                                                            std::span<const ObservationSet> corrected,
                                                            FullMotions& motions, unsigned threads) {
  try {
    if (const auto moved = motions.at(displaced))
      return truncation_difference(corrected, *moved, displaced, threads);
  } catch (const NumericalFailure&) {
  }
  return std::nullopt;
}

// How the correction of `corrected` sets changes along each direction: central differences of motions a part of the
// way there and back. (One-sided ones would book the second derivative as slope, on one direction or another
// according to how directions happen to be chosen.) One-sided where one of the two is missing; zero where both are.
Slopes slopes_along(Eigen::Index directions, const Displaced& displaced_to,
                    std::span<const ObservationSet> corrected, FullMotions& motions, unsigned threads) {
  Slopes slopes;
  for (Eigen::Index d = 0; d < directions; ++d) {
    const auto ahead = change_towards(displaced_to(d, displaced_share), corrected, motions, threads);
    const auto back = change_towards(displaced_to(d, -displaced_share), corrected, motions, threads);
    if (!ahead && !back) ++slopes.unknown;
    const double between = displaced_share * ((ahead ? 1 : 0) + (back ? 1 : 0));
    std::vector<Eigen::MatrixXcd> change;
    for (std::size_t s = 0; s < corrected.size(); ++s) {
      change.push_back(Eigen::MatrixXcd::Zero(corrected[s].truncation.rows(), corrected[s].truncation.cols()));
      if (ahead) change.back() += (*ahead)[s] / between;
      if (back) change.back() -= (*back)[s] / between;
    }
    slopes.change.push_back(std::move(change));
  }
  return slopes;
}

// Symbols x axes: one for each parameter that has an error bar, a standard deviation long: the direction nearest to
// its own that is orthogonal, in standard deviations, to the null-space ones (those keep slopes of their own). For
// a parameter that no null-space direction moves this is the parameter itself. Entangled ones have more axes than
// they have dimensions: a basis would have to be chosen, and a choice between equals would hang on rounding.
Eigen::MatrixXd axes_beside(const Eigen::MatrixXd& null_space, const Eigen::VectorXd& sd) {
  std::vector<Eigen::Index> moving;
  for (Eigen::Index p = 0; p < sd.size(); ++p)
    if (sd(p) > 0) moving.push_back(p);
  const auto size = static_cast<Eigen::Index>(moving.size());
  const Eigen::VectorXd own = sd(moving);
  Eigen::MatrixXd beside = Eigen::MatrixXd::Identity(size, size);
  if (null_space.cols() > 0 && size > 0) {
    Eigen::MatrixXd directions = own.cwiseInverse().asDiagonal() * null_space(moving, Eigen::all);
    directions.colwise().normalize();
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(directions);
    const Eigen::MatrixXd span = Eigen::MatrixXd(qr.householderQ()).leftCols(qr.rank());
    beside -= span * span.transpose();
  }
  Eigen::MatrixXd axes = Eigen::MatrixXd::Zero(sd.size(), size);
  Eigen::Index count = 0;
  for (Eigen::Index m = 0; m < size; ++m) {
    const double length = beside.col(m).norm();
    if (length < no_direction) continue;
    axes(moving, count++) = own.cwiseProduct(beside.col(m)) / length;
  }
  axes.conservativeResize(Eigen::NoChange, count);
  return axes;
}

// Whether replays differ from what was measured by less than that is, over all observations and modes of each set:
// what is taken out of the equations at another motion is no correction for this one.
bool stay_with(std::span<const ObservationSet> measured, const std::vector<ObservationSet>& replayed) {
  for (std::size_t s = 0; s < replayed.size(); ++s) {
    double size = 0, moved = 0;
    for_common_observations(measured[s], replayed[s], [&](std::size_t i, std::size_t at) {
      const Observation &was = measured[s].observations[i], &is = replayed[s].observations[at];
      for (std::size_t k = 0; k < was.amplitude.size(); ++k) {
        size += std::norm(was.amplitude[k]);
        const double more = std::abs(is.amplitude[k]) - std::abs(was.amplitude[k]);  // phases are of other clocks
        moved += more * more;
      }
    });
    if (!(moved <= size)) return false;
  }
  return true;
}

/// With what observations are corrected; see correct_truncation.
struct Means {
  const MeasuredUnits& units;
  const EstimateOptions& options;
  const ReplaySet& replay;
  const StageDone& done;
};

class Correction {
 public:
  /// From the parameters of `begin` on; what the correction does is shown beside `raw`.
  Correction(std::span<const ObservationSet> measured, const Estimate& raw, const Estimate& begin,
             const Means& means)
      : measured_(measured),
        raw_(raw),
        units_(means.units),
        options_(means.options),
        motions_(measured, means.replay, means.options.threads),
        done_(means.done),
        estimate_(begin),
        place_(begin.parameter_values),
        next_(place_) {
    quick_.keep_weights = !options_.refine;
  }

  TruncationCorrection run() {
    go_around();
    next_ = found(estimate_);
    at_ = correct(true);
    place_ = next_;
    try {
      replay();
    } catch (const NumericalFailure&) {  // there is a balance, and later perhaps a replay
    }
    choose_null_space();
    sd_ = estimate_.parameter_sd;
    axes_ = axes_beside(null_space_, sd_);
    see_slopes();
    follow_slopes();
    std::vector<ObservationSet> replays = motions_.replays();
    if (!stay_with(measured_, replays))
      throw NumericalFailure(Ending::out_of_range,
                             "motions that begin as measured go elsewhere within the time of an observation");
    full_.start = estimate_.state;
    const Eigen::VectorXd further = values(found(estimate_));  // not next_: a step may have been cut
    estimate_ = estimate(at_.corrected, units_, options_, full_);
    estimate_ = with_correction_shown(std::move(estimate_), raw_);
    estimate_ = with_unsettled_correction(std::move(estimate_), values(place_), further);
    if (unknown_in_null_space_ + unknown_axes_ > 0)
      estimate_.warnings.emplace_back(
          "the correction for the expansion's truncation depends on parameters that are not well known, and "
          "motions with other values of them grow beyond bounds: error bars do not contain that");
    done_(regression);
    return {
        std::move(estimate_), {measured_.begin(), measured_.end()}, std::move(at_.corrected), std::move(replays)};
  }

 private:
  struct Pass {
    Eigen::VectorXd parameters;
    std::vector<ObservationSet> corrected;
    bool replayed = false;
  };

  // A place is the values of all symbols, then how far beyond them along each null-space direction: lumps tell the
  // first, what the truncation does to them the second.
  Eigen::VectorXd values(const Eigen::VectorXd& place) const { return place.head(raw_.parameter_values.size()); }
  Eigen::VectorXd null_coordinate(const Eigen::VectorXd& place) const { return place.tail(null_space_.cols()); }
  Eigen::VectorXd parameters(const Eigen::VectorXd& place) const {
    if (null_space_.cols() == 0) return place;
    return seen_.returned(values(place) + null_space_ * null_coordinate(place), values(place), null_space_);
  }
  Eigen::VectorXd found(const Estimate& by) const {
    Eigen::VectorXd place = Eigen::VectorXd::Zero(by.parameter_values.size() + null_space_.cols());
    place.head(by.parameter_values.size()) = by.parameter_values;
    place.tail(by.null_coordinate.size()) = by.null_coordinate;
    return place;
  }

  // At next_, or on the way back to place_ where that is very far, and at the first on that way where there are
  // motions.
  Pass correct(bool may_return) {
    if (null_space_.cols() > 0) {
      const double far = null_coordinate(next_ - place_).cwiseAbs().maxCoeff();
      if (far > longest_step) next_ = place_ + longest_step / far * (next_ - place_);
    }
    for (int step = 0;; ++step) {
      const Eigen::VectorXd at = parameters(next_);
      const bool last = !may_return || step == most_returns;
      try {
        if (const auto motions = motions_.at(at))
          if (Pass pass = corrected_by(*motions, at); is_finite(pass)) return pass;
      } catch (const NumericalFailure&) {
        if (last) throw;
      }
      if (last)
        throw NumericalFailure(Ending::out_of_range,
                               "the correction for the truncation: harmonics of a measured motion are not found by "
                               "the full equations");
      next_ = 0.5 * (next_ + place_);
    }
  }

  Pass corrected_by(const std::vector<ObservationSet>& motions, const Eigen::VectorXd& at) const {
    Pass pass{at, with_truncation(measured_, motions, at, options_.threads)};
    if (!at_.corrected.empty()) keep_truncation_change(pass.corrected, at_.corrected);
    return pass;
  }

  static bool is_finite(const Pass& pass) {
    return std::all_of(pass.corrected.begin(), pass.corrected.end(),
                       [](const ObservationSet& set) { return set.truncation.allFinite(); });
  }

  void replay() {
    motions_.replay(at_.parameters);
    next_ = place_;
    at_ = correct(false);
    at_.replayed = true;
    done_(full_equations);
  }

  // In standard deviations.
  double size_of_values(const Eigen::VectorXd& step, const Estimate& by) const {
    return inverse_sd(by).cwiseProduct(values(step)).cwiseAbs().maxCoeff();
  }
  double size_of(const Eigen::VectorXd& step, const Estimate& by) const {
    const double of_values = size_of_values(step, by);
    if (null_space_.cols() == 0 || by.null_coordinate_sd.size() != null_space_.cols()) return of_values;
    return std::max(of_values, null_coordinate(step).cwiseQuotient(by.null_coordinate_sd).cwiseAbs().maxCoeff());
  }
  // The same along null-space directions in units of what is plausible.
  double way_of(const Eigen::VectorXd& step, const Estimate& by) const {
    const double of_values = size_of_values(step, by);
    return null_space_.cols() > 0 ? std::max(of_values, null_coordinate(step).cwiseAbs().maxCoeff()) : of_values;
  }
  double move() const { return size_of(next_ - place_, estimate_); }

  void go_around() {
    AndersonAcceleration acceleration(remembered_passes, dependent_passes);
    for (int pass = 1; pass <= most_plain_passes; ++pass) {
      at_ = correct(pass > 1);
      place_ = next_;
      if (pass == null_space_pass) {
        choose_null_space();
        see_null_space();
        // With the null space as an unknown it is another map: what was learnt of the first says nothing of it.
        acceleration = AndersonAcceleration(remembered_passes, dependent_passes);
      }
      done_(full_equations);
      quick_.start = estimate_.state;
      estimate_ = estimate(at_.corrected, units_, options_, quick_);
      next_ << acceleration.next(values(place_), estimate_.parameter_values, inverse_sd(estimate_)),
          null_coordinate(place_);
      done_(regression);
      if (pass >= null_space_pass && way_of(next_ - place_, estimate_) < near) return;
    }
  }

  void take_place(const Eigen::VectorXd& place, EstimatePass& pass) const {
    pass.corrected_at = values(place);
    pass.null_space_place = {null_coordinate(place), -null_space_coordinate_ * values(place)};
  }

  // The null space of the parameters, and how much of it is plausible: as much as they are seen to do, which
  // may have been far off before the correction.
  void choose_null_space() {
    const Eigen::VectorXd beyond = at_.parameters - values(place_), own = values(place_);
    null_space_ = estimate_.null_space;
    null_space_coordinate_ = estimate_.null_space_coordinate;
    seen_ = IdentifiedLumps(estimate_);
    place_.resize(own.size() + null_space_.cols());
    place_ << own, estimate_.null_space_coordinate * beyond;
    next_ = place_;
    take_place(place_, quick_);
    // What is along none of these directions now is not beyond the values any longer.
    if (parameters(place_) != at_.parameters) at_ = correct(false);
  }

  // How the correction depends on it.
  void see_null_space() {
    const Displaced displaced = [&](Eigen::Index direction, double share) {
      Eigen::VectorXd place = place_;
      place(values(place_).size() + direction) += share;
      return parameters(place);
    };
    const Slopes slopes = slopes_along(null_space_.cols(), displaced, at_.corrected, motions_, options_.threads);
    unknown_in_null_space_ = slopes.unknown;
    for (std::size_t s = 0; s < at_.corrected.size(); ++s) {
      at_.corrected[s].truncation_change.clear();
      for (const auto& change : slopes.change) at_.corrected[s].truncation_change.push_back(change[s]);
    }
  }

  // The same of what lumps tell, too. Null-space directions are unknowns of their own
  // (SharedParameters::null_coordinate), along which nothing is said here. Axes stay as they are, so that a fit
  // that holds slopes, and knows less along some of them, does not lead too far away.
  void see_slopes() {
    see_null_space_beside_axes();
    const Displaced displaced = [&](Eigen::Index axis, double share) {
      return Eigen::VectorXd(parameters(place_) + share * axes_.col(axis));
    };
    const Slopes slopes = slopes_along(axes_.cols(), displaced, at_.corrected, motions_, options_.threads);
    unknown_axes_ = slopes.unknown;
    for (std::size_t s = 0; s < at_.corrected.size(); ++s) {
      ObservationSet& set = at_.corrected[s];
      set.truncation_of_moves.clear();
      for (const auto& change : slopes.change) set.truncation_of_moves.push_back(change[s]);
      set.truncation_of_moves.resize(static_cast<std::size_t>(quick_.moves.cols()),
                                     Eigen::MatrixXcd::Zero(set.truncation.rows(), set.truncation.cols()));
    }
    axes_seen_at_ = place_;
    ++times_seen_;
    done_(full_equations);
  }

  void see_null_space_beside_axes() {
    see_null_space();
    quick_.moves.resize(axes_.rows(), axes_.cols() + null_space_.cols());
    quick_.moves << axes_, null_space_;
    full_.moves = quick_.moves;
    seen_at_ = place_;
  }

  // Where what lumps tell has hardly moved, at first only along what they do not: there corrections bend most, and
  // directions are few.
  bool see_slopes_again() {
    if (place_ == axes_seen_at_) return false;
    const bool everything = place_ == seen_at_ || size_of_values(place_ - axes_seen_at_, estimate_) > near_axes;
    if (everything ? times_seen_ == most_slopes : times_null_space_seen_ == most_slopes) return false;
    const Eigen::Index directions = null_space_.cols();
    choose_null_space();
    if (everything || null_space_.cols() != directions) {
      see_slopes();
    } else {
      see_null_space_beside_axes();
      ++times_null_space_seen_;
      done_(full_equations);
    }
    estimate_here();
    return true;
  }

  // Newton's method for the place that fits the lumps corrected there, from the sets corrected at place_ on. A step
  // is halved unless what is left to go from its end, by the same weights and slopes and in the same measure, is
  // less than it was (P. Deuflhard, Newton Methods for Nonlinear Problems, 2011, section 3.3: the natural
  // monotonicity test). Slopes are seen again where they lead no further, and where it ends far from where they
  // were seen.
  void follow_slopes() {
    quick_.start = estimate_.state;
    // Weights of the first estimates took what the expansion leaves for noise.
    const bool kept = std::exchange(quick_.keep_weights, false);
    estimate_here();
    quick_.keep_weights = kept;
    quick_.start = estimate_.state;
    int halvings = 0;
    for (int pass = most_plain_passes; pass < most_passes && halvings <= most_halvings; ++pass) {
      if (move() < motion_thresholds().settled_share) {
        if (!at_.replayed) {
          replay();
          estimate_here();
          continue;
        }
        const bool settled = halvings == 0 && way_of(place_ - seen_at_, estimate_) < local;
        if (settled || !see_slopes_again()) break;
        continue;
      }
      Pass further = correct(true);
      done_(full_equations);
      const Estimate there = estimate_corrected(further.corrected, next_);
      const double before = size_of(found(estimate_) - place_, estimate_);
      const double left = size_of(found(there) - next_, estimate_);
      if (left < before) {
        at_ = std::move(further);
        place_ = next_;
        if (pass < last_weights) quick_.start = there.state;
        estimate_here();
        if (halvings == 0 && left > slow * before) see_slopes_again();
        halvings = 0;
      } else if (!see_slopes_again()) {
        ++halvings;
        next_ = 0.5 * (next_ + place_);
      }
    }
    if (!at_.replayed) {
      replay();
      estimate_here();
    }
    take_place(place_, full_);
  }

  void estimate_here() {
    estimate_ = estimate_corrected(at_.corrected, place_);
    next_ = found(estimate_);
  }

  Estimate estimate_corrected(const std::vector<ObservationSet>& corrected, const Eigen::VectorXd& at) {
    take_place(at, quick_);
    Estimate result = estimate(corrected, units_, options_, quick_);
    done_(regression);
    if (!(growth(result, sd_) < motion_thresholds().most_growth))
      throw NumericalFailure(
          Ending::stalled,
          "the correction for the truncation: depends so much on the numbers that it is made for "
          "that neither is determined");
    return result;
  }

  std::span<const ObservationSet> measured_;
  const Estimate& raw_;
  const MeasuredUnits& units_;
  const EstimateOptions& options_;
  EstimatePass quick_ = pass_between(), full_;
  FullMotions motions_;
  const StageDone& done_;
  Pass at_;
  Estimate estimate_;             // from at_
  Eigen::VectorXd place_, next_;  // of at_, and where to go from there
  Eigen::VectorXd sd_;            // before any slopes
  Eigen::MatrixXd null_space_, null_space_coordinate_, axes_;
  IdentifiedLumps seen_;
  Eigen::VectorXd seen_at_, axes_seen_at_;  // places of the latest slopes, and of the latest along the axes
  int times_seen_ = 0, times_null_space_seen_ = 0, unknown_in_null_space_ = 0, unknown_axes_ = 0;
};

// Observations whose modes move no more than this share of what they do at most.
std::vector<ObservationSet> small_motions(std::span<const ObservationSet> measured, double share) {
  std::vector<ObservationSet> small(measured.begin(), measured.end());
  for (ObservationSet& set : small) {
    std::vector<double> most(set.model->modes(), 0.0);
    for (const Observation& o : set.observations)
      for (std::size_t k = 0; k < most.size(); ++k) most[k] = std::max(most[k], std::abs(o.amplitude[k]));
    std::erase_if(set.observations, [&](const Observation& o) {
      for (std::size_t k = 0; k < most.size(); ++k)
        if (std::abs(o.amplitude[k]) > share * most[k]) return true;
      return false;
    });
  }
  return small;
}

std::size_t count_of_observations(std::span<const ObservationSet> sets) {
  std::size_t count = 0;
  for (const ObservationSet& set : sets) count += set.observations.size();
  return count;
}

}  // namespace

TruncationCorrection correct_truncation(std::span<const ObservationSet> measured, const Estimate& raw,
                                        const MeasuredUnits& units, const EstimateOptions& options,
                                        const ReplaySet& replay, const StageDone& done) {
  const Means means{units, options, replay, done};
  try {
    return Correction(measured, raw, raw, means).run();
  } catch (const NumericalFailure& beyond_bounds) {
    const std::string reason = beyond_bounds.what();
    const std::size_t all = count_of_observations(measured);
    for (const double share : small_shares) {
      const std::vector<ObservationSet> small = small_motions(measured, share);
      const std::size_t left_out = all - count_of_observations(small);
      if (2 * left_out > all) break;  // it is the model that does not hold
      std::optional<TruncationCorrection> of_small;
      try {
        const Estimate first = estimate(small, units, options, pass_between());
        of_small = Correction(small, first, first, means).run();
        return Correction(measured, raw, of_small->estimate, means).run();
      } catch (const NumericalFailure&) {
        if (!of_small) continue;
        of_small->estimate.warnings.push_back(fmt::format(
            "{} of {} observations, which move more than {:.0f} % of the largest one, are left out: the full "
            "equations do not make them ({})",
            left_out, all, 100 * share, reason));
        return std::move(*of_small);
      }
    }
    throw;
  }
}

}  // namespace secular
