#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

#include "input/input_error.hpp"
#include "input/stop_request.hpp"
#include "perturb/derivation.hpp"
#include "perturb/inverse_sums.hpp"
#include "perturb/motion_series.hpp"
#include "perturb/nonsmooth_terms.hpp"
#include "perturb/ordered_equation.hpp"
#include "perturb/small_divisors.hpp"
#include "perturb/solvability.hpp"
#include "perturb/time_scales.hpp"

namespace secular {
namespace {

// Order by order: what forces each oscillator, from what is known by then (MotionSeries); its secular part goes to
// D_n A_k (split_forcing), the rest to the response.
class MultipleScales {
 public:
  MultipleScales(Derivation& derivation, ProductCount products)
      : d_(derivation),
        model_(*derivation.model),
        resonance_(*derivation.resonance),
        equations_(ordered_equations(model_, resonance_)),
        rates_(phase_rates(model_, resonance_, d_.lattice, d_.policy == OmegaPolicy::nominal)),
        motion_(rates_, resonance_.expand_to, resonance_.mode_at_rest, products) {}

  void run() {
    const std::size_t modes = d_.layout.modes, size = static_cast<std::size_t>(resonance_.expand_to) + 1;
    d_.response.assign(modes, FieldSeries(size));
    d_.slow_derivative.assign(modes, FieldSeries(size));
    for (std::size_t k = 0; k < modes; ++k) lead(k);
    set_quadratures_apart();
    d_.nonsmooth_harmonics = complete_harmonics(equations_, model_, resonance_);
    for (int order = 1; order <= resonance_.expand_to; ++order) {
      motion_.update(d_.response, d_.slow_derivative, order - 1);  // now that it is solved
      motion_.update(d_.response, d_.slow_derivative, order);
      std::vector<Field> forcing(modes);
      for (std::size_t k = 0; k < modes; ++k) forcing[k] = right_hand_side(k, order).with_moduli_joined(d_.layout);
      for (std::size_t k = 0; k < modes; ++k) solve(k, order, forcing[k]);
    }
    for (auto* fields : {&d_.response, &d_.slow_derivative})
      for (FieldSeries& series : *fields)
        for (Field& field : series) field = inverses_.written_out(field);
    d_.warnings = small_divisor_warnings(d_);
    for (const ResonanceRelation& relation : resonance_.relations)
      if (!relation.detuning.empty() && relation.order > resonance_.expand_to)
        d_.warnings.push_back(fmt::format(
            "the detuning {} is of order eps^{}, and the case expands to eps^{}: what it changes in harmonics and "
            "coefficients is left out; write eps^{}*{}",
            relation.detuning, relation.order, resonance_.expand_to, resonance_.expand_to, relation.detuning));
  }

 private:
  // Order 0: the free oscillation, and what excitation terms of order 0 (hard forcing) add to it.
  void lead(std::size_t k) {
    Field& leading = d_.response[k][0];
    if (!resonance_.mode_at_rest[k])
      for (const int sign : {1, -1}) {
        FieldKey key(d_.layout.size(), 0);
        key[k] = sign;
        key[sign > 0 ? d_.layout.amplitude(k) : d_.layout.conjugate(k)] = 1;
        leading.add(key, 1);
      }
    const Field forcing = right_hand_side(k, 0);
    for (const auto& [key, coefficient] : forcing.terms()) {
      Phase relative = d_.full_phase(key);
      --relative[k];
      if (d_.lattice.slow_multipliers(relative))
        throw InputError(model_.file, resonance_.place(),
                         "forcing of order eps^0 excites mode '" + model_.modes[k].coordinate + "' at resonance",
                         "give the coefficient of the direct excitation a positive order");
      leading.add(key, coefficient * inverse_divisor(key, k));
    }
  }

  void set_quadratures_apart() {
    std::vector<bool> sinusoidal;
    for (std::size_t k = 0; k < d_.layout.modes; ++k)
      sinusoidal.push_back(d_.response[k][0].terms().size() <= (resonance_.mode_at_rest[k] ? 0U : 2U));
    for (std::size_t k = 0; k < d_.layout.modes; ++k) {
      NonsmoothTerms terms = tell_nonsmooth_apart(equations_[k], k, model_, resonance_, sinusoidal);
      equations_[k].right_hand_side = std::move(terms.expanded);
      d_.quadratures.insert(d_.quadratures.end(), terms.quadratures.begin(), terms.quadratures.end());
    }
  }

