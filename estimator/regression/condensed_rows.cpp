#include "estimator/regression/condensed_rows.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the eigenvalues of a Gram matrix, relative to the largest: above, half of the digits are right; what is below
/// is nothing or rounding.
constexpr double well_apart = 1e-8, rounding = 1e-13;

/// Norm of a combination of scaled columns that is zero, relative to the largest.
constexpr double zero_combination = 1e-11;

// Gram = V L V' of scaled columns: sqrt(L) V' has the same. False where it is too ill-conditioned for that.
bool condense_gram(const Eigen::Ref<const MatrixXd>& design, const Eigen::Ref<const VectorXd>& response,
                   CondensedRows& result) {
  const Index columns = design.cols();
  MatrixXd gram = MatrixXd::Zero(columns, columns);
  gram.selfadjointView<Eigen::Lower>().rankUpdate(design.transpose());
  VectorXd size = gram.diagonal().cwiseSqrt();
  if (!size.allFinite()) return false;
  for (Index c = 0; c < columns; ++c) size(c) = size(c) > 0 ? size(c) : 1;
  for (Index c = 0; c < columns; ++c)
    for (Index r = c; r < columns; ++r) gram(r, c) /= size(r) * size(c);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
  if (eigen.info() != Eigen::Success) return false;
  const VectorXd& value = eigen.eigenvalues();  // ascending
  const double largest = value(columns - 1);
  Index zeros = 0;
  while (zeros < columns && value(zeros) < rounding * largest) ++zeros;
  if (zeros == columns || value(zeros) < well_apart * largest) return false;
  const MatrixXd dependent = size.cwiseInverse().asDiagonal() * eigen.eigenvectors().leftCols(zeros);
  if (zeros > 0 && (design * dependent).colwise().norm().maxCoeff() > zero_combination * std::sqrt(largest))
    return false;
  const Index rank = columns - zeros;
  const VectorXd root = value.tail(rank).cwiseSqrt();
  const MatrixXd along = eigen.eigenvectors().rightCols(rank);
  // The second step takes back what forming the Gram matrix lost.
  const MatrixXd basis = size.cwiseInverse().asDiagonal() * along * root.cwiseInverse().asDiagonal();
  VectorXd target = VectorXd::Zero(rank), left = response;
  for (int step = 0; step < 2; ++step) {
    const VectorXd more = basis.transpose() * (design.transpose() * left);
    target += more;
    left -= design * (basis * more);
  }
  result.design.topRows(rank) = root.asDiagonal() * along.transpose() * size.asDiagonal();
  result.response.head(rank) = target;
  result.response(columns) = left.norm();
  return true;
}

}  // namespace

CondensedRows condensed_rows(const Eigen::Ref<const MatrixXd>& design, const Eigen::Ref<const VectorXd>& response) {
  const Index columns = design.cols(), all = columns + 1;
  CondensedRows result{MatrixXd::Zero(all, columns), VectorXd::Zero(all)};
  if (columns > 0 && condense_gram(design, response, result)) return result;
  VectorXd size = design.colwise().norm().transpose();
  for (Index c = 0; c < columns; ++c) size(c) = size(c) > 0 ? size(c) : 1;
  MatrixXd both(design.rows(), all);
  both.leftCols(columns) = design * size.cwiseInverse().asDiagonal();
  both.col(columns) = response;
  const Eigen::HouseholderQR<Eigen::Ref<MatrixXd>> qr(both);  // in place
  const MatrixXd triangle = qr.matrixQR().topRows(all).triangularView<Eigen::Upper>();
  result.design = triangle.leftCols(columns) * size.asDiagonal();
  result.response = triangle.col(columns);
  return result;
}

}  // namespace secular
