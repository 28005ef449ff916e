#include "codegen/canonical/zero_solution.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "codegen/canonical/cartesian_form.hpp"

namespace secular {
namespace {

int sum_of(const std::vector<int>& powers) {
  return std::accumulate(powers.begin(), powers.end(), 0);
}

bool couples(const ZeroSolution& zero, std::size_t k, std::size_t j) {
  return !zero.direct[k][j].empty() || !zero.conjugate[k][j].empty();
}

// Modes that act on each other, directly or by way of others.
std::vector<std::vector<std::size_t>> components(const ZeroSolution& zero, const CanonicalCase& resonance) {
  const std::size_t modes = zero.direct.size();
  std::vector<std::size_t> component(modes);
  std::iota(component.begin(), component.end(), std::size_t{0});
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t j = 0; j < modes; ++j)
      if (couples(zero, k, j)) std::replace(component.begin(), component.end(), component[k], component[j]);
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t label = 0; label < modes; ++label) {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < modes; ++k)
      if (component[k] == label && (resonance.mode_at_rest.empty() || !resonance.mode_at_rest[k]))
        members.push_back(k);
    if (!members.empty()) result.push_back(std::move(members));
  }
  return result;
}

ZeroSolution::Group::Kind kind_of(const ZeroSolution& zero, const std::vector<std::size_t>& modes) {
  using enum ZeroSolution::Group::Kind;
  if (modes.size() == 1) return zero.conjugate[modes[0]][modes[0]].empty() ? single : parametric;
  if (modes.size() > 2) return several;
  const std::size_t a = modes[0], b = modes[1];
  if (!zero.conjugate[a][a].empty() || !zero.conjugate[b][b].empty()) return several;
  const bool direct = !zero.direct[a][b].empty() || !zero.direct[b][a].empty(),
             conjugate = !zero.conjugate[a][b].empty() || !zero.conjugate[b][a].empty();
  return direct && conjugate ? several : direct ? difference : additive;
}

}  // namespace

ZeroSolution zero_solution(const CanonicalModel& model, const CanonicalCase& resonance) {
  ZeroSolution result;
  const std::size_t modes = model.coordinates.size();
  const std::vector<ComplexSum> row(modes);
  result.direct.assign(modes, row);
  result.conjugate.assign(modes, row);
  bool smooth = true;
  for (std::size_t k = 0; k < modes; ++k) {
    result.offset.push_back(frame_offset(resonance, k));
    for (const CanonicalTerm& term : resonance.slow_derivative[k]) {
      const CanonicalPowers& powers = term.powers;
      const int direct = sum_of(powers.amplitude), conjugate = sum_of(powers.conjugate),
                modulus = sum_of(powers.modulus);
      const bool factors = std::any_of(powers.modulus.begin(), powers.modulus.end(), [](int m) { return m != 0; });
      if (direct == 0 && conjugate == 0 && !factors) {
        result.kind = ZeroSolution::Kind::none;
        return result;
      }
      if (direct + conjugate + modulus > 1) continue;
      if (direct + conjugate != 1 || factors) {
        smooth = false;
        continue;
      }
      const std::vector<int>& which = direct == 1 ? powers.amplitude : powers.conjugate;
      const auto mode = static_cast<std::size_t>(std::find(which.begin(), which.end(), 1) - which.begin());
      ComplexSum& coefficient = (direct == 1 ? result.direct : result.conjugate)[k][mode];
      coefficient.real.add(powers.forcing, term.real);
      coefficient.imaginary.add(powers.forcing, term.imaginary);
    }
  }
  if (!resonance.quadratures.empty())
    result.kind = ZeroSolution::Kind::undecided;
  else if (!smooth)
    result.kind = ZeroSolution::Kind::not_differentiable;
  if (result.kind != ZeroSolution::Kind::linear) return result;
  for (std::vector<std::size_t>& members : components(result, resonance)) {
    const ZeroSolution::Group::Kind kind = kind_of(result, members);
    result.groups.push_back({kind, std::move(members)});
  }
  return result;
}

ZeroSolution::Pair ZeroSolution::pair(const Group& group) const {
  const std::size_t a = group.modes[0], b = group.modes[1];
  const bool additive = group.kind == Group::Kind::additive;
  const long sign = additive ? 1 : -1;
  Pair result;
  result.first_decay.add(direct[a][a].real, -1);
  result.second_decay.add(direct[b][b].real, -1);
  result.detuning = direct[a][a].imaginary;
  result.detuning.add(direct[b][b].imaginary, sign);
  for (std::size_t i = 0; i < offset[a].size(); ++i) {
    const CanonicalRatio &x = offset[a][i], &y = offset[b][i];
    const int above = -x.numerator * y.denominator - static_cast<int>(sign) * y.numerator * x.denominator,
              below = x.denominator * y.denominator, common = std::gcd(above, below);
    result.turning.push_back({above / common, below / common});
  }
  const ComplexSum &there = additive ? conjugate[a][b] : direct[a][b],
                   &back = additive ? conjugate[b][a] : direct[b][a];
  // there * back, or there * conj(back)
  result.exchange.real = there.real * back.real;
  result.exchange.real.add(there.imaginary * back.imaginary, sign);
  result.exchange.imaginary = there.imaginary * back.real;
  result.exchange.imaginary.add(there.real * back.imaginary, -sign);
  return result;
}

}  // namespace secular
