#pragma once

#include <cstddef>

#include "estimator/model/dense_solve.hpp"
#include "estimator/model/lanes.hpp"

/// What generated code needs of Lanes besides arithmetic.
namespace secular {

inline bool is_nonzero(const LaneParameter& x) {
  return x.is_nonzero;
}

/// Lane by lane, for each chooses its pivots.
inline void solve_lane_by_lane(Lanes* matrix, std::size_t size, Lanes* right_sides, std::size_t columns) {
  const std::size_t entries = size * size, sides = size * columns;
  double* const own = new double[entries + sides];  // the headers of generated code are light ones
  for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
    for (std::size_t i = 0; i < entries; ++i) own[i] = matrix[i][lane];
    for (std::size_t i = 0; i < sides; ++i) own[entries + i] = right_sides[i][lane];
    solve_in_place(own, size, own + entries, columns);
    for (std::size_t i = 0; i < sides; ++i) right_sides[i].set(lane, own[entries + i]);
  }
  delete[] own;
}

/// Elimination without pivoting where partial pivoting would exchange no rows in any lane; else what is left is of
/// no use. Whether it would not.
inline bool eliminated(Lanes* matrix, std::size_t size, Lanes* right_sides, std::size_t columns) {
  for (std::size_t column = 0; column < size; ++column) {
    for (std::size_t row = column + 1; row < size; ++row) {
      const Lanes below = absolute(matrix[row * size + column]), pivot = absolute(matrix[column * size + column]);
      for (std::size_t lane = 0; lane < Lanes::count; ++lane)
        if (!(below[lane] <= pivot[lane])) return false;
    }
    eliminate_column(matrix, size, column, right_sides, columns);
  }
  return true;
}

/// All lanes at once where none needs another pivot than its diagonal, as mass matrices of modes hardly ever do;
/// each to the last bit as alone.
inline void solve_in_place(Lanes* matrix, std::size_t size, Lanes* right_sides, std::size_t columns = 1) {
  constexpr std::size_t few = 3;
  Lanes tried[few * few], sides[few];
  if (size <= few && columns == 1) {
    for (std::size_t i = 0; i < size * size; ++i) tried[i] = matrix[i];
    for (std::size_t i = 0; i < size; ++i) sides[i] = right_sides[i];
    if (eliminated(tried, size, sides, 1)) {
      solve_backwards(tried, size, sides, 1);
      for (std::size_t i = 0; i < size; ++i) right_sides[i] = sides[i];
      return;
    }
  }
  solve_lane_by_lane(matrix, size, right_sides, columns);
}

}  // namespace secular
