#include "diagnose/inference.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
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
    const VectorXd scale = natural_scales(discrepancy, unknowns, candidate.strengths, 1);
    const MatrixXd columns = without(basis, jacobian_of(discrepancy, unknowns, candidate.strengths, scale, 1));
    const MatrixXd seen = basis_of(columns);
    if (seen.cols() == 0 || columns.norm() < unseen) continue;
    const double gain = (seen.transpose() * base.rows).squaredNorm();
    if (!(gain > best.gain)) continue;
    const VectorXd strength = -columns.completeOrthogonalDecomposition().solve(base.rows);
    for (std::size_t s = 0; s < candidate.strengths.size(); ++s)
      unknowns(static_cast<Index>(candidate.strengths[s])) +=
          scale(static_cast<Index>(s)) * strength(static_cast<Index>(s));
    if (candidate.passive && unknowns(static_cast<Index>(candidate.strengths[0])) < 0) continue;
    best = {gain, unknowns};
  }
  return best;
}

Explanation explain(const Discrepancy& discrepancy, const std::vector<Candidate>& candidates,
                    std::vector<std::size_t> members, const VectorXd& start, const std::vector<std::size_t>& own) {
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
  e.fit = refit(discrepancy, start, free);
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
  // Errors of the rows depend on the unknowns, and a start far off has none that mean anything: from coarse to
  // fine.
  VectorXd unknowns = start;
  for (const double coarse : {1e-2, 1e-3, 1e-4, 0.0}) {
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 6; ++round) {
      discrepancy.freeze(unknowns, coarse);
      result.null.fit = refit(discrepancy, unknowns, own, all_threads);
      unknowns = result.null.fit.unknowns;
      const double now = result.null.fit.chi_squared;
      if (round > 0 && std::abs(now - before) < 0.02 * before + 1) break;
      before = now;
    }
  }
  const double rows = static_cast<double>(discrepancy.freedom());
  result.degrees_of_freedom = rows - static_cast<double>(result.null.fit.rank);

  const auto screen_all = [&](const Refit& base, std::vector<Screening>& found) {
    const MatrixXd basis = basis_of(base.jacobian);
    found.assign(candidates.size(), {});
    in_parallel(candidates.size(), options.threads,
                [&](std::size_t c) { found[c] = screen(discrepancy, base, basis, candidates[c]); });
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
    found[i] = explain(discrepancy, candidates, {chosen[i]}, singles[chosen[i]].start, own);
  });
  keep_best_of_each(found, candidates);

  const auto dispersion_of = [&](const Explanation& e) {
    return e.fit.chi_squared / std::max(1.0, rows - static_cast<double>(e.fit.rank));
  };
  // A second effect only where the best single one leaves more than noise.
  const bool incomplete =
      !found.empty() && found.front().fit.chi_squared >
                            result.degrees_of_freedom + least_remainder * std::sqrt(2 * result.degrees_of_freedom);
  if (incomplete) {
    const std::size_t singles_found = found.size();
    std::vector<Explanation> doubles;
    std::set<std::pair<std::size_t, std::size_t>> tried;
    std::set<std::size_t> expanded;
    // Partners of one single explanation.
    const auto expand = [&](const Explanation& single) {
      const std::size_t first = single.members.front();
      if (!expanded.insert(first).second) return;
      std::vector<Screening> seconds;
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
        fresh[i] = explain(discrepancy, candidates, {pairs[i].first, pairs[i].second}, starts[i], own);
      });
      for (Explanation& e : fresh) doubles.push_back(std::move(e));
    };
    for (std::size_t f = 0; f < std::min(most_firsts, singles_found); ++f) expand(found[f]);
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
                       singles[member].start.size() > 0 ? singles[member].start : result.null.fit.unknowns, own));
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
        found.push_back(
            explain(discrepancy, candidates, {member}, without(doubles[d].fit.unknowns, {other}, candidates), own));
      }
    for (Explanation& e : doubles) found.push_back(std::move(e));
    keep_best_of_each(found, candidates);
  }
  // Once more with the errors and starting points that hold at the best explanation.
  if (!found.empty()) {
    const auto best = std::min_element(found.begin(), found.end(), [](const Explanation& a, const Explanation& b) {
      return a.fit.chi_squared < b.fit.chi_squared;
    });
    discrepancy.freeze(best->fit.unknowns);
    const VectorXd switched_off = without(best->fit.unknowns, best->members, candidates);
    result.null.fit = refit(discrepancy, result.null.fit.unknowns, own, all_threads);
    Refit from_best = refit(discrepancy, switched_off, own, all_threads);
    if (from_best.chi_squared < result.null.fit.chi_squared) result.null.fit = std::move(from_best);
    in_parallel(found.size(), options.threads, [&](std::size_t i) {
      found[i].fit = refit(discrepancy, found[i].fit.unknowns, found[i].fit.free);
    });
  }
  double dispersion = dispersion_of(result.null);
  for (const Explanation& e : found) dispersion = std::min(dispersion, dispersion_of(e));
  result.dispersion = std::max(1.0, dispersion);

  const double price = 0.5 * std::log(std::max(2.0, rows));
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
