#include "diagnose/inference/inference.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "diagnose/inference/screening.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Nonlinear fits: at most so many candidates, and only those whose gain is this share of the best.
constexpr std::size_t most_fits = 16;
constexpr auto& least_gain_share = diagnose_thresholds().least_gain_share;

/// Among the true errors a gain of less than this (two standard deviations) is chance. Among wider ones no gain is
/// too small.
constexpr auto& least_gain = diagnose_thresholds().least_gain;

/// Shares of the inertia to which the equations of motion count as known, one after the other.
constexpr double coarse_levels[] = {1e-2, 1e-3, 1e-4, 0};
constexpr std::size_t finest = std::size(coarse_levels) - 1;

/// Rows that a model misses by more than this, mean square in variances, are no place to look for what it lacks:
/// its numbers are bent by then.
constexpr auto& most_residual = diagnose_thresholds().most_residual;

/// Coarse equations help where they bring what the model leaves down to less than this share.
constexpr auto& least_relief = diagnose_thresholds().least_relief;

/// Errors taken anew at a fit that was made among others change what it leaves beyond noise by no more than this
/// factor, or that fit has run away with its own errors.
constexpr auto& reweighting = diagnose_thresholds().reweighting;

/// A fit along a curved valley takes so many times the steps of others (tuned: of three steps there, two are
/// refused and only set the length of the third).
constexpr int longer_in_valleys = 4;

/// Of fits with numbers that may be far off, relative to the squared length of a column.
constexpr auto& first_damping = diagnose_thresholds().first_damping;

/// Pairs: partners for so many of the best single explanations, and so many partners each.
constexpr std::size_t most_firsts = 3, most_partners = 6;
constexpr int most_exchanges = 3;

/// Where every explanation misses, so many effects are fitted again from the start.
constexpr std::size_t most_afresh = 8;

/// Of the first single effects, so many are.
constexpr std::size_t most_first_afresh = 2;

/// A second effect is looked for where the best single one leaves so many standard deviations of chi-squared.
constexpr auto& least_structure = diagnose_thresholds().least_structure;

/// Errors of a fit are taken anew so often at each level; among the true ones of a model that leaves no more than
/// noise, until that changes less than chance does, and at most as often as this: each time with what the last fit
/// left of states and noise, which comes to rest slowly where these are large.
constexpr int usual_rounds = 6, most_rounds = 24;

// The strengths and shapes of one candidate from one vector of unknowns put into another.
void take_over(VectorXd& into, const VectorXd& from, const Candidate& c) {
  for (const std::size_t u : c.strengths) into(static_cast<Index>(u)) = from(static_cast<Index>(u));
  for (const std::size_t u : c.shapes) into(static_cast<Index>(u)) = from(static_cast<Index>(u));
}

bool is_possible(const Explanation& e, const std::vector<Candidate>& candidates) {
  return std::none_of(e.members.begin(), e.members.end(), [&](std::size_t m) {
    const Candidate& c = candidates[m];
    return (c.passive && e.fit.unknowns(static_cast<Index>(c.strengths[0])) < 0) ||
           (c.plausible && !c.plausible(e.fit.unknowns));
  });
}

// Of explanations by the same effect at the same place only the best stays.
void keep_best_of_each(std::vector<Explanation>& all, const std::vector<Candidate>& candidates) {
  std::stable_sort(all.begin(), all.end(), [](const Explanation& a, const Explanation& b) {
    return a.fit.chi_squared < b.fit.chi_squared;
  });
  std::set<std::vector<std::string>> taken;
  std::vector<Explanation> kept;
  for (Explanation& e : all) {
    if (!is_possible(e, candidates)) continue;
    std::vector<std::string> name;
    for (const std::size_t m : e.members) name.push_back(candidates[m].effect + "\n" + candidates[m].subject);
    std::sort(name.begin(), name.end());
    if (!taken.insert(std::move(name)).second) continue;
    kept.push_back(std::move(e));
  }
  all = std::move(kept);
}

