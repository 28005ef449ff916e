#include "estimator/identification/window_overlap.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Rows of one window in a fit.
struct RowsOfWindow {
  const Observation* observation = nullptr;
  const MatrixXd* noise = nullptr;  // of its rows
  Index begin = 0, count = 0;
};

std::map<int, std::vector<RowsOfWindow>> windows_by_condition(const CaseFit& fit,
                                                              const std::vector<MatrixXd>& rows_by_noise) {
  std::map<int, std::vector<RowsOfWindow>> conditions;
  Index begin = 0;
  for (const MatrixXd& noise : rows_by_noise) {
    const auto at = static_cast<std::size_t>(begin);
    conditions[fit.system.condition[at]].push_back(
        {&fit.set->observations[fit.system.observation[at]], &noise, begin, noise.rows()});
    begin += noise.rows();
  }
  return conditions;
}

// Of a window with a later one of its stretch; none: they do not overlap.
const WindowPair* pair_of(const Observation& here, const Observation& later) {
  if (!here.overlap || here.overlap != later.overlap || !(here.length_s > 0)) return nullptr;
  const auto steps = static_cast<double>(here.overlap->size() + 1);
  const auto n = std::lround(steps * (later.centre_s - here.centre_s) / here.length_s);
  return n < 1 || n >= static_cast<long>(steps) ? nullptr : &(*here.overlap)[static_cast<std::size_t>(n - 1)];
}

// (44): correlations of the rows of two windows.
MatrixXd correlation_between(const WhitenedSystem& system, const EquationData& data, const WindowPair& pair,
                             const RowsOfWindow& here, const RowsOfWindow& later) {
  const Index quantities = data.quantities();
  MatrixXd own = MatrixXd::Zero(here.count, later.count);
  for (Index r = 0; r < here.count; ++r)
    for (Index s = 0; s < later.count; ++s) {
      const auto a = static_cast<std::size_t>(here.begin + r), b = static_cast<std::size_t>(later.begin + s);
      if (system.block[a] == system.block[b] && system.part[a] == system.part[b])
        own(r, s) = pair.harmonic[system.block[a]];
    }
  return here.noise->leftCols(quantities) * data.correlation(pair) * later.noise->leftCols(quantities).transpose() +
         here.noise->rightCols(here.count) * own * later.noise->rightCols(later.count).transpose();
}

// Of all rows of one condition.
MatrixXd correlation_within(const WhitenedSystem& system, const EquationData& data,
                            const std::vector<RowsOfWindow>& windows) {
  const Index first = windows.front().begin, size = windows.back().begin + windows.back().count - first;
  MatrixXd omega = MatrixXd::Identity(size, size);
  for (std::size_t a = 0; a < windows.size(); ++a)
    for (std::size_t b = a + 1; b < windows.size(); ++b) {
      const RowsOfWindow &here = windows[a], &later = windows[b];
      const WindowPair* pair = pair_of(*here.observation, *later.observation);
      if (!pair) continue;
      const MatrixXd both = correlation_between(system, data, *pair, here, later);
      omega.block(here.begin - first, later.begin - first, here.count, later.count) = both;
      omega.block(later.begin - first, here.begin - first, later.count, here.count) = both.transpose();
    }
  return omega;
}

// What is left of rows about the mean of what is the same equation.
MatrixXd about_means(const WhitenedSystem& system, Index first, Index size) {
  std::map<std::pair<std::size_t, EquationPart>, std::vector<Index>> equations;
  for (Index r = 0; r < size; ++r) {
    const auto at = static_cast<std::size_t>(first + r);
    equations[{system.block[at], system.part[at]}].push_back(r);
  }
  MatrixXd left = MatrixXd::Identity(size, size);
  for (const auto& [equation, rows] : equations)
    for (const Index r : rows)
      for (const Index s : rows) left(r, s) -= 1 / static_cast<double>(rows.size());
  return left;
}

}  // namespace

WindowOverlap window_overlap(const CaseFit& fit, const EquationData& data,
                             const std::vector<MatrixXd>& rows_by_noise) {
  const MatrixXd& orthonormal = fit.fit.orthonormal;
  WindowOverlap result;
  result.gram = MatrixXd::Zero(orthonormal.cols(), orthonormal.cols());
  double squares = 0, seen_squares = 0;  // traces of Omega^2 and U' Omega^2 U
  for (const auto& [condition, windows] : windows_by_condition(fit, rows_by_noise)) {
    const Index first = windows.front().begin, size = windows.back().begin + windows.back().count - first;
    const MatrixXd omega = correlation_within(fit.system, data, windows);
    const auto u = orthonormal.middleRows(first, size);
    const MatrixXd seen = omega * u;
    result.gram += u.transpose() * seen;
    squares += omega.squaredNorm();
    seen_squares += seen.squaredNorm();
    const MatrixXd scatter = about_means(fit.system, first, size) * omega;
    result.repeats += scatter.trace();
    result.repeats_squared += scatter.cwiseProduct(scatter.transpose()).sum();
  }
  result.left = static_cast<double>(orthonormal.rows()) - result.gram.trace();
  result.left_squared = squares - 2 * seen_squares + result.gram.squaredNorm();
  return result;
}

}  // namespace secular
