#include "diagnose/inference.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>

#include "estimator/in_parallel.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Columns shorter than this after own unknowns are taken out (rows of unit variance, strength of natural scale
/// one) are not seen by the data.
constexpr double unseen = 1e-3;

/// Nonlinear fits: at most so many candidates, and only those whose gain is this share of the best.
constexpr std::size_t most_fits = 16;
constexpr double least_share = 0.02;
constexpr double least_gain = 4;

/// Shares of the inertia to which the equations of motion count as known, one after the other.
constexpr double levels[] = {1e-2, 1e-3, 1e-4, 0};

/// Rows that a model misses by more than this, mean square in variances, are no place to look for what it lacks.
constexpr double most_misfit = 1000;

/// Of fits with numbers that may be far off, relative to the squared length of a column.
constexpr double first_damping = 1e-2;

/// Pairs: partners for so many of the best single explanations, and so many partners each.
constexpr std::size_t most_firsts = 3, most_partners = 6;
constexpr int most_exchanges = 3;

/// A second effect is looked for where the best single one leaves so many standard deviations of chi-squared.
constexpr double least_remainder = 3.5;

// Orthonormal basis of the columns, without directions that are rounding.
MatrixXd basis_of(const MatrixXd& columns) {
  if (columns.cols() == 0) return MatrixXd(columns.rows(), 0);
  const VectorXd length = columns.colwise().norm().transpose();
  const VectorXd unit = length.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
  const Eigen::BDCSVD<MatrixXd> svd(columns * unit.asDiagonal(), Eigen::ComputeThinU);
  Index rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()(rank) > 1e-6 * svd.singularValues()(0)) ++rank;
  return svd.matrixU().leftCols(rank);
}

MatrixXd without(const MatrixXd& basis, const MatrixXd& columns) {
  if (basis.cols() == 0) return columns;
  return columns - basis * (basis.transpose() * columns);
}

// What a candidate explains to first order beside what is fitted already, and where its nonlinear fit should begin.
struct Screening {
  double gain = 0;
  VectorXd start;
};

// By the slopes of its strengths: where these are all that it has.
bool is_plain(const Candidate& candidate) {
  return candidate.shapes.empty() && !(candidate.least_strength > 0);
}

// What strengths with these slopes (per scale) would explain from `unknowns` on.
Screening screen_slopes(const Refit& base, const MatrixXd& basis, const Candidate& candidate, VectorXd unknowns,
                        const MatrixXd& slopes, const VectorXd& scale) {
  const MatrixXd columns = without(basis, slopes);
  const MatrixXd seen = basis_of(columns);
  if (seen.cols() == 0 || columns.norm() < unseen) return {};
  const double gain = (seen.transpose() * base.rows).squaredNorm();
  const VectorXd strength = -columns.completeOrthogonalDecomposition().solve(base.rows);
  for (std::size_t s = 0; s < candidate.strengths.size(); ++s)
    unknowns(static_cast<Index>(candidate.strengths[s])) +=
        scale(static_cast<Index>(s)) * strength(static_cast<Index>(s));
  if (candidate.passive && unknowns(static_cast<Index>(candidate.strengths[0])) < 0) return {};
  return {gain, std::move(unknowns)};
}

// Shape by shape.
Screening screen(const Discrepancy& discrepancy, const Refit& base, const MatrixXd& basis,
                 const Candidate& candidate) {
  Screening best;
  for (const VectorXd& shape : candidate.shape_starts) {
    VectorXd unknowns = base.unknowns;
    for (std::size_t s = 0; s < candidate.shapes.size(); ++s)
      unknowns(static_cast<Index>(candidate.shapes[s])) = shape(static_cast<Index>(s));
    if (candidate.least_strength > 0) {
      unknowns(static_cast<Index>(candidate.strengths[0])) = candidate.least_strength;
      const VectorXd rows = discrepancy(unknowns);
      if ((rows - base.rows).norm() < unseen) continue;
      const double gain = base.chi_squared - without(basis, rows).squaredNorm();
      if (gain > best.gain || best.start.size() == 0) best = {std::max(0.0, gain), unknowns};
      continue;
    }
    const UnitSlopes slopes = unit_slopes(discrepancy, unknowns, candidate.strengths, {}, 1);
    Screening found = screen_slopes(base, basis, candidate, unknowns, slopes.columns, slopes.scale);
    if (found.gain > best.gain) best = std::move(found);
  }
  return best;
}

