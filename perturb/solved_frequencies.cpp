#include "perturb/solved_frequencies.hpp"

#include <utility>

namespace secular {
namespace {

// sum_j multiples_j f_j = right
template <class Number>
struct Row {
  std::vector<Number> multiples;
  EpsSeries<Number> right;
};

template <class Arithmetic>
std::vector<Row<typename Arithmetic::Number>> rows_of(const ResonanceCase& resonance, std::size_t frequencies,
                                                      const Arithmetic& arithmetic) {
  using Number = typename Arithmetic::Number;
  const std::size_t size = static_cast<std::size_t>(resonance.expand_to) + 1;
  std::vector<Row<Number>> rows;
  for (const ResonanceRelation& relation : resonance.relations) {
    Row<Number> row{std::vector<Number>(frequencies), EpsSeries<Number>(size)};
    for (std::size_t i = 0; i < relation.multiples.size(); ++i)
      row.multiples[i] = arithmetic.number(relation.multiples[i]);
    if (!relation.detuning.empty())
      row.right = eps_power(arithmetic.number(relation.coefficient) * arithmetic.symbol(relation.detuning),
                            static_cast<std::size_t>(relation.order), size);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

template <class Arithmetic>
std::vector<EpsSeries<typename Arithmetic::Number>> solved_frequencies(const Model& model,
                                                                       const ResonanceCase& resonance,
                                                                       const Arithmetic& arithmetic) {
  using Number = typename Arithmetic::Number;
  const std::size_t count = model.frequency_count(), size = static_cast<std::size_t>(resonance.expand_to) + 1;
  std::vector<Row<Number>> rows = rows_of(resonance, count, arithmetic);
  std::vector<std::pair<std::size_t, std::size_t>> pivots;  // row, frequency
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::size_t column = count;  // the last frequency not yet solved for, so that excitations come first
    while (column > 0 && rows[r].multiples[column - 1] == Number{}) --column;
    if (column == 0) continue;  // the lattice has refused dependent relations
    --column;
    const Number scale = Arithmetic::inverse(rows[r].multiples[column]);
    for (Number& multiple : rows[r].multiples) multiple *= scale;
    for (Number& value : rows[r].right) value *= scale;
    for (std::size_t other = 0; other < rows.size(); ++other) {
      if (other == r || rows[other].multiples[column] == Number{}) continue;
      const Number lead = rows[other].multiples[column];
      for (std::size_t i = 0; i < count; ++i) rows[other].multiples[i] += -(lead * rows[r].multiples[i]);
      for (std::size_t n = 0; n < size; ++n) rows[other].right[n] += -(lead * rows[r].right[n]);
      rows[other].multiples[column] = Number{};
    }
    pivots.emplace_back(r, column);
  }
  std::vector<Number> free;
  std::vector<EpsSeries<Number>> frequencies;
  for (std::size_t i = 0; i < count; ++i) {
    free.push_back(arithmetic.symbol(model.frequency_name(i)));
    frequencies.push_back(eps_power(free.back(), 0, size));
  }
  for (const auto& [r, column] : pivots) {
    frequencies[column] = rows[r].right;
    for (std::size_t i = 0; i < count; ++i)
      if (i != column) frequencies[column][0] += -(rows[r].multiples[i] * free[i]);
  }
  return frequencies;
}

template std::vector<EpsSeries<PrimeFieldComplex>> solved_frequencies(const Model&, const ResonanceCase&,
                                                                      const ExactArithmetic&);
template std::vector<EpsSeries<std::complex<double>>> solved_frequencies(const Model&, const ResonanceCase&,
                                                                         const FloatingArithmetic&);

}  // namespace secular