// The search of infer(): the model as it is, single candidates, pairs; from coarse equations to fine ones.
class Search {
 public:
  Search(Discrepancy& discrepancy, const std::vector<Candidate>& candidates, const std::vector<std::size_t>& own,
         const InferenceOptions& options, Index unknowns)
      : discrepancy_(discrepancy),
        candidates_(candidates),
        all_own_(own),
        own_(own),
        options_(options),
        price_(0.5 * std::log(std::max(2.0, rows()))),
        scales_(unknowns) {}

  Inference run(const VectorXd& start) {
    fit_null(start);
    fit_singles();
    if (found_.empty() && level_ != finest) {
      settle_null(result_.null);
      fit_singles();
    }
    if (!begin_afresh(start)) descend();
    add_pairs();
    if (start_afresh(start)) add_pairs();
    settle();
    weigh();
    if (options_.progress) options_.progress(fitted_, fitted_);
    return std::move(result_);
  }

 private:
  // Errors and starting points of the rows, taken at these unknowns.
  struct Frozen {
    VectorXd at;
    double coarse = 0;
  };

  void freeze(const VectorXd& at, double coarse = 0, Lookout lookout = Lookout::anywhere) {
    frozen_ = {at, coarse};
    discrepancy_.freeze(at, coarse, lookout);
  }

  double rows() const { return static_cast<double>(discrepancy_.freedom()); }  // that are independent

  RefitOptions refit_options(unsigned threads = 1) const {
    RefitOptions options;
    options.threads = threads;
    options.scale_guess = scales_.all();
    return options;
  }

  Refit refit_own(const VectorXd& from, double damping = 0) { return refit_these(from, own_, damping); }

  Refit refit_these(const VectorXd& from, const std::vector<std::size_t>& free, double damping) {
    RefitOptions options = refit_options(options_.threads);
    options.damping = damping;
    Refit fit = refit(discrepancy_, from, free, options);
    scales_.remember(free, fit.scale);
    return fit;
  }

  // A fit among errors of one level, and how many rows count there.
  struct LevelFit {
    Refit fit;
    double rows = 0;
  };

  // Errors of the rows depend on the unknowns, and a start far off has none that mean anything: one fit for each of
  // coarse_levels, every one from where the last ended. Among wider errors a fit leaves less: none that is finer
  // follows one that leaves more than `most`.
  std::vector<LevelFit> from_coarse_to_fine(const VectorXd& start, const std::vector<std::size_t>& free,
                                            double most = std::numeric_limits<double>::infinity()) {
    VectorXd unknowns = start;
    std::vector<LevelFit> fits;
    for (const double coarse : coarse_levels) {
      Refit fit;
      double before = std::numeric_limits<double>::infinity();
      for (int round = 0; round < most_rounds; ++round) {
        freeze(unknowns, coarse, round > 0 ? Lookout::close_by : Lookout::anywhere);
        Refit next = refit_these(unknowns, free, coarse > 0 ? first_damping : 0);
        if (next.chi_squared > reweighting * std::max(before, rows())) break;
        fit = std::move(next);
        unknowns = fit.unknowns;
        const bool holds = coarse == 0 && is_within_noise(fit.chi_squared, rows());
        const double change = std::abs(fit.chi_squared - before);
        if (round > 0 && change < (holds ? least_gain : 0.02 * before + 1)) break;
        if (round + 1 >= usual_rounds && !holds) break;
        before = fit.chi_squared;
      }
      fits.push_back({std::move(fit), rows()});
      if (!discrepancy_.measures_errors() && fits.back().fit.chi_squared > reweighting * most) break;
    }
    return fits;
  }

  static bool misses(const LevelFit& level) { return level.fit.chi_squared > most_residual * level.rows; }
  bool misses(const Refit& fit) const { return fit.chi_squared > most_residual * rows(); }

  double dispersion_of(const Explanation& e) const {
    return e.fit.chi_squared / std::max(1.0, rows() - static_cast<double>(e.fit.rank));
  }

