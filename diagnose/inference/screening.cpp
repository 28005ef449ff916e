#include "diagnose/inference/screening.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "diagnose/thresholds.hpp"
#include "numerics/in_parallel.hpp"
#include "numerics/orthonormal_span.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Columns shorter than this after own unknowns are taken out (rows of unit variance, strength of natural scale
/// one) are not seen by the data.
constexpr auto& least_length = diagnose_thresholds().least_length;

// What strengths with these slopes would explain from `unknowns` on.
Screening screen_slopes(const Discrepancy& discrepancy, const Refit& base, const MatrixXd& basis,
                        const Candidate& candidate, VectorXd unknowns, const UnitSlopes& slopes) {
  const MatrixXd columns = without_span(basis, slopes.columns);
  const MatrixXd seen = basis_of(columns);
  if (seen.cols() == 0 || columns.norm() < least_length) return {};
  const VectorXd explained = seen * (seen.transpose() * base.rows);
  const VectorXd strength = -VectorXd(columns.completeOrthogonalDecomposition().solve(base.rows));
  for (std::size_t s = 0; s < candidate.strengths.size(); ++s)
    unknowns(static_cast<Index>(candidate.strengths[s])) +=
        slopes.scale(static_cast<Index>(s)) * strength(static_cast<Index>(s));
  if (candidate.passive && unknowns(static_cast<Index>(candidate.strengths[0])) < 0) return {};
  return {explained.squaredNorm(), discrepancy.share_of_records(explained), std::move(unknowns), slopes.scale};
}

// Whether it acts in these unknowns.
bool acts(const Candidate& candidate, const VectorXd& unknowns) {
  return std::any_of(candidate.strengths.begin(), candidate.strengths.end(),
                     [&](std::size_t u) { return unknowns(static_cast<Index>(u)) != 0; });
}

void put_shapes(const Candidate& candidate, const VectorXd& shape, VectorXd& unknowns) {
  for (std::size_t s = 0; s < candidate.shapes.size(); ++s)
    unknowns(static_cast<Index>(candidate.shapes[s])) = shape(static_cast<Index>(s));
}

// A strength that begins away from zero, for every shape.
Screening screen_from_least(const Discrepancy& discrepancy, const Refit& base, const MatrixXd& basis,
                            const Candidate& candidate) {
  Screening best;
  for (const VectorXd& shape : candidate.shape_starts) {
    VectorXd unknowns = base.unknowns;
    put_shapes(candidate, shape, unknowns);
    unknowns(static_cast<Index>(candidate.strengths[0])) = candidate.least_strength;
    const VectorXd rows = discrepancy(unknowns);
    if ((rows - base.rows).norm() < least_length) continue;
    const VectorXd left = without_span(basis, rows);
    const double gain = base.chi_squared - left.squaredNorm();
    if (gain > best.gain || best.start.size() == 0)
      best = {std::max(0.0, gain), discrepancy.share_of_records(left - base.rows), unknowns, {}};
  }
  return best;
}

// One start of the shapes of many candidates at a time: without a strength no shape moves anything, and slopes by
// many strengths cost little more than those by one.
class Rounds {
 public:
  Rounds(const Discrepancy& discrepancy, const Refit& base, const MatrixXd& basis,
         const std::vector<Candidate>& candidates)
      : discrepancy_(discrepancy), base_(base), basis_(basis), candidates_(candidates) {}

  // `together`: indices of candidates; the best start of each goes to its place in `found`.
  void screen(const std::vector<std::size_t>& together, KnownScales& scales, unsigned threads,
              std::vector<Screening>& found) const {
    for (std::size_t round = 0;; ++round) {
      VectorXd unknowns = base_.unknowns;
      std::vector<std::size_t> asked, strengths;
      std::vector<Index> first;
      for (const std::size_t c : together) {
        const Candidate& candidate = candidates_[c];
        if (round >= candidate.shape_starts.size()) continue;
        put_shapes(candidate, candidate.shape_starts[round], unknowns);
        asked.push_back(c);
        first.push_back(static_cast<Index>(strengths.size()));
        strengths.insert(strengths.end(), candidate.strengths.begin(), candidate.strengths.end());
      }
      if (asked.empty()) return;
      const UnitSlopes slopes = unit_slopes(discrepancy_, unknowns, strengths, scales.all(), threads);
      scales.remember(strengths, slopes.scale);
      for (std::size_t i = 0; i < asked.size(); ++i) {
        const Candidate& candidate = candidates_[asked[i]];
        const auto count = static_cast<Index>(candidate.strengths.size());
        VectorXd start = base_.unknowns;
        put_shapes(candidate, candidate.shape_starts[round], start);
        Screening screened =
            screen_slopes(discrepancy_, base_, basis_, candidate, std::move(start),
                          {slopes.scale.segment(first[i], count), slopes.columns.middleCols(first[i], count)});
        if (screened.gain > found[asked[i]].gain) found[asked[i]] = std::move(screened);
      }
    }
  }

 private:
  const Discrepancy& discrepancy_;
  const Refit& base_;
  const MatrixXd& basis_;
  const std::vector<Candidate>& candidates_;
};

}  // namespace

MatrixXd basis_of(const MatrixXd& columns) {
  if (columns.cols() == 0) return MatrixXd(columns.rows(), 0);
  const VectorXd length = columns.colwise().norm().transpose();
  const VectorXd unit = length.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
  const Eigen::BDCSVD<MatrixXd> svd(columns * unit.asDiagonal(), Eigen::ComputeThinU);
  Index rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()(rank) > 1e-6 * svd.singularValues()(0)) ++rank;
  return svd.matrixU().leftCols(rank);
}

void KnownScales::remember(const std::vector<std::size_t>& which, const VectorXd& scale) {
  for (std::size_t i = 0; i < which.size(); ++i)
    if (scale(static_cast<Index>(i)) > 0) scales_(static_cast<Index>(which[i])) = scale(static_cast<Index>(i));
}

std::vector<Screening> screen_all(Discrepancy& discrepancy, const Refit& base,
                                  const std::vector<Candidate>& candidates, KnownScales& scales, unsigned threads) {
  const MatrixXd basis = basis_of(base.jacobian);
  discrepancy.approach(base.unknowns);
  std::vector<Screening> found(candidates.size());
  std::vector<std::size_t> still, acting, from_least;
  for (std::size_t c = 0; c < candidates.size(); ++c)
    (candidates[c].least_strength > 0     ? from_least
     : acts(candidates[c], base.unknowns) ? acting
                                          : still)
        .push_back(c);
  const Rounds rounds(discrepancy, base, basis, candidates);
  rounds.screen(still, scales, threads, found);
  for (const std::size_t c : acting) rounds.screen({c}, scales, threads, found);
  in_parallel(from_least.size(), threads, [&](std::size_t i) {
    found[from_least[i]] = screen_from_least(discrepancy, base, basis, candidates[from_least[i]]);
  });
  return found;
}

}  // namespace secular