Explanation explain(const Discrepancy& discrepancy, const std::vector<Candidate>& candidates,
                    std::vector<std::size_t> members, const VectorXd& start, const std::vector<std::size_t>& own,
                    const VectorXd& scale_guess) {
  Explanation e;
  std::vector<std::size_t> free = own;
  for (const std::size_t m : members) {
    const Candidate& c = candidates[m];
    free.insert(free.end(), c.strengths.begin(), c.strengths.end());
    free.insert(free.end(), c.shapes.begin(), c.shapes.end());
    e.unknowns += c.strengths.size() + c.shapes.size();
  }
  // A strength that another member or the model frees already counts once.
  std::sort(free.begin(), free.end());
  free.erase(std::unique(free.begin(), free.end()), free.end());
  e.members = std::move(members);
  RefitOptions options;
  options.scale_guess = scale_guess;
  e.fit = refit(discrepancy, start, free, options);
  return e;
}

// The strengths and shapes of one candidate from one vector of unknowns put into another.
void take_over(VectorXd& into, const VectorXd& from, const Candidate& c) {
  for (const std::size_t u : c.strengths) into(static_cast<Index>(u)) = from(static_cast<Index>(u));
  for (const std::size_t u : c.shapes) into(static_cast<Index>(u)) = from(static_cast<Index>(u));
}

// An explanation's unknowns with these candidates switched off.
VectorXd without(VectorXd unknowns, const std::vector<std::size_t>& members,
                 const std::vector<Candidate>& candidates) {
  for (const std::size_t m : members)
    for (const std::size_t u : candidates[m].strengths) unknowns(static_cast<Index>(u)) = 0;
  return unknowns;
}