  bool is_open(const Explanation& e) const {
    return std::any_of(e.members.begin(), e.members.end(), [&](std::size_t m) { return candidates_[m].open_law; });
  }

  // Among the errors as they are.
  double left_by(const Explanation& e) const { return discrepancy_(e.fit.unknowns).squaredNorm(); }

  static double most_of_noise(double freedom) { return freedom + least_structure * std::sqrt(2 * freedom); }
  static bool is_within_noise(double chi_squared, double freedom) { return chi_squared <= most_of_noise(freedom); }

  // Of the rows that count at the errors as they are.
  double freedom_about_null() const { return rows() - static_cast<double>(result_.null.fit.rank); }

  // Of a fit to the errors as they are.
  bool leaves_more_than_noise(const Explanation& e) const {
    return !is_within_noise(e.fit.chi_squared, freedom_about_null());
  }

  // Of a model that is far from the data a fine fit would be bent beyond all sense; what it lacks is looked for
  // first, among errors that it can live with.
  void fit_null(const VectorXd& start) {
    std::vector<LevelFit> nulls = from_coarse_to_fine(start, own_);
    level_ = nulls.size() - 1;
    // What the equations of motion have no part in (a harmonic of the excitation that the model leaves out) is
    // missed at every level alike.
    const bool in_equations = nulls.front().fit.chi_squared < least_relief * nulls.back().fit.chi_squared;
    if (misses(nulls[level_]) && in_equations) {
      while (level_ > 0 && misses(nulls[level_])) --level_;
      Refit& fit = nulls[level_].fit;
      if (misses(nulls[level_]))
        fit = anchored_null(start);
      else {
        freeze(fit.unknowns, coarse_levels[level_]);
        fit = refit_own(fit.unknowns);
      }
    }
    result_.null.fit = std::move(nulls[level_].fit);
    result_.degrees_of_freedom = freedom_about_null();
    null_holds_ = level_ == finest && !discrepancy_.admits_own() && !leaves_more_than_noise(result_.null);
  }

  // A model that misses even coarse equations fits best with natural frequencies that nobody would believe, and
  // nothing that is added there leads back: it stays near its start, and the rest of its numbers, which enter the
  // equations linearly, are all that moves.
  Refit anchored_null(const VectorXd& start) {
    std::erase_if(own_, [&](std::size_t u) {
      return std::find(options_.anchors.begin(), options_.anchors.end(), u) != options_.anchors.end();
    });
    freeze(start, coarse_levels[level_]);
    const Refit first = refit_own(start, first_damping);
    freeze(first.unknowns, coarse_levels[level_]);
    return refit_own(first.unknowns, first_damping);
  }

  void release_anchors() {
    own_ = all_own_;
    for (Explanation& e : found_) e.fit.free = free_of(e.members);
    freeze(found_.front().fit.unknowns, coarse_levels[level_]);
    refit_found();
  }

