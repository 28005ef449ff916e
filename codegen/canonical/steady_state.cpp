#include "codegen/canonical/steady_state.hpp"

#include <set>
#include <utility>

#include "codegen/canonical/polar_form.hpp"

namespace secular {

SteadyState steady_state(const CanonicalModel& model, const CanonicalCase& resonance) {
  SteadyState result;
  if (model.coordinates.size() != 1) return result;
  using Angle = std::pair<int, std::vector<int>>;
  std::set<Angle> angles;
  for (const CanonicalTerm& term : resonance.slow_derivative[0]) {
    const CanonicalPowers& p = term.powers;
    const int beta = p.amplitude[0] - p.conjugate[0] - 1;
    if (beta != 0) angles.insert({beta, p.slow_phase});
    const int degree = p.amplitude[0] + p.conjugate[0] + p.modulus[0];
    const long up = degree < 1 ? 1L << (1 - degree) : 1, down = degree > 1 ? 1L << (degree - 1) : 1;
    const auto add = [&](std::vector<SteadyTerm>& sum, const RationalFunction& part) {
      if (!part.is_zero()) sum.push_back({scaled(part, up, down), degree, p.forcing});
    };
    add(beta != 0 ? result.turning_real : result.still_real, term.real);
    add(beta != 0 ? result.turning_imaginary : result.still_imaginary, term.imaginary);
  }
  result.kind = angles.empty()       ? SteadyState::Kind::free
                : angles.size() == 1 ? SteadyState::Kind::one_angle
                                     : SteadyState::Kind::several_angles;
  return result;
}

}  // namespace secular
