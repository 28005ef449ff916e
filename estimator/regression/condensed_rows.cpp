#include "estimator/regression/condensed_rows.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "estimator/in_parallel.hpp"

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

/// Rows of which one thread makes a Gram matrix at a time.
constexpr Index chunk = 1024;

// Lower half; summed in the order of the chunks, whatever number of threads there is.
MatrixXd gram_of(const Eigen::Ref<const MatrixXd>& design, unsigned threads) {
  const Index columns = design.cols(), chunks = (design.rows() + chunk - 1) / chunk;
  std::vector<MatrixXd> parts(static_cast<std::size_t>(chunks), MatrixXd::Zero(columns, columns));
  in_parallel(parts.size(), threads, [&](std::size_t c) {
    const Index begin = static_cast<Index>(c) * chunk, count = std::min(chunk, design.rows() - begin);
    parts[c].selfadjointView<Eigen::Lower>().rankUpdate(design.middleRows(begin, count).transpose());
  });
  MatrixXd gram = MatrixXd::Zero(columns, columns);
  for (const MatrixXd& part : parts) gram += part;
  return gram;
}

// Gram = V L V' of scaled columns: sqrt(L) V' has the same. False where it is too ill-conditioned for that.
bool condense_gram(const Eigen::Ref<const MatrixXd>& design, const Eigen::Ref<const VectorXd>& response,
                   unsigned threads, CondensedRows& result) {
  const Index columns = design.cols();
  MatrixXd gram = gram_of(design, threads);
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

CondensedRows condensed_rows(const Eigen::Ref<const MatrixXd>& design, const Eigen::Ref<const VectorXd>& response,
                             unsigned threads) {
  const Index columns = design.cols(), all = columns + 1;
  CondensedRows result{MatrixXd::Zero(all, columns), VectorXd::Zero(all)};
  if (columns > 0 && condense_gram(design, response, threads, result)) return result;
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
