#include "diagnose/evidence/frequency_scatter.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of one mode: with fewer, what follows the settings smoothly (smooth_structure) is not told from chance.
constexpr std::size_t fewest_records = 8;

/// Singular values of a jacobian below this share of the largest are rounding, as in a fit.
constexpr double rank_tolerance = 1e-6;

MatrixXd span_of(const MatrixXd& jacobian) {
  if (jacobian.cols() == 0) return MatrixXd(jacobian.rows(), 0);
  const VectorXd length = jacobian.colwise().norm().transpose();
  const VectorXd unit = length.unaryExpr([](double x) { return x > 0 ? 1 / x : 0.0; });
  const Eigen::BDCSVD<MatrixXd> svd(jacobian * unit.asDiagonal(), Eigen::ComputeThinU);
  Index rank = 0;
  while (rank < svd.singularValues().size() &&
         svd.singularValues()(rank) > rank_tolerance * svd.singularValues()(0))
    ++rank;
  return svd.matrixU().leftCols(rank);
}

// Changes of one record and one mode, a column each; those that no row shows are left out.
struct RecordColumns {
  std::vector<std::size_t> record;
  std::vector<Index> mode;
  MatrixXd columns;
};

RecordColumns columns_of(const MatrixXd& changes, const std::map<std::size_t, std::vector<Index>>& rows_of) {
  RecordColumns result;
  std::vector<VectorXd> columns;
  const double largest = changes.colwise().norm().maxCoeff();
  for (const auto& [record, rows] : rows_of)
    for (Index k = 0; k < changes.cols(); ++k) {
      VectorXd column = VectorXd::Zero(changes.rows());
      column(rows) = changes(rows, k);
      if (!(column.norm() > rank_tolerance * largest)) continue;
      result.record.push_back(record);
      result.mode.push_back(k);
      columns.push_back(std::move(column));
    }
  result.columns.resize(changes.rows(), static_cast<Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) result.columns.col(static_cast<Index>(c)) = columns[c];
  return result;
}

}  // namespace

FrequencyScatter frequency_scatter(const VectorXd& rows, const MatrixXd& jacobian, const MatrixXd& changes,
                                   const std::vector<RowLabel>& labels, double freedom) {
  FrequencyScatter result;
  if (!rows.allFinite() || !changes.allFinite()) return result;
  std::map<std::size_t, std::vector<Index>> rows_of;
  for (std::size_t r = 0; r < labels.size(); ++r) rows_of[labels[r].record].push_back(static_cast<Index>(r));
  const MatrixXd basis = span_of(jacobian);
  const VectorXd left = rows - basis * (basis.transpose() * rows);
  const RecordColumns of = columns_of(changes, rows_of);
  const MatrixXd seen = of.columns - basis * (basis.transpose() * of.columns);
  MatrixXd gram = seen.transpose() * seen;
  std::vector<Index> shown;
  for (Index c = 0; c < gram.cols(); ++c)
    if (gram(c, c) > rank_tolerance * of.columns.col(c).squaredNorm()) shown.push_back(c);
  std::map<Index, std::size_t> of_mode;
  for (const Index c : shown) ++of_mode[of.mode[static_cast<std::size_t>(c)]];
  std::erase_if(shown, [&](Index c) { return of_mode.at(of.mode[static_cast<std::size_t>(c)]) < fewest_records; });
  if (shown.empty()) return result;
  gram = gram(shown, shown).eval();
  const VectorXd own = gram.diagonal();
  const MatrixXd seen_shown = seen(Eigen::all, shown);
  const VectorXd products = seen_shown.transpose() * left;
  const auto count = static_cast<double>(shown.size());
  // What all of them together do not explain is the variance of a row, where it is more than one.
  const Eigen::CompleteOrthogonalDecomposition<MatrixXd> along(gram);
  result.along = seen_shown * along.solve(products);
  result.freedom = static_cast<double>(along.rank());
  const double beside = left.squaredNorm() - result.along.squaredNorm();
  const double row_variance =
      std::max(1.0, beside / std::max(1.0, freedom - static_cast<double>(basis.cols() + along.rank())));
  const double q = products.cwiseAbs2().cwiseQuotient(own).sum() / row_variance;
  const MatrixXd shared = gram.cwiseAbs2();
  const double variance = 2 * shared.cwiseQuotient(own * own.transpose()).sum();
  result.p_value = chi_squared_upper_tail(q * 2 * count / variance, 2 * count * count / variance);
  const double by_scatter = (own.cwiseInverse().asDiagonal() * shared).sum();
  const double squared = std::max(0.0, row_variance * (q - count) / by_scatter);
  result.relative_sd = std::sqrt(squared);
  if (squared == 0) return result;
  for (const auto& [record, unused] : rows_of) result.records.push_back(record);
  result.shifts = MatrixXd::Zero(static_cast<Index>(rows_of.size()), changes.cols());
  const MatrixXd prior = MatrixXd::Identity(gram.rows(), gram.cols()) * (row_variance / squared);
  const VectorXd shifts = -(gram + prior).ldlt().solve(products);
  for (std::size_t s = 0; s < shown.size(); ++s) {
    const auto c = static_cast<std::size_t>(shown[s]);
    const auto row =
        std::lower_bound(result.records.begin(), result.records.end(), of.record[c]) - result.records.begin();
    result.shifts(row, of.mode[c]) = shifts(static_cast<Index>(s));
  }
  return result;
}

}  // namespace secular
