#include "diagnose/inference/screening.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "numerics/in_parallel.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Columns shorter than this after own unknowns are taken out (rows of unit variance, strength of natural scale
/// one) are not seen by the data.
constexpr double unseen = 1e-3;

// By the slopes of its strengths: where these are all that it has.
bool is_plain(const Candidate& candidate) {
  return candidate.shapes.empty() && !(candidate.least_strength > 0);
}

// What strengths with these slopes (per scale) would explain from `unknowns` on.
Screening screen_slopes(const Refit& base, const MatrixXd& basis, const Candidate& candidate, VectorXd unknowns,
                        const MatrixXd& slopes, const VectorXd& scale) {
  const MatrixXd columns = without_span(basis, slopes);
  const MatrixXd seen = basis_of(columns);
  if (seen.cols() == 0 || columns.norm() < unseen) return {};
  const double gain = (seen.transpose() * base.rows).squaredNorm();
  const VectorXd strength = -columns.completeOrthogonalDecomposition().solve(base.rows);
  for (std::size_t s = 0; s < candidate.strengths.size(); ++s)
    unknowns(static_cast<Index>(candidate.strengths[s])) +=
        scale(static_cast<Index>(s)) * strength(static_cast<Index>(s));
  if (candidate.passive && unknowns(static_cast<Index>(candidate.strengths[0])) < 0) return {};
  return {gain, std::move(unknowns), scale};
}

// Shape by shape; a strength has much the same scale at the next one.
Screening screen(const Discrepancy& discrepancy, const Refit& base, const MatrixXd& basis,
                 const Candidate& candidate, VectorXd scales) {
  Screening best;
  for (const VectorXd& shape : candidate.shape_starts) {
    VectorXd unknowns = base.unknowns;
    for (std::size_t s = 0; s < candidate.shapes.size(); ++s)
      unknowns(static_cast<Index>(candidate.shapes[s])) = shape(static_cast<Index>(s));
    if (candidate.least_strength > 0) {
      unknowns(static_cast<Index>(candidate.strengths[0])) = candidate.least_strength;
      const VectorXd rows = discrepancy(unknowns);
      if ((rows - base.rows).norm() < unseen) continue;
      const double gain = base.chi_squared - without_span(basis, rows).squaredNorm();
      if (gain > best.gain || best.start.size() == 0) best = {std::max(0.0, gain), unknowns, {}};
      continue;
    }
    const UnitSlopes slopes = unit_slopes(discrepancy, unknowns, candidate.strengths, scales, 1);
    for (std::size_t s = 0; s < candidate.strengths.size(); ++s)
      if (const double scale = slopes.scale(static_cast<Index>(s)); scale > 0)
        scales(static_cast<Index>(candidate.strengths[s])) = scale;
    Screening found = screen_slopes(base, basis, candidate, unknowns, slopes.columns, slopes.scale);
    if (found.gain > best.gain) best = std::move(found);
  }
  return best;
}

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

MatrixXd without_span(const MatrixXd& basis, const MatrixXd& columns) {
  if (basis.cols() == 0) return columns;
  return columns - basis * (basis.transpose() * columns);
}

void KnownScales::remember(const std::vector<std::size_t>& which, const VectorXd& scale) {
  for (std::size_t i = 0; i < which.size(); ++i)
    if (scale(static_cast<Index>(i)) > 0) scales_(static_cast<Index>(which[i])) = scale(static_cast<Index>(i));
}

std::vector<Screening> screen_all(Discrepancy& discrepancy, const Refit& base,
                                  const std::vector<Candidate>& candidates, KnownScales& scales, unsigned threads) {
  std::vector<std::size_t> strengths;
  std::vector<Index> first(candidates.size(), 0);
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    first[c] = static_cast<Index>(strengths.size());
    if (is_plain(candidates[c]))
      strengths.insert(strengths.end(), candidates[c].strengths.begin(), candidates[c].strengths.end());
  }
  const MatrixXd basis = basis_of(base.jacobian);
  discrepancy.approach(base.unknowns);
  const UnitSlopes slopes = unit_slopes(discrepancy, base.unknowns, strengths, scales.all(), threads);
  scales.remember(strengths, slopes.scale);
  std::vector<Screening> found(candidates.size());
  in_parallel(candidates.size(), threads, [&](std::size_t c) {
    const Candidate& candidate = candidates[c];
    const auto count = static_cast<Index>(candidate.strengths.size());
    found[c] = is_plain(candidate) ? screen_slopes(base, basis, candidate, base.unknowns,
                                                   slopes.columns.middleCols(first[c], count),
                                                   slopes.scale.segment(first[c], count))
                                   : screen(discrepancy, base, basis, candidate, scales.all());
  });
  for (std::size_t c = 0; c < candidates.size(); ++c)
    if (found[c].scale.size() > 0) scales.remember(candidates[c].strengths, found[c].scale);
  return found;
}

}  // namespace secular
