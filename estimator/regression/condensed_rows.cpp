#include "estimator/regression/condensed_rows.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "numerics/in_parallel.hpp"

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

/// Rows that one thread takes at a time.
constexpr Index rows_at_a_time = 1024;

// Sums over rows, chunk by chunk and in their order, whatever number of threads there is. Every chunk is still near
// when its second product is formed.
class RowSums {
 public:
  RowSums(const Eigen::Ref<const MatrixXd>& design, unsigned threads)
      : design_(design), threads_(threads), chunks_((design.rows() + rows_at_a_time - 1) / rows_at_a_time) {}

  // Lower half of the Gram matrix, and the products of columns and response.
  std::pair<MatrixXd, VectorXd> products(const Eigen::Ref<const VectorXd>& response) const {
    const Index columns = design_.cols();
    std::vector<MatrixXd> grams(static_cast<std::size_t>(chunks_), MatrixXd::Zero(columns, columns));
    const VectorXd with_response = sum([&](Index begin, Index count, std::size_t c) -> VectorXd {
      const auto rows = design_.middleRows(begin, count);
      grams[c].selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
      return rows.transpose() * response.segment(begin, count);
    });
    MatrixXd gram = MatrixXd::Zero(columns, columns);
    for (const MatrixXd& part : grams) gram += part;
    return {std::move(gram), with_response};
  }

  // Takes the columns times `coefficients` off `left`; products of the columns and what is left.
  VectorXd take_off(const VectorXd& coefficients, VectorXd& left) const {
    return sum([&](Index begin, Index count, std::size_t) -> VectorXd {
      const auto rows = design_.middleRows(begin, count);
      left.segment(begin, count).noalias() -= rows * coefficients;
      return rows.transpose() * left.segment(begin, count);
    });
  }

 private:
  template <class Part>
  VectorXd sum(const Part& part) const {
    std::vector<VectorXd> parts(static_cast<std::size_t>(chunks_));
    in_parallel(parts.size(), threads_, [&](std::size_t c) {
      const Index begin = static_cast<Index>(c) * rows_at_a_time;
      parts[c] = part(begin, std::min(rows_at_a_time, design_.rows() - begin), c);
    });
    VectorXd all = VectorXd::Zero(design_.cols());
    for (const VectorXd& one : parts) all += one;
    return all;
  }

  Eigen::Ref<const MatrixXd> design_;
  unsigned threads_;
  Index chunks_;
};

// Gram = V L V' of scaled columns: sqrt(L) V' has the same. False where it is too ill-conditioned for that.
bool condense_gram(const Eigen::Ref<const MatrixXd>& design, const Eigen::Ref<const VectorXd>& response,
                   unsigned threads, CondensedRows& result) {
  const Index columns = design.cols();
  const RowSums rows(design, threads);
  auto [gram, with_response] = rows.products(response);
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
  const MatrixXd basis = size.cwiseInverse().asDiagonal() * along * root.cwiseInverse().asDiagonal();
  VectorXd target = basis.transpose() * with_response, left = response;
  // The second step takes back what forming the Gram matrix lost.
  const VectorXd more = basis.transpose() * rows.take_off(basis * target, left);
  target += more;
  rows.take_off(basis * more, left);
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
  const Eigen::HouseholderQR<MatrixXd> qr(both);
  const MatrixXd triangle = qr.matrixQR().topRows(all).triangularView<Eigen::Upper>();
  result.design = triangle.leftCols(columns) * size.asDiagonal();
  result.response = triangle.col(columns);
  return result;
}

}  // namespace secular
