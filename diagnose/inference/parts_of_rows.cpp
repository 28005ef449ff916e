#include "diagnose/inference/parts_of_rows.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <map>

#include "diagnose/inference/directions.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the largest eigenvalue of a part's Gram matrix: below it is rounding.
constexpr double rounding_of_gram = 1e-10;

std::map<int, std::vector<Index>> rows_by_part(const std::vector<int>& part) {
  std::map<int, std::vector<Index>> rows;
  for (std::size_t r = 0; r < part.size(); ++r) rows[part[r]].push_back(static_cast<Index>(r));
  return rows;
}

}  // namespace

double PartsAgreement::dispersion() const {
  return freedom > 0 ? std::max(1.0, chi_squared / freedom) : 1;
}

PartsAgreement agreement_of_parts(const Refit& fit, const std::vector<int>& part) {
  PartsAgreement result;
  const std::map<int, std::vector<Index>> parts = rows_by_part(part);
  if (fit.rank == 0 || parts.size() < 2) return result;
  const MatrixXd columns = fit.jacobian * Directions(fit.jacobian).to_orthonormal();
  result.freedom = -static_cast<double>(fit.rank);
  for (const auto& [name, rows] : parts) {
    const MatrixXd own = columns(rows, Eigen::all);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> gram(MatrixXd(own.transpose() * own));
    const VectorXd score = gram.eigenvectors().transpose() * (own.transpose() * fit.rows(rows));
    const VectorXd& size = gram.eigenvalues();
    for (Index i = 0; i < size.size(); ++i)
      if (size(i) > rounding_of_gram * size.maxCoeff()) {
        result.chi_squared += score(i) * score(i) / size(i);
        result.freedom += 1;
      }
  }
  if (result.freedom > 0) result.p_value = chi_squared_upper_tail(result.chi_squared, result.freedom);
  return result;
}

std::vector<int> parts_by_fold(const std::vector<RowLabel>& labels) {
  std::vector<int> part;
  for (const RowLabel& label : labels) part.push_back(label.fold);
  return part;
}

std::vector<int> large_parts(const Refit& fit, const std::vector<RowLabel>& labels) {
  std::vector<int> part;
  for (const RowLabel& label : labels) part.push_back(static_cast<int>(label.record));
  const bool single = std::all_of(part.begin(), part.end(), [&](int record) { return record == part.front(); });
  if (!single || fit.rank == 0) return part;
  const VectorXd told = (fit.jacobian * Directions(fit.jacobian).to_orthonormal()).rowwise().squaredNorm();
  const std::map<int, std::vector<Index>> folds = rows_by_part(parts_by_fold(labels));
  double before = 0;
  for (const auto& [fold, rows] : folds) {
    for (const Index r : rows) part[static_cast<std::size_t>(r)] = 2 * before < told.sum() ? 0 : 1;
    before += told(rows).sum();
  }
  return part;
}

}  // namespace secular