  std::vector<std::size_t> promising(const std::vector<Screening>& screened, std::size_t most) const {
    std::vector<std::size_t> order(candidates_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return screened[a].gain > screened[b].gain; });
    const double best = order.empty() ? 0 : screened[order.front()].gain,
                 least = frozen_.coarse > 0 ? 0 : least_gain;
    std::vector<std::size_t> kept;
    for (const std::size_t c : order)
      if (kept.size() < most && screened[c].gain > std::max(least, least_gain_share * best)) kept.push_back(c);
    return kept;
  }

  std::vector<Screening> screen_from(const Refit& base) {
    return screen_all(discrepancy_, base, candidates_, scales_, options_.threads);
  }

  // Beside another effect.
  std::vector<Screening> screen_partners(const Refit& base) {
    std::vector<Screening> found = screen_from(base);
    for (std::size_t c = 0; c < candidates_.size(); ++c)
      if (candidates_[c].open_law) found[c].gain = 0;
    return found;
  }

  void take_gains(const std::vector<Screening>& screened) {
    result_.linear_gain.clear();
    result_.gain_of_records.clear();
    for (const Screening& s : screened) {
      result_.linear_gain.push_back(s.gain);
      result_.gain_of_records.push_back(s.of_records);
    }
  }

  void fit_singles() {
    singles_ = screen_from(result_.null.fit);
    take_gains(singles_);
    const std::vector<std::size_t> chosen = promising(singles_, most_fits);
    found_.resize(chosen.size());
    expected_ = fitted_ + chosen.size();
    in_parallel(chosen.size(), options_.threads,
                [&](std::size_t i) { found_[i] = explain({chosen[i]}, singles_[chosen[i]].start); });
    keep_best_of_each(found_, candidates_);
  }

  Explanation explanation(std::vector<std::size_t> members, Refit fit) const {
    Explanation e;
    for (const std::size_t m : members)
      e.unknowns += candidates_[m].strengths.size() + candidates_[m].shapes.size();
    e.fit = std::move(fit);
    e.members = std::move(members);
    return e;
  }

  Explanation explain(const std::vector<std::size_t>& members, const VectorXd& start) {
    Explanation fitted = explanation(members, refit(discrepancy_, start, free_of(members), refit_options()));
    const std::size_t done = ++fitted_;
    if (options_.progress) options_.progress(done, std::max(done + 1, expected_));
    return fitted;
  }

  // A strength that another member or the model frees already counts once.
  std::vector<std::size_t> free_of(const std::vector<std::size_t>& members) const {
    std::set<std::size_t> free(own_.begin(), own_.end());
    for (const std::size_t m : members) {
      free.insert(candidates_[m].strengths.begin(), candidates_[m].strengths.end());
      free.insert(candidates_[m].shapes.begin(), candidates_[m].shapes.end());
    }
    return {free.begin(), free.end()};
  }

  // Down to the errors of the measurement with the explanations; with two effects as soon as one is not enough.
  void descend() {
    bool paired = false;
    if (own_.size() < all_own_.size()) {
      paired = !found_.empty() && misses(found_.front().fit);
      if (paired) add_pairs();
      if (!found_.empty()) release_anchors();
    }
    for (; level_ < finest && !found_.empty(); ++level_) {
      Explanation& best = found_.front();
      freeze(best.fit.unknowns, coarse_levels[level_ + 1]);
      Refit finer = refit(discrepancy_, best.fit.unknowns, best.fit.free, refit_options(options_.threads));
      if (misses(finer) && !paired) {
        freeze(best.fit.unknowns, coarse_levels[level_]);
        add_pairs();
        paired = true;
        freeze(found_.front().fit.unknowns, coarse_levels[level_ + 1]);
      } else {
        best.fit = std::move(finer);
      }
      refit_found();
    }
  }

  void refit_found() {
    in_parallel(found_.size(), options_.threads, [&](std::size_t i) {
      found_[i].fit = refit(discrepancy_, found_[i].fit.unknowns, found_[i].fit.free, refit_options());
    });
    keep_best_of_each(found_, candidates_);
  }

  // Pairs that are being looked for, and what was tried already.
  struct Pairs {
    std::vector<Explanation> found;
    std::set<std::pair<std::size_t, std::size_t>> tried;
    std::set<std::size_t> expanded;
  };

  // Partners of one single explanation; `seconds`: how candidates screen beside it.
  void expand(const Explanation& single, std::vector<Screening> seconds, Pairs& pairs) {
    const std::size_t first = single.members.front();
    pairs.expanded.insert(first);
    // One effect at one place in two shapes is still that effect.
    for (std::size_t c = 0; c < candidates_.size(); ++c)
      if (candidates_[c].effect == candidates_[first].effect &&
          candidates_[c].subject == candidates_[first].subject)
        seconds[c].gain = 0;
    std::vector<std::size_t> partners;
    for (const std::size_t second : promising(seconds, most_partners))
      if (pairs.tried.insert(std::minmax(first, second)).second) partners.push_back(second);
    std::vector<Explanation> fresh(partners.size());
    in_parallel(partners.size(), options_.threads, [&](std::size_t i) {
      VectorXd begin = single.fit.unknowns;
      take_over(begin, seconds[partners[i]].start, candidates_[partners[i]]);
      fresh[i] = explain({first, partners[i]}, begin);
    });
    for (Explanation& e : fresh) pairs.found.push_back(std::move(e));
  }

  // A second effect only where the best single one leaves more than noise, or where one stands out that would be
  // worth its unknown and its prior odds: among many rows that fit, a few that do not are no excess of all.
  void add_pairs() {
    std::vector<Explanation> alone;
    for (const Explanation& e : found_)
      if (e.members.size() == 1 && !is_open(e)) alone.push_back(e);
    if (alone.empty()) return;
    const std::size_t best_alone = alone.front().members.front();
    std::vector<Screening> beside_best = screen_partners(alone.front().fit);
    beside_best[best_alone].gain = 0;
    const auto most = std::max_element(beside_best.begin(), beside_best.end(),
                                       [](const Screening& a, const Screening& b) { return a.gain < b.gain; });
    const double worth =
        2 * (price_ - std::log(options_.prior_second)) * std::max(1.0, dispersion_of(alone.front()));
    const bool at_true_errors = frozen_.coarse == 0;
    if (at_true_errors && !leaves_more_than_noise(alone.front()) && !(most->gain > worth)) return;
    expected_ = fitted_ + most_firsts * most_partners;
    Pairs pairs;
    expand(alone.front(), std::move(beside_best), pairs);
    for (std::size_t f = 1; f < std::min(most_firsts, alone.size()); ++f)
      if (pairs.expanded.count(alone[f].members.front()) == 0)
        expand(alone[f], screen_partners(alone[f].fit), pairs);
    exchange_members(pairs);
    keep_best_of_each(pairs.found, candidates_);
    try_members_alone(pairs.found);
    for (Explanation& e : pairs.found) found_.push_back(std::move(e));
    keep_best_of_each(found_, candidates_);
  }

  // The two that act together need not be the best alone: partners of both members of the best pair, until it
  // stays.
  void exchange_members(Pairs& pairs) {
    for (int round = 0; round < most_exchanges && !pairs.found.empty(); ++round) {
      keep_best_of_each(pairs.found, candidates_);
      const std::vector<std::size_t> best = pairs.found.front().members;
      bool moved = false;
      for (const std::size_t member : best) {
        if (pairs.expanded.count(member) > 0) continue;
        moved = true;
        const VectorXd& start = singles_[member].start;
        const Explanation single = explain({member}, start.size() > 0 ? start : result_.null.fit.unknowns);
        expand(single, screen_partners(single.fit), pairs);
      }
      if (!moved) break;
    }
  }

  // Members of the best pairs alone, from the pair's numbers: on its own way from the null one may have stopped
  // short.
  void try_members_alone(const std::vector<Explanation>& pairs) {
    std::set<std::size_t> again;
    for (std::size_t d = 0; d < std::min(most_firsts, pairs.size()); ++d)
      for (std::size_t m = 0; m < 2; ++m) {
        const std::size_t member = pairs[d].members[m], other = pairs[d].members[1 - m];
        if (!again.insert(member).second) continue;
        found_.push_back(explain({member}, switched_off(pairs[d].fit.unknowns, {other}, candidates_)));
      }
  }

  // One effect on its own way from the start, its strength and shape as in `like`; nothing where it leaves more
  // than `most` on the way.
  std::optional<Explanation> afresh(std::size_t member, const VectorXd& start, const VectorXd& like, double most) {
    VectorXd begin = start;
    take_over(begin, like, candidates_[member]);
    std::vector<LevelFit> fits = from_coarse_to_fine(begin, free_of({member}), most);
    if (fits.size() < std::size(coarse_levels)) return std::nullopt;
    return explanation({member}, std::move(fits.back().fit));
  }

  // The model's own numbers may follow what is missing to where no step leads back, and whatever is tried beside
  // them there is bent as well. If the first few effects leave more than noise there, and one of them on its own
  // way from the start does not, that one is the best, and the rest is judged beside it.
  bool begin_afresh(const VectorXd& start) {
    if (found_.empty() || !leaves_more_than_noise(found_.front())) return false;
    const Frozen here = frozen_;
    const KnownScales scales = scales_;
    const std::vector<std::size_t> own = std::exchange(own_, all_own_);
    for (std::size_t f = 0; f < std::min(most_first_afresh, found_.size()); ++f) {
      if (is_open(found_[f])) continue;
      std::optional<Explanation> again = afresh(found_[f].members.front(), start, found_[f].fit.unknowns,
                                                most_of_noise(result_.degrees_of_freedom));
      if (!again || leaves_more_than_noise(*again) || !is_possible(*again, candidates_)) continue;
      freeze(again->fit.unknowns);
      if (left_by(found_.front()) <= left_by(*again)) continue;  // it has run away with its own errors
      level_ = finest;
      const VectorXd without = switched_off(again->fit.unknowns, again->members, candidates_);
      for (Explanation& e : found_) {
        VectorXd begin = without;
        take_over(begin, e.fit.unknowns, candidates_[e.members.front()]);
        e.fit.unknowns = std::move(begin);
        e.fit.free = free_of(e.members);
      }
      found_[f] = std::move(*again);
      refit_found();
      return true;
    }
    freeze(here.at, here.coarse);
    scales_ = scales;
    own_ = own;
    return false;
  }

  // Where even the best explanation leaves more than noise, the model's own numbers may have followed what was
  // missing to where no step leads back: the best effects once more, each on its own way from the start. Whether
  // one of them is the best now.
  bool start_afresh(const VectorXd& start) {
    if (found_.empty() || !leaves_more_than_noise(found_.front())) return false;
    const std::size_t most = misses(found_.front().fit) ? most_afresh : most_firsts;
    double most_left = found_.front().fit.chi_squared;
    std::set<std::pair<std::string, std::string>> taken;
    std::vector<Explanation> fresh;
    for (const Explanation& e : found_)
      for (const std::size_t m : e.members) {
        if (taken.size() == most || !taken.emplace(candidates_[m].effect, candidates_[m].subject).second) continue;
        std::optional<Explanation> again = afresh(m, start, e.fit.unknowns, most_left);
        if (!again) continue;
        most_left = std::min(most_left, again->fit.chi_squared);
        fresh.push_back(std::move(*again));
      }
    // Every one among its own errors; the better one must be better among those of its own as well.
    const Explanation* best = &found_.front();
    freeze(best->fit.unknowns);
    double least = left_by(*best);
    for (const Explanation& e : fresh) {
      freeze(e.fit.unknowns);
      const double left = left_by(e);
      if (!(left < least) || !(left < left_by(*best)) || !is_possible(e, candidates_)) continue;
      best = &e;
      least = left;
    }
    freeze(best->fit.unknowns);
    if (best == &found_.front()) return false;
    found_.insert(found_.end(), std::make_move_iterator(fresh.begin()), std::make_move_iterator(fresh.end()));
    refit_found();
    return true;
  }

  // The model as it is among the errors of the measurement at this explanation, from where it was and from there.
  void settle_null(Explanation best) {
    own_ = all_own_;
    level_ = finest;
    freeze(best.fit.unknowns);
    Refit& null = result_.null.fit;
    null = refit_own(null.unknowns);
    Refit from_best = refit_own(switched_off(best.fit.unknowns, best.members, candidates_));
    if (from_best.chi_squared < null.chi_squared) null = std::move(from_best);
    result_.degrees_of_freedom = rows() - static_cast<double>(null.rank);
  }

  // Fits that have not come to an end, though nothing of the catalogue that has is better by what an unknown costs:
  // a law whose shape trades with its strength and the model's own numbers ends in a curved valley. (A power of any
  // exponent comes near to it before, and would be called a law that the catalogue lacks.)
  void end_stalled() {
    const auto has_ended = [](const Explanation& e) { return e.fit.ending == SolverEnding::converged; };
    double least = result_.null.fit.chi_squared;
    for (const Explanation& e : found_)
      if (has_ended(e) && !is_open(e)) least = std::min(least, e.fit.chi_squared);
    const double dispersion = secular::dispersion_of(least, result_.degrees_of_freedom);
    RefitOptions options = refit_options();
    options.bends = true;
    options.iterations *= longer_in_valleys;
    in_parallel(found_.size(), options_.threads, [&](std::size_t i) {
      Refit& fit = found_[i].fit;
      if (!has_ended(found_[i]) && fit.chi_squared < least + 2 * price_ * dispersion)
        fit = refit(discrepancy_, fit.unknowns, fit.free, options);
    });
    keep_best_of_each(found_, candidates_);
  }

  // Coarse errors are a way to walk; what a verdict is read from holds among the true ones.
  void settle() {
    // A model that leaves no more than noise among its own errors needs none of an explanation: by numbers that
    // others make up for it may be far from there. (Not where what records have of their own makes up for it.)
    settle_null(found_.empty() || null_holds_ ? result_.null : found_.front());
    refit_found();
    end_stalled();
    // Where all rows together show no gap, one candidate may still: beside this null.
    if (!leaves_more_than_noise(result_.null)) take_gains(screen_from(result_.null.fit));
  }

  void weigh() {
    double dispersion = dispersion_of(result_.null);
    for (const Explanation& e : found_) dispersion = std::min(dispersion, dispersion_of(e));
    result_.dispersion = std::max(1.0, dispersion);
    const auto weigh_one = [&](Explanation& e) {
      e.log_evidence = -0.5 * e.fit.chi_squared / result_.dispersion - price_ * static_cast<double>(e.unknowns);
      if (e.members.size() > 1) e.log_evidence += std::log(options_.prior_second);
      if (is_open(e)) e.log_evidence += std::log(options_.prior_open_law);
    };
    result_.price = price_;
    weigh_one(result_.null);
    for (Explanation& e : found_) weigh_one(e);
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Explanation& a, const Explanation& b) { return a.log_evidence > b.log_evidence; });
    result_.explanations = std::move(found_);
  }

  Discrepancy& discrepancy_;
  const std::vector<Candidate>& candidates_;
  const std::vector<std::size_t>& all_own_;
  std::vector<std::size_t> own_;  // that are fitted at present
  const InferenceOptions& options_;
  double price_;  // of one unknown more, in log evidence
  KnownScales scales_;
  Frozen frozen_;
  std::size_t level_ = 0;    // index into coarse_levels that the errors are frozen at
  bool null_holds_ = false;  // the model as it is leaves no more than noise among its own true errors
  std::vector<Screening> singles_;
  std::vector<Explanation> found_;
  std::atomic<std::size_t> fitted_ = 0;
  std::size_t expected_ = 0;  // when those at hand are done
  Inference result_;
};

}  // namespace

VectorXd switched_off(VectorXd unknowns, const std::vector<std::size_t>& members,
                      const std::vector<Candidate>& candidates) {
  for (const std::size_t m : members)
    for (const std::size_t u : candidates[m].strengths) unknowns(static_cast<Index>(u)) = 0;
  return unknowns;
}

Inference infer(Discrepancy& discrepancy, const std::vector<Candidate>& candidates, const VectorXd& start,
                const std::vector<std::size_t>& own, const InferenceOptions& options) {
  return Search(discrepancy, candidates, own, options, start.size()).run(start);
}

double expected_separation(const Explanation& truth, const Explanation& rival, const Explanation& null) {
  // Rows are data minus prediction: their difference is that of the predictions.
  const VectorXd signature = null.fit.rows - truth.fit.rows;
  return without_span(basis_of(rival.fit.jacobian), signature).squaredNorm();
}

}  // namespace secular
