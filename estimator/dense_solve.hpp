#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

namespace secular {

/// Solves matrix * x = right_side by elimination with partial pivoting; `matrix` is row-major and destroyed, the
/// solution replaces `right_side`. For the few degrees of freedom of a mass matrix, templated on the scalar.
template <class Scalar>
void solve_in_place(Scalar* matrix, std::size_t size, Scalar* right_side) {
  using std::abs;
  for (std::size_t column = 0; column < size; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < size; ++row)
      if (abs(matrix[row * size + column]) > abs(matrix[pivot * size + column])) pivot = row;
    if (pivot != column) {
      for (std::size_t c = 0; c < size; ++c) std::swap(matrix[pivot * size + c], matrix[column * size + c]);
      std::swap(right_side[pivot], right_side[column]);
    }
    for (std::size_t row = column + 1; row < size; ++row) {
      const Scalar scale = matrix[row * size + column] / matrix[column * size + column];
      for (std::size_t c = column; c < size; ++c) matrix[row * size + c] -= scale * matrix[column * size + c];
      right_side[row] -= scale * right_side[column];
    }
  }
  for (std::size_t row = size; row-- > 0;) {
    for (std::size_t c = row + 1; c < size; ++c) right_side[row] -= matrix[row * size + c] * right_side[c];
    right_side[row] /= matrix[row * size + row];
  }
}

/// The same for a size that is known to the compiler.
template <std::size_t size, class Scalar>
void solve_in_place(Scalar (&matrix)[size * size], Scalar* right_side) {
  solve_in_place(&matrix[0], size, right_side);
}

}  // namespace secular
