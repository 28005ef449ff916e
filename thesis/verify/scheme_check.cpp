#include "thesis/verify/scheme_check.hpp"

#include "perturb/ordered_equation.hpp"

namespace secular::verify {
namespace {

using GiNaC::ex;

ex leading_factor(const PrintedFormula& formula, const Factor& factor) {
  const auto index = static_cast<std::size_t>(factor.index);
  switch (factor.kind) {
    case Factor::Kind::coordinate:
      return formula.unknown(index, 0, {factor.derivative, 0, 0});
    case Factor::Kind::excitation:
      return formula.excitation(index, factor.derivative);
    case Factor::Kind::clock_cos:
    case Factor::Kind::clock_sin:
      return formula.clock(index, factor.multiple, factor.kind == Factor::Kind::clock_cos);
    case Factor::Kind::absolute:
    case Factor::Kind::sign:
      return formula.absolute(formula.unknown(index, 0, {factor.derivative, 0, 0}));
    case Factor::Kind::smooth:
      break;  // expanded by ordered_equations()
  }
  return 0;
}

}  // namespace

ex ordered_motion(const PrintedFormula& formula, const Derivation& derivation, std::size_t mode) {
  const ex& eps = formula.symbol("eps");
  ex left = formula.unknown(mode, 0, {2, 0, 0}) +
            GiNaC::pow(derivation.model->frequency(mode), 2) * formula.unknown(mode, 0, {0, 0, 0});
  const std::vector<OrderedEquation> equations = ordered_equations(*derivation.model, *derivation.resonance);
  for (const OrderedTerm& term : equations[mode].right_hand_side) {
    ex product = GiNaC::pow(eps, term.order) * term.coefficient;
    for (const auto& [factor, power] : term.factors) product *= GiNaC::pow(leading_factor(formula, factor), power);
    left -= product;
  }
  return left;
}

ex expansion(const PrintedFormula& formula, const Derivation& derivation, std::size_t mode) {
  ex sum = 0;
  for (int n = 0; n <= derivation.resonance->expand_to; ++n)
    sum += GiNaC::pow(formula.symbol("eps"), n) * formula.unknown(mode, static_cast<std::size_t>(n), {0, 0, 0});
  return sum;
}

ex time_derivative(const PrintedFormula& formula, int order) {
  ex sum = 0;
  for (int first = 0; first <= 2; ++first)
    for (int second = 0; second <= (order == 1 ? 0 : 2 - first); ++second) {
      std::vector<int> derivatives(3, 0);
      ++derivatives[static_cast<std::size_t>(first)];
      if (order == 2) ++derivatives[static_cast<std::size_t>(second)];
      sum += GiNaC::pow(formula.symbol("eps"), first + second) * formula.unknown(0, 0, derivatives);
    }
  return sum;
}

GiNaC::exmap detuned_frequencies(const PrintedFormula& formula, const Derivation& derivation) {
  const Model& model = *derivation.model;
  GiNaC::exmap frequencies;
  for (std::size_t j = 0; j < model.excitations.size(); ++j) {
    ex frequency = derivation.lattice.resonant_frequency(j);
    for (std::size_t r = 0; r < derivation.resonance->relations.size(); ++r) {
      const ResonanceRelation& relation = derivation.resonance->relations[r];
      frequency += derivation.lattice.resonant_offset(j)[r] * GiNaC::pow(formula.symbol("eps"), relation.order) *
                   model.symbols.at(relation.detuning);
    }
    frequencies[model.frequency(model.modes.size() + j)] = frequency;
  }
  return frequencies;
}

GiNaC::exmap turned_phases(const PrintedFormula& formula, const std::vector<int>& slow_turns,
                           const std::vector<int>& phase_turns) {
  std::vector<ex> factors;
  std::vector<int> turns;
  for (std::size_t r = 0; r < slow_turns.size(); ++r) {
    factors.push_back(formula.slow_wave(r));
    turns.push_back(slow_turns[r]);
  }
  for (std::size_t k = 0; k < phase_turns.size(); ++k) {
    factors.push_back(formula.phase_factor(k));
    turns.push_back(phase_turns[k]);
  }
  std::size_t last = turns.size();  // what makes up for the others' turns
  for (std::size_t n = 0; n < turns.size(); ++n)
    if (turns[n] != 0) last = n;
  GiNaC::exmap turned;
  ex made_up = 1;
  for (std::size_t n = 0; n < turns.size(); ++n) {
    if (n == last) continue;
    const ex free = GiNaC::realsymbol("turn" + std::to_string(n));
    turned[factors[n]] = factors[n] * GiNaC::pow(free, last < turns.size() ? turns[last] : 1);
    made_up *= GiNaC::pow(free, -turns[n]);
  }
  if (last < turns.size()) turned[factors[last]] = factors[last] * made_up;
  return turned;
}

}  // namespace secular::verify
