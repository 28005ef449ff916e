#include "perturb/resonance.hpp"

#include <algorithm>
#include <boost/rational.hpp>
#include <utility>

#include "input/input_error.hpp"

namespace secular {
namespace {

using Fraction = boost::rational<long long>;
using Row = std::vector<Fraction>;

// Solves sum_r x_r * rows[r] = target; nothing if there is no solution. Rows are independent.
std::optional<Row> solve(const std::vector<Phase>& rows, const Phase& target) {
  const std::size_t unknowns = rows.size(), equations = target.size();
  std::vector<Row> system(equations, Row(unknowns + 1));
  for (std::size_t e = 0; e < equations; ++e) {
    for (std::size_t r = 0; r < unknowns; ++r) system[e][r] = rows[r][e];
    system[e][unknowns] = target[e];
  }
  std::size_t rank = 0;
  for (std::size_t column = 0; column < unknowns; ++column) {
    std::size_t pivot = rank;
    while (pivot < equations && system[pivot][column] == Fraction(0)) ++pivot;
    if (pivot == equations) return std::nullopt;
    std::swap(system[pivot], system[rank]);
    const Fraction lead = system[rank][column];
    for (Fraction& entry : system[rank]) entry /= lead;
    for (std::size_t e = 0; e < equations; ++e) {
      if (e == rank || system[e][column] == Fraction(0)) continue;
      const Fraction scale = system[e][column];
      for (std::size_t c = 0; c <= unknowns; ++c) system[e][c] -= scale * system[rank][c];
    }
    ++rank;
  }
  for (std::size_t e = rank; e < equations; ++e)
    if (system[e][unknowns] != Fraction(0)) return std::nullopt;
  Row solution(unknowns);
  for (std::size_t r = 0; r < unknowns; ++r) solution[r] = system[r][unknowns];
  return solution;
}

bool independent(const std::vector<Phase>& rows) {
  for (std::size_t i = 1; i <= rows.size(); ++i) {
    const std::vector<Phase> earlier(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(i - 1));
    if (solve(earlier, rows[i - 1])) return false;
  }
  return true;
}

}  // namespace

ResonanceLattice::ResonanceLattice(const Model& model, const ResonanceCase& resonance)
    : model_(&model), case_(&resonance) {
  for (const ResonanceRelation& relation : resonance.relations) {
    // A relation read before an excitation frequency was known is shorter.
    Phase row = relation.multiples;
    row.resize(model.frequency_count(), 0);
    relations_.push_back(std::move(row));
  }
  const std::string place = "line " + std::to_string(resonance.line) + ", case " + resonance.name;
  if (!independent(relations_))
    throw InputError(model.file, place, "its relations repeat or contradict one another",
                     "list every resonance once, each with its own detuning");
  for (std::size_t i = 0; i < model.frequency_count(); ++i) {
    Phase single(model.frequency_count(), 0);
    single[i] = 1;
    if (solve(relations_, single))
      throw InputError(model.file, place, "its relations together make " + model.frequency_name(i) + " zero",
                       "remove the relation that does not hold");
  }
  solve_excitation_frequencies(model);
}

std::optional<std::vector<int>> ResonanceLattice::slow_multipliers(const Phase& phase) const {
  const std::optional<Row> solution = solve(relations_, phase);
  if (!solution) return std::nullopt;
  std::vector<int> multipliers;
  for (const Fraction& x : *solution) {
    if (x.denominator() != 1)
      throw InputError(model_->file, "line " + std::to_string(case_->line) + ", case " + case_->name,
                       "a relation is a multiple of the resonance that occurs",
                       "divide the relation by its common factor");
    multipliers.push_back(static_cast<int>(x.numerator()));
  }
  return multipliers;
}

Phase ResonanceLattice::phase_of(const std::vector<int>& multipliers) const {
  Phase phase(model_->frequency_count(), 0);
  for (std::size_t r = 0; r < relations_.size(); ++r)
    for (std::size_t i = 0; i < phase.size(); ++i) phase[i] += multipliers[r] * relations_[r][i];
  return phase;
}

// Gauss-Jordan on the excitation columns only: Omega_j = sum of natural frequencies + detunings.
void ResonanceLattice::solve_excitation_frequencies(const Model& model) {
  const std::size_t natural = model.modes.size(), all = model.frequency_count();
  std::vector<Row> rows;
  for (std::size_t r = 0; r < relations_.size(); ++r) {
    Row row(relations_[r].begin(), relations_[r].end());
    row.resize(all + relations_.size(), Fraction(0));
    row[all + r] = 1;  // remembers which relations were combined
    rows.push_back(std::move(row));
  }
  std::vector<int> pivot_row(all, -1);
  std::size_t rank = 0;
  for (std::size_t column = natural; column < all; ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column] == Fraction(0)) ++pivot;
    if (pivot >= rows.size()) continue;
    std::swap(rows[pivot], rows[rank]);
    const Fraction lead = rows[rank][column];
    for (Fraction& entry : rows[rank]) entry /= lead;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == rank || rows[r][column] == Fraction(0)) continue;
      const Fraction scale = rows[r][column];
      for (std::size_t c = 0; c < rows[r].size(); ++c) rows[r][c] -= scale * rows[rank][c];
    }
    pivot_row[column] = static_cast<int>(rank++);
  }
  const auto number = [](const Fraction& f) {
    return GiNaC::numeric(static_cast<long>(f.numerator()), static_cast<long>(f.denominator()));
  };
  for (std::size_t column = natural; column < all; ++column) {
    GiNaC::ex value = model.frequency(column);
    std::vector<GiNaC::numeric> offset(relations_.size(), 0);
    if (pivot_row[column] >= 0) {
      const Row& row = rows[static_cast<std::size_t>(pivot_row[column])];
      value = 0;
      for (std::size_t c = 0; c < all; ++c)
        if (c != column && row[c] != Fraction(0)) value -= number(row[c]) * model.frequency(c);
      for (std::size_t r = 0; r < relations_.size(); ++r)
        offset[r] = number(row[all + r]) * case_->relations[r].coefficient;
    }
    resonant_frequency_.push_back(value);
    resonant_offset_.push_back(std::move(offset));
  }
}

}  // namespace secular
