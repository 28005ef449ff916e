#pragma once

#include <cstddef>

#include "estimator/model/scalar_functions.hpp"

namespace secular {

template <class Value>
constexpr void exchange_values(Value& a, Value& b) {
  const Value old = a;
  a = b;
  b = old;
}

/// Takes one column out of the rows below it.
template <class Scalar>
void eliminate_column(Scalar* matrix, std::size_t size, std::size_t column, Scalar* right_sides,
                      std::size_t columns) {
  for (std::size_t row = column + 1; row < size; ++row) {
    const Scalar scale = matrix[row * size + column] / matrix[column * size + column];
    for (std::size_t c = column; c < size; ++c)
      matrix[row * size + c] = matrix[row * size + c] - scale * matrix[column * size + c];
    for (std::size_t c = 0; c < columns; ++c)
      right_sides[row * columns + c] = right_sides[row * columns + c] - scale * right_sides[column * columns + c];
  }
}

/// Of a triangular matrix, from the last row on.
template <class Scalar>
void solve_backwards(const Scalar* matrix, std::size_t size, Scalar* right_sides, std::size_t columns) {
  for (std::size_t row = size; row-- > 0;)
    for (std::size_t i = 0; i < columns; ++i) {
      Scalar value = right_sides[row * columns + i];
      for (std::size_t c = row + 1; c < size; ++c)
        value = value - matrix[row * size + c] * right_sides[c * columns + i];
      right_sides[row * columns + i] = value / matrix[row * size + row];
    }
}

/// Solves matrix * x = right_side by elimination with partial pivoting for `columns` right sides at once: `matrix`
/// is [size][size] and destroyed, `right_sides` [size][columns], replaced by the solutions; both row-major. For the
/// few degrees of freedom of a mass matrix, templated on the scalar.
template <class Scalar>
void solve_in_place(Scalar* matrix, std::size_t size, Scalar* right_sides, std::size_t columns = 1) {
  for (std::size_t column = 0; column < size; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < size; ++row)
      if (absolute(real_part(matrix[row * size + column])) > absolute(real_part(matrix[pivot * size + column])))
        pivot = row;
    if (pivot != column) {
      for (std::size_t c = 0; c < size; ++c) exchange_values(matrix[pivot * size + c], matrix[column * size + c]);
      for (std::size_t c = 0; c < columns; ++c)
        exchange_values(right_sides[pivot * columns + c], right_sides[column * columns + c]);
    }
    eliminate_column(matrix, size, column, right_sides, columns);
  }
  solve_backwards(matrix, size, right_sides, columns);
}

}  // namespace secular