  // What the equation of mode k has at eps^order besides its own oscillator and D_order A, all moved to the right.
  Field right_hand_side(std::size_t k, int order) const {
    Field sum;
    if (order > 0) sum += motion_.coordinate(k, 2)[static_cast<std::size_t>(order)].scaled(-1);
    for (const OrderedTerm& term : equations_[k].right_hand_side) {
      if (term.order > order) continue;
      end_if_stopped();
      try {
        sum += motion_.product(term.factors, order - term.order).scaled(term.coefficient);
      } catch (const std::length_error& error) {
        throw InputError(model_.file, resonance_.place(),
                         "equation of '" + model_.modes[k].coordinate + "', term " +
                             to_string(term.factors, model_) + " at eps^" + std::to_string(order) + ": it " +
                             error.what(),
                         "lower expand_to or the degree of the equation, or give high powers a higher order");
      }
    }
    return sum;
  }

  void solve(std::size_t k, int order, const Field& forcing) {
    const auto n = static_cast<std::size_t>(order);
    const SplitForcing split = split_forcing(inverses_.cleaned(forcing), k, d_.layout, d_.lattice);
    if (resonance_.mode_at_rest[k] && !split.secular.empty())
      throw InputError(
          model_.file, resonance_.place(),
          "mode '" + model_.modes[k].coordinate + "' is listed in modes_at_rest but is excited at resonance",
          "remove it from modes_at_rest");
    d_.slow_derivative[k][n] = split.secular.scaled(1 / (2 * GiNaC::I * rates_.fast[k]));
    for (const auto& [key, coefficient] : split.oscillating.terms())
      if (!beyond_complete_harmonics(key, n))
        d_.response[k][n].add(key, inverses_.cleaned(coefficient * inverse_divisor(key, k)));
  }

  // 1/(omega_k^2 - (phase.f)^2), factored so that it stays small.
  GiNaC::ex inverse_divisor(const FieldKey& key, std::size_t k) {
    const GiNaC::ex frequency = rates_.on_fast_scale(key);
    const GiNaC::ex low = (rates_.fast[k] - frequency).expand(), high = (rates_.fast[k] + frequency).expand();
    if (low.is_zero() || high.is_zero())
      throw InputError(model_.file, resonance_.place(),
                       "division by zero for mode '" + model_.modes[k].coordinate + "'",
                       "the relations hide a resonance: list it");
    return inverses_.inverse(low) * inverses_.inverse(high);
  }

  bool beyond_complete_harmonics(const FieldKey& key, std::size_t order) const {
    bool nonsmooth = false, beyond = false;
    for (std::size_t k = 0; k < d_.layout.modes; ++k) {
      nonsmooth = nonsmooth || key[d_.layout.modulus(k)] % 2 != 0;
      beyond = beyond || std::abs(key[k]) > d_.nonsmooth_harmonics[order];
    }
    return nonsmooth && beyond;
  }

  Derivation& d_;
  const Model& model_;
  const ResonanceCase& resonance_;
  std::vector<OrderedEquation> equations_;
  PhaseRates rates_;
  MotionSeries motion_;
  InverseSums inverses_;
};

}  // namespace

Field Derivation::modulation(std::size_t mode) const {
  Field sum;
  for (const Field& field : slow_derivative[mode]) sum += field;
  return sum;
}

GiNaC::ex Derivation::quadrature_rate(const QuadratureTerm& quadrature) const {
  return (quadrature.coefficient / (2 * GiNaC::I * model->frequency(quadrature.mode))).expand();
}

Phase Derivation::full_phase(const FieldKey& key) const {
  return secular::full_phase(key, layout, lattice);
}

Derivation derive(const Model& model, const ResonanceCase& resonance, OmegaPolicy policy, ProductCount products) {
  Derivation derivation{&model,
                        &resonance,
                        policy,
                        FieldLayout{model.modes.size(), model.excitations.size(), resonance.relations.size()},
                        ResonanceLattice(model, resonance),
                        {},
                        {},
                        {},
                        {},
                        {}};
  MultipleScales(derivation, products).run();
  return derivation;
}

}  // namespace secular