bool is_possible(const Explanation& e, const std::vector<Candidate>& candidates) {
  return std::none_of(e.members.begin(), e.members.end(), [&](std::size_t m) {
    return candidates[m].passive && e.fit.unknowns(static_cast<Index>(candidates[m].strengths[0])) < 0;
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

}  // namespace

Inference infer(Discrepancy& discrepancy, const std::vector<Candidate>& candidates, const VectorXd& start,
                const std::vector<std::size_t>& own, const InferenceOptions& options) {
  Inference result;
  RefitOptions all_threads;
  all_threads.threads = options.threads;
  // Scales are much the same wherever a fit begins.
  VectorXd scales = VectorXd::Zero(start.size());
  const auto remember = [&](const std::vector<std::size_t>& which, const VectorXd& scale) {
    for (std::size_t i = 0; i < which.size(); ++i)
      if (scale(static_cast<Index>(i)) > 0) scales(static_cast<Index>(which[i])) = scale(static_cast<Index>(i));
  };
  const double rows = static_cast<double>(discrepancy.freedom());
  // Errors of the rows depend on the unknowns, and a start far off has none that mean anything: from coarse to
  // fine. Of a model that is far from the data a fine fit would be bent beyond all sense; what it lacks is looked
  // for first, among errors that it can live with.
  VectorXd unknowns = start;
  std::vector<Refit> nulls;
  for (const double coarse : levels) {
    Refit fit;
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 6; ++round) {
      discrepancy.freeze(unknowns, coarse);
      all_threads.scale_guess = scales;
      all_threads.damping = coarse > 0 ? first_damping : 0;
      fit = refit(discrepancy, unknowns, own, all_threads);
      remember(own, fit.scale);
      unknowns = fit.unknowns;
      const double now = fit.chi_squared;
      if (round > 0 && std::abs(now - before) < 0.02 * before + 1) break;
      before = now;
    }
    nulls.push_back(std::move(fit));
  }
  std::size_t level = nulls.size() - 1;
  const auto misses = [&](const Refit& fit) { return fit.chi_squared > most_misfit * rows; };
  if (misses(nulls[level])) {
    while (level > 0 && misses(nulls[level])) --level;
    discrepancy.freeze(nulls[level].unknowns, levels[level]);
    nulls[level] = refit(discrepancy, nulls[level].unknowns, own, all_threads);
    remember(own, nulls[level].scale);
  }
  result.null.fit = std::move(nulls[level]);
  result.degrees_of_freedom = rows - static_cast<double>(result.null.fit.rank);

  std::vector<std::size_t> plain_strengths;
  for (const Candidate& c : candidates)
    if (is_plain(c)) plain_strengths.insert(plain_strengths.end(), c.strengths.begin(), c.strengths.end());
  const auto screen_all = [&](const Refit& base, std::vector<Screening>& found) {
    const MatrixXd basis = basis_of(base.jacobian);
    const UnitSlopes slopes = unit_slopes(discrepancy, base.unknowns, plain_strengths, scales, options.threads);
    remember(plain_strengths, slopes.scale);
    std::vector<Index> first(candidates.size(), 0);
    Index at = 0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      first[c] = at;
      if (is_plain(candidates[c])) at += static_cast<Index>(candidates[c].strengths.size());
    }
    found.assign(candidates.size(), {});
    in_parallel(candidates.size(), options.threads, [&](std::size_t c) {
      const Candidate& candidate = candidates[c];
      const auto count = static_cast<Index>(candidate.strengths.size());
      found[c] = is_plain(candidate) ? screen_slopes(base, basis, candidate, base.unknowns,
                                                     slopes.columns.middleCols(first[c], count),
                                                     slopes.scale.segment(first[c], count))
                                     : screen(discrepancy, base, basis, candidate);
    });
  };
  const auto promising = [&](const std::vector<Screening>& found, std::size_t most) {
    std::vector<std::size_t> order(candidates.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return found[a].gain > found[b].gain; });
    const double best = order.empty() ? 0 : found[order.front()].gain;
    std::vector<std::size_t> kept;
    for (const std::size_t c : order)
      if (kept.size() < most && found[c].gain > std::max(least_gain, least_share * best)) kept.push_back(c);
    return kept;
  };

  std::vector<Screening> singles;
  screen_all(result.null.fit, singles);
  for (const Screening& s : singles) result.linear_gain.push_back(s.gain);
  const std::vector<std::size_t> chosen = promising(singles, most_fits);
  std::vector<Explanation> found(chosen.size());
  in_parallel(chosen.size(), options.threads, [&](std::size_t i) {
    found[i] = explain(discrepancy, candidates, {chosen[i]}, singles[chosen[i]].start, own, scales);
  });
  keep_best_of_each(found, candidates);

  const auto dispersion_of = [&](const Explanation& e) {
    return e.fit.chi_squared / std::max(1.0, rows - static_cast<double>(e.fit.rank));
  };
  const double price = 0.5 * std::log(std::max(2.0, rows));
  const auto leaves_more_than_noise = [&](const Explanation& e) {
    return e.fit.chi_squared >
           result.degrees_of_freedom + least_remainder * std::sqrt(2 * result.degrees_of_freedom);
  };
  // A second effect only where the best single one leaves more than noise, or where one stands out that would be
  // worth its unknown and its prior odds: among many rows that fit, a few that do not are no excess of all.
  const auto add_pairs = [&] {
    std::vector<Explanation> alone;
    for (const Explanation& e : found)
      if (e.members.size() == 1) alone.push_back(e);
    if (alone.empty()) return;
    const std::size_t best_alone = alone.front().members.front();
    std::vector<Screening> beside_best;
    screen_all(alone.front().fit, beside_best);
    beside_best[best_alone].gain = 0;
    const auto most = std::max_element(beside_best.begin(), beside_best.end(),
                                       [](const Screening& a, const Screening& b) { return a.gain < b.gain; });
    const double worth = 2 * (price - std::log(options.prior_second)) * std::max(1.0, dispersion_of(alone.front()));
    if (!leaves_more_than_noise(alone.front()) && !(most->gain > worth)) return;
    std::vector<Explanation> doubles;
    std::set<std::pair<std::size_t, std::size_t>> tried;
    std::set<std::size_t> expanded;
    // Partners of one single explanation.
    const auto expand = [&](const Explanation& single) {
      const std::size_t first = single.members.front();
      if (!expanded.insert(first).second) return;
      std::vector<Screening> seconds;
      if (first == best_alone)
        seconds = beside_best;
      else
        screen_all(single.fit, seconds);
      seconds[first].gain = 0;
      std::vector<std::pair<std::size_t, std::size_t>> pairs;
      std::vector<VectorXd> starts;
      for (const std::size_t second : promising(seconds, most_partners)) {
        if (!tried.insert(std::minmax(first, second)).second) continue;
        pairs.emplace_back(first, second);
        VectorXd begin = single.fit.unknowns;
        take_over(begin, seconds[second].start, candidates[second]);
        starts.push_back(std::move(begin));
      }
      std::vector<Explanation> fresh(pairs.size());
      in_parallel(pairs.size(), options.threads, [&](std::size_t i) {
        fresh[i] = explain(discrepancy, candidates, {pairs[i].first, pairs[i].second}, starts[i], own, scales);
      });
      for (Explanation& e : fresh) doubles.push_back(std::move(e));
    };
    for (std::size_t f = 0; f < std::min(most_firsts, alone.size()); ++f) expand(alone[f]);
    // The two that act together need not be the best alone: partners of both members of the best pair, until it
    // stays.
    for (int round = 0; round < most_exchanges && !doubles.empty(); ++round) {
      keep_best_of_each(doubles, candidates);
      const std::vector<std::size_t> best = doubles.front().members;
      bool moved = false;
      for (const std::size_t member : best) {
        if (expanded.count(member) > 0) continue;
        moved = true;
        expand(explain(discrepancy, candidates, {member},
                       singles[member].start.size() > 0 ? singles[member].start : result.null.fit.unknowns, own,
                       scales));
      }
      if (!moved) break;
    }
    keep_best_of_each(doubles, candidates);
    // Members of the best pairs alone, from the pair's numbers: on its own way from the null one may have stopped
    // short.
    std::set<std::size_t> again;
    for (std::size_t d = 0; d < std::min(most_firsts, doubles.size()); ++d)
      for (std::size_t m = 0; m < 2; ++m) {
        const std::size_t member = doubles[d].members[m], other = doubles[d].members[1 - m];
        if (!again.insert(member).second) continue;
        found.push_back(explain(discrepancy, candidates, {member},
                                without(doubles[d].fit.unknowns, {other}, candidates), own, scales));
      }
    for (Explanation& e : doubles) found.push_back(std::move(e));
    keep_best_of_each(found, candidates);
  };
  const auto refit_all = [&] {
    in_parallel(found.size(), options.threads, [&](std::size_t i) {
      RefitOptions once_more;
      once_more.scale_guess = scales;
      found[i].fit = refit(discrepancy, found[i].fit.unknowns, found[i].fit.free, once_more);
    });
    keep_best_of_each(found, candidates);
  };
  // Down to the errors of the measurement with the explanations; with two effects as soon as one is not enough.
  bool paired = false;
  while (level + 1 < std::size(levels) && !found.empty()) {
    discrepancy.freeze(found.front().fit.unknowns, levels[level + 1]);
    all_threads.scale_guess = scales;
    const Refit finer = refit(discrepancy, found.front().fit.unknowns, found.front().fit.free, all_threads);
    if (misses(finer) && !paired) {
      discrepancy.freeze(found.front().fit.unknowns, levels[level]);
      add_pairs();
      paired = true;
      discrepancy.freeze(found.front().fit.unknowns, levels[level + 1]);
    }
    refit_all();
    ++level;
  }
  add_pairs();
  // Once more with the errors and starting points that hold at the best explanation.
  if (!found.empty()) {
    const Explanation best = found.front();
    discrepancy.freeze(best.fit.unknowns);
    const VectorXd switched_off = without(best.fit.unknowns, best.members, candidates);
    all_threads.scale_guess = scales;
    result.null.fit = refit(discrepancy, result.null.fit.unknowns, own, all_threads);
    Refit from_best = refit(discrepancy, switched_off, own, all_threads);
    if (from_best.chi_squared < result.null.fit.chi_squared) result.null.fit = std::move(from_best);
    refit_all();
  }
  double dispersion = dispersion_of(result.null);
  for (const Explanation& e : found) dispersion = std::min(dispersion, dispersion_of(e));
  result.dispersion = std::max(1.0, dispersion);

  const auto weigh = [&](Explanation& e) {
    e.log_evidence = -0.5 * e.fit.chi_squared / result.dispersion - price * static_cast<double>(e.unknowns);
    if (e.members.size() > 1) e.log_evidence += std::log(options.prior_second);
  };
  weigh(result.null);
  for (Explanation& e : found) weigh(e);
  std::stable_sort(found.begin(), found.end(),
                   [](const Explanation& a, const Explanation& b) { return a.log_evidence > b.log_evidence; });
  result.explanations = std::move(found);
  return result;
}

double expected_separation(const Explanation& truth, const Explanation& rival, const Explanation& null) {
  // Rows are data minus prediction: their difference is that of the predictions.
  const VectorXd signature = null.fit.rows - truth.fit.rows;
  return without(basis_of(rival.fit.jacobian), signature).squaredNorm();
}

}  // namespace secular
