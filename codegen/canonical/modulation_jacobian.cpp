#include "codegen/canonical/modulation_jacobian.hpp"

#include <algorithm>

#include "codegen/canonical/cartesian_form.hpp"

namespace secular {
namespace {

VariableSum rate(const CartesianVariables& variables, const std::vector<CartesianTerm>& terms) {
  VariableSum result;
  for (const CartesianTerm& term : terms) {
    VariableSum::Powers powers(variables.count(), 0);
    for (std::size_t k = 0; k < variables.modes; ++k) {
      powers[variables.x(k)] = term.x[k];
      powers[variables.y(k)] = term.y[k];
      powers[variables.norm(k)] = 2 * term.norm_squared[k] + term.norm[k];
    }
    for (std::size_t j = 0; j < variables.excitations; ++j) powers[variables.forcing(j)] = term.forcing[j];
    result.add(powers, term.coefficient);
  }
  return result;
}

void add_product(VariableSum& sum, const CartesianVariables& variables, std::size_t left, std::size_t right,
                 const RationalFunction& coefficient) {
  VariableSum::Powers powers(variables.count(), 0);
  ++powers[left];
  ++powers[right];
  sum.add(powers, coefficient);
}

// By x or y of a mode: dr/dx = x/r.
VariableSum derivative(const VariableSum& sum, std::size_t along, std::size_t norm) {
  return sum.derivative(along) + sum.derivative(norm).times_power(norm, -1).times_power(along, 1);
}

}  // namespace

ModulationJacobian modulation_jacobian(const CanonicalModel& model, const CanonicalCase& resonance) {
  ModulationJacobian result;
  CartesianVariables& variables = result.variables;
  variables = {model.coordinates.size(), model.excitations.size()};
  result.complete = resonance.quadratures.empty();
  const std::vector<int> none(model.order.size(), 0);
  const RationalFunction one{{{"1", none}}, {{"1", none}}}, minus_one{{{"-1", none}}, {{"1", none}}};
  for (std::size_t k = 0; k < variables.modes; ++k) {
    const CartesianEquations equations = cartesian_equations(model, resonance, k);
    for (const std::vector<CartesianTerm>* terms : {&equations.x_rate, &equations.y_rate})
      for (const CartesianTerm& term : *terms)
        if (std::any_of(term.norm.begin(), term.norm.end(), [](int power) { return power % 2 != 0; }))
          result.regular_at_zero = false;
    result.right_side.push_back(rate(variables, equations.x_rate));
    result.right_side.push_back(rate(variables, equations.y_rate));
    const std::vector<CanonicalRatio> offset = frame_offset(resonance, k);
    if (std::all_of(offset.begin(), offset.end(), [](const CanonicalRatio& r) { return r.numerator == 0; }))
      continue;
    add_product(result.right_side[2 * k], variables, variables.offset(k), variables.y(k), one);
    add_product(result.right_side[2 * k + 1], variables, variables.offset(k), variables.x(k), minus_one);
  }
  for (const VariableSum& right_side : result.right_side) {
    result.entry.emplace_back();
    for (std::size_t k = 0; k < variables.modes; ++k)
      for (const std::size_t along : {variables.x(k), variables.y(k)})
        result.entry.back().push_back(derivative(right_side, along, variables.norm(k)));
  }
  return result;
}

}  // namespace secular
