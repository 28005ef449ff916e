#include "measure/signal/narrow_products.hpp"

#include <cstddef>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Pair = Eigen::Array2d;  // rows are taken two at a time

template <int m>
constexpr auto count = static_cast<std::size_t>(m);

// Columns i, ..., i + m - 1 of a with columns j, ..., j + n - 1 of b: every number that is loaded is used m or n
// times.
template <int m, int n>
void dot_block(const MatrixXd& a, Index i, const MatrixXd& b, Index j, MatrixXd& result) {
  const Index rows = a.rows();
  const double* const left = a.data() + i * rows;
  const double* const right = b.data() + j * rows;
  Pair sum[count<m>][count<n>];
  for (int k = 0; k < m; ++k)
    for (int l = 0; l < n; ++l) sum[k][l].setZero();
  Index row = 0;
  for (; row + 1 < rows; row += 2) {
    Pair x[count<n>];
    for (int l = 0; l < n; ++l) x[l] = Eigen::Map<const Pair>(right + l * rows + row);
    for (int k = 0; k < m; ++k) {
      const Pair y = Eigen::Map<const Pair>(left + k * rows + row);
      for (int l = 0; l < n; ++l) sum[k][l] += y * x[l];
    }
  }
  for (int k = 0; k < m; ++k)
    for (int l = 0; l < n; ++l) {
      result(i + k, j + l) = sum[k][l].sum();
      if (row < rows) result(i + k, j + l) += left[k * rows + row] * right[l * rows + row];
    }
}

template <int m>
void dot_rows(const MatrixXd& a, Index i, const MatrixXd& b, MatrixXd& result) {
  Index j = 0;
  for (; j + 2 <= b.cols(); j += 2) dot_block<m, 2>(a, i, b, j, result);
  if (j < b.cols()) dot_block<m, 1>(a, i, b, j, result);
}

// m columns of `from` at a time.
template <int m>
void subtract_columns(const MatrixXd& a, const MatrixXd& b, Index j, MatrixXd& from) {
  const Index rows = a.rows(), inner = a.cols();
  double* const out = from.data() + j * rows;
  Index row = 0;
  for (; row + 1 < rows; row += 2) {
    Pair left[count<m>];
    for (int k = 0; k < m; ++k) left[k] = Eigen::Map<const Pair>(out + k * rows + row);
    for (Index i = 0; i < inner; ++i) {
      const Pair x = Eigen::Map<const Pair>(a.data() + i * rows + row);
      for (int k = 0; k < m; ++k) left[k] -= b(i, j + k) * x;
    }
    for (int k = 0; k < m; ++k) Eigen::Map<Pair>(out + k * rows + row) = left[k];
  }
  if (row < rows)
    for (int k = 0; k < m; ++k)
      for (Index i = 0; i < inner; ++i) out[k * rows + row] -= a(row, i) * b(i, j + k);
}

}  // namespace

MatrixXd transposed_product(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd result(a.cols(), b.cols());
  Index i = 0;
  for (; i + 4 <= a.cols(); i += 4) dot_rows<4>(a, i, b, result);
  for (; i < a.cols(); ++i) dot_rows<1>(a, i, b, result);
  return result;
}

void subtract_product(const MatrixXd& a, const MatrixXd& b, MatrixXd& from) {
  Index j = 0;
  for (; j + 4 <= from.cols(); j += 4) subtract_columns<4>(a, b, j, from);
  for (; j < from.cols(); ++j) subtract_columns<1>(a, b, j, from);
}

}  // namespace secular
