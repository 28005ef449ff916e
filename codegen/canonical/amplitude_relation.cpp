#include "codegen/canonical/amplitude_relation.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "codegen/canonical/polar_form.hpp"

namespace secular {
namespace {

using Angle = std::pair<int, std::vector<int>>;  // multiple of beta, multiples of the slow phases

Angle opposite(Angle angle) {
  angle.first = -angle.first;
  for (int& multiple : angle.second) multiple = -multiple;
  return angle;
}

VariableSum square(const VariableSum& sum) {
  return sum * sum;
}

// Common power n of one excitation in all turning terms, none of it elsewhere.
std::optional<AmplitudeRelation::Force> force(const AmplitudeRelation& r) {
  for (std::size_t j = 0; j < r.variables.excitations; ++j) {
    const std::size_t forcing = AmplitudeVariables::forcing(j);
    if (r.still_real.depends_on_variable(forcing) || r.still_imaginary.depends_on_variable(forcing)) continue;
    std::set<int> powers;
    for (const VariableSum* sum : {&r.turning_real, &r.turning_imaginary})
      for (const auto& [exponents, parts] : sum->terms()) powers.insert(exponents[forcing]);
    if (powers.size() != 1 || *powers.begin() < 1) continue;
    const int power = *powers.begin();
    return AmplitudeRelation::Force{j, power, r.turning_real.times_power(forcing, -power),
                                    r.turning_imaginary.times_power(forcing, -power)};
  }
  return std::nullopt;
}

bool free_of_frequencies(const AmplitudeRelation& r, const CanonicalModel& model, const CanonicalCase& resonance) {
  std::vector<std::string> moving = model.excitation_frequencies;
  for (const CanonicalRelation& relation : resonance.relations) moving.push_back(relation.detuning);
  for (std::size_t i = 0; i < model.order.size(); ++i) {
    if (std::find(moving.begin(), moving.end(), model.order[i]) == moving.end()) continue;
    for (const VariableSum* sum : {&r.still_real, &r.still_imaginary, &r.turning_real, &r.turning_imaginary})
      if (sum->depends_on_symbol(i)) return false;
  }
  return true;
}

}  // namespace

AmplitudeRelation amplitude_relation(const CanonicalModel& model, const CanonicalCase& resonance) {
  AmplitudeRelation result;
  if (model.coordinates.size() != 1) return result;
  result.variables = {model.excitations.size()};
  result.complete = resonance.quadratures.empty();
  std::optional<Angle> first;
  for (const CanonicalTerm& term : resonance.slow_derivative[0]) {
    const CanonicalPowers& p = term.powers;
    const Angle angle{p.amplitude[0] - p.conjugate[0] - 1, p.slow_phase};
    const bool still = angle.first == 0;
    if (!still && !first) first = angle.first < 0 ? angle : opposite(angle);
    const bool turning = !still && angle == *first;
    if (!still && !turning && angle != opposite(*first)) return {};
    // 2 A -> a (1/2)^(degree - 1)
    const int degree = p.amplitude[0] + p.conjugate[0] + p.modulus[0];
    const long up = degree < 1 ? 1L << (1 - degree) : 1, down = degree > 1 ? 1L << (degree - 1) : 1;
    VariableSum::Powers powers{degree, 0};
    powers.insert(powers.end(), p.forcing.begin(), p.forcing.end());
    (still     ? result.still_real
     : turning ? result.turning_real
               : result.opposite_real)
        .add(powers, scaled(term.real, up, down));
    (still     ? result.still_imaginary
     : turning ? result.turning_imaginary
               : result.opposite_imaginary)
        .add(powers, scaled(term.imaginary, up, down));
  }
  if (!first) return result;
  if (result.turning_real.empty() && result.turning_imaginary.empty()) {
    std::swap(result.turning_real, result.opposite_real);
    std::swap(result.turning_imaginary, result.opposite_imaginary);
  }
  const bool one_angle = result.opposite_real.empty() && result.opposite_imaginary.empty();
  result.kind = one_angle ? AmplitudeRelation::Kind::one_angle : AmplitudeRelation::Kind::opposite_angles;
  VariableSum detuned = result.still_imaginary;  // T - a d
  VariableSum::Powers turned(result.variables.count(), 0);
  turned[AmplitudeVariables::amplitude] = turned[AmplitudeVariables::offset] = 1;
  const std::vector<int> none(model.order.size(), 0);
  detuned.add(turned, {{{"-1", none}}, {{"1", none}}});
  if (one_angle) {
    result.relation = square(result.still_real) + square(detuned) - square(result.turning_real) -
                      square(result.turning_imaginary);
    result.force = force(result);
    result.detuning_is_explicit = free_of_frequencies(result, model, resonance);
  } else {
    const VariableSum u_plus = result.turning_real + result.opposite_real,
                      u_minus = result.turning_real - result.opposite_real,
                      v_plus = result.turning_imaginary + result.opposite_imaginary,
                      v_minus = result.turning_imaginary - result.opposite_imaginary;
    result.relation = square(result.still_real * u_minus + detuned * v_minus) +
                      square(detuned * u_plus - result.still_real * v_plus) -
                      square(u_plus * u_minus + v_plus * v_minus);
  }
  result.divided = result.relation.lowest_power(AmplitudeVariables::amplitude);
  result.relation = result.relation.times_power(AmplitudeVariables::amplitude, -result.divided);
  result.fold = result.relation.derivative(AmplitudeVariables::amplitude);
  return result;
}

}  // namespace secular
