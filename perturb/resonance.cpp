#include "perturb/resonance.hpp"

#include <algorithm>
#include <boost/rational.hpp>
#include <cmath>
#include <sstream>
#include <utility>

#include "input/input_error.hpp"
#include "numerics/row_reduction.hpp"

namespace secular {
namespace {

using Fraction = boost::rational<long long>;
using Fractions = std::vector<Fraction>;

// Solves sum_r x_r * rows[r] = target; nothing if there is no solution. Rows are independent.
std::optional<Fractions> solve(const std::vector<Phase>& rows, const Phase& target) {
  std::vector<Fractions> equations;
  for (std::size_t e = 0; e < target.size(); ++e) {
    Fractions& equation = equations.emplace_back();
    for (const Phase& row : rows) equation.emplace_back(row[e]);
    equation.emplace_back(target[e]);
  }
  return solve_exactly(std::move(equations), rows.size());
}

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
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
  const std::string place = resonance.place();
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
  refuse_impossible(model);
}

void ResonanceLattice::refuse_impossible(const Model& model) const {
  GiNaC::exmap numbers;
  for (std::size_t i = 0; i < model.frequency_count(); ++i) {
    const auto entry = model.nominal.find(model.frequency_name(i));
    if (entry != model.nominal.end()) numbers[model.frequency(i)] = entry->second;
  }
  // A frequency's nominal value, or what the relations make of it; nothing if it is open.
  const auto nominal = [&](std::size_t i) -> std::optional<double> {
    GiNaC::ex value = model.frequency(i).subs(numbers);
    if (i >= model.modes.size() && !GiNaC::is_a<GiNaC::numeric>(value))
      value = resonant_frequency_[i - model.modes.size()].subs(numbers).evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(value)) return std::nullopt;
    return GiNaC::ex_to<GiNaC::numeric>(value).to_double();
  };
  const auto place = [&](const ResonanceRelation& relation) {
    return "line " + std::to_string(relation.line) + ", case " + case_->name;
  };
  for (std::size_t r = 0; r < relations_.size(); ++r) {
    double sum = 0, largest = 0;
    bool known = true;
    std::string values;
    for (std::size_t i = 0; i < relations_[r].size(); ++i) {
      if (relations_[r][i] == 0) continue;
      const std::optional<double> value = nominal(i);
      known = known && value;
      if (!value) continue;
      if (*value < 0)
        throw InputError(model.file, place(case_->relations[r]),
                         "'" + case_->relations[r].text + "' makes " + model.frequency_name(i) +
                             " negative at the nominal frequencies",
                         "turn the signs of the relation, as in Omega = omega2 - omega1 for omega2 > omega1");
      sum += relations_[r][i] * *value;
      largest = std::max(largest, std::abs(relations_[r][i] * *value));
      values += (values.empty() ? "" : ", ") + model.frequency_name(i) + " = " + shown(*value);
    }
    if (known && std::abs(sum) > 0.2 * largest)
      throw InputError(model.file, place(case_->relations[r]),
                       "the resonance '" + case_->relations[r].text +
                           "' is impossible at the nominal frequencies (" + values + ")",
                       "correct the relation or the [nominal] table");
  }
}

std::optional<std::vector<int>> ResonanceLattice::slow_multipliers(const Phase& phase) const {
  const std::optional<Fractions> solution = solve(relations_, phase);
  if (!solution) return std::nullopt;
  std::vector<int> multipliers;
  for (const Fraction& x : *solution) {
    if (x.denominator() != 1)
      throw InputError(model_->file, case_->place(), "a relation is a multiple of the resonance that occurs",
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
  std::vector<Fractions> rows;
  for (std::size_t r = 0; r < relations_.size(); ++r) {
    Fractions row(relations_[r].begin(), relations_[r].end());
    row.resize(all + relations_.size(), Fraction(0));
    row[all + r] = 1;  // remembers which relations were combined
    rows.push_back(std::move(row));
  }
  std::vector<const Fractions*> solved(all, nullptr);
  for (const Pivot& pivot : reduce_rows(rows, natural, all)) solved[pivot.column] = &rows[pivot.row];
  const auto number = [](const Fraction& f) {
    return GiNaC::numeric(static_cast<long>(f.numerator()), static_cast<long>(f.denominator()));
  };
  for (std::size_t column = natural; column < all; ++column) {
    GiNaC::ex value = model.frequency(column);
    std::vector<GiNaC::numeric> offset(relations_.size(), 0);
    if (solved[column]) {
      const Fractions& row = *solved[column];
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
