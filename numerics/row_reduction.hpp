#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace secular {

/// Where the leading one of a reduced row stands.
struct Pivot {
  std::size_t row = 0, column = 0;
};

/// Gauss-Jordan elimination over a field of exact numbers: reduced row echelon form in the columns from `first` to
/// before `last`, the others carried along. Rows are of one length.
template <typename Number>
std::vector<Pivot> reduce_rows(std::vector<std::vector<Number>>& rows, std::size_t first, std::size_t last) {
  const Number zero(0);
  std::vector<Pivot> pivots;
  for (std::size_t column = first; column < last && pivots.size() < rows.size(); ++column) {
    const std::size_t rank = pivots.size();
    std::size_t found = rank;
    while (found < rows.size() && rows[found][column] == zero) ++found;
    if (found == rows.size()) continue;
    std::swap(rows[found], rows[rank]);
    const Number lead = rows[rank][column];
    for (Number& entry : rows[rank]) entry = entry / lead;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == rank || rows[r][column] == zero) continue;
      const Number scale = rows[r][column];
      for (std::size_t c = 0; c < rows[r].size(); ++c) rows[r][c] = rows[r][c] - scale * rows[rank][c];
    }
    pivots.push_back({rank, column});
  }
  return pivots;
}

/// Solves linear equations exactly; a row holds an equation's coefficients and then its right side. Unknowns that
/// stay free are zero. Nothing if the equations contradict one another.
template <typename Number>
std::optional<std::vector<Number>> solve_exactly(std::vector<std::vector<Number>> rows, std::size_t unknowns) {
  const std::vector<Pivot> pivots = reduce_rows(rows, 0, unknowns);
  for (std::size_t r = pivots.size(); r < rows.size(); ++r)
    if (!(rows[r][unknowns] == Number(0))) return std::nullopt;
  std::vector<Number> solution(unknowns, Number(0));
  for (const Pivot& pivot : pivots) solution[pivot.column] = rows[pivot.row][unknowns];
  return solution;
}

}  // namespace secular
