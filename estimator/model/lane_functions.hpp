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
inline void solve_in_place(Lanes* matrix, std::size_t size, Lanes* right_sides, std::size_t columns = 1) {
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

}  // namespace secular
