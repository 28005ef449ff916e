#include "motion/correction/base_phases.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "estimator/model/locked_excitations.hpp"
#include "measure/observe/mode_frequencies.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

// Lines count by the phases of the modes, whose combinations they are: an excitation at omega1 + omega2 as a base
// phase would make a high line of 3*omega1 - omega2.
void count_by_modes(BasePhases& base, const ModeFrequencies& modes) {
  std::vector<LinePhase> own;
  for (std::size_t k = 0; k < base.mode.size(); ++k)
    if (modes.oscillates[k]) own.push_back(base.mode[k]);
  if (base.dimensions() != 2 || own.size() != 2) return;
  const LinePhase a = own[0], b = own[1];
  const int determinant = a[0] * b[1] - a[1] * b[0];
  if (std::abs(determinant) != 1) return;
  // n = x*a + y*b
  const auto counted = [&](const LinePhase& n) {
    return LinePhase{determinant * (n[0] * b[1] - n[1] * b[0]), determinant * (a[0] * n[1] - a[1] * n[0])};
  };
  Eigen::Matrix2d change;
  change << a[0], a[1], b[0], b[1];
  base.turns = change * base.turns;
  for (auto* list : {&base.mode, &base.excitation})
    for (LinePhase& phase : *list) phase = counted(phase);
}

}  // namespace

int BasePhases::highest() const {
  int n = 1;
  for (const auto* list : {&mode, &excitation})
    for (const LinePhase& phase : *list) n = std::max(n, std::abs(phase[0]) + std::abs(phase[1]));
  return n;
}

std::vector<Complex> BasePhases::rates(const Observation& o) const {
  const bool excited = !excitation.empty();
  std::vector<Complex> result;
  for (Index base = 0; base < turns.rows(); ++base) {
    Complex rate = 0;
    for (Index column = 0; column < turns.cols(); ++column) {
      const double share = turns(base, column);
      if (share == 0) continue;
      const auto k = static_cast<std::size_t>(column);
      rate += share * (k >= mode.size() ? Complex(0, o.excitation_frequency[k - mode.size()])
                       : excited        ? Complex(0, o.rate[k].imag())
                                        : o.rate[k]);
    }
    result.push_back(rate);
  }
  return result;
}

std::optional<BasePhases> base_phases(const CompiledModel& model, const CompiledCase& resonance) {
  const ModeFrequencies modes = mode_frequencies(model, resonance);
  const std::size_t width = model.modes() + model.excitations.size();
  const std::size_t excitations = resonance.excited ? model.excitations.size() : 0;
  const LockedExcitations locked(model, resonance);
  std::vector<std::size_t> columns;  // of the frequencies that a base phase is a part of
  for (std::size_t j = 0; j < excitations; ++j)
    if (!locked.follows(j)) columns.push_back(model.modes() + j);
  columns.insert(columns.end(), modes.free.begin(), modes.free.end());
  const std::size_t count = columns.size();
  if (count == 0 || count > 2) return std::nullopt;
  BasePhases base{std::vector<LinePhase>(model.modes()), std::vector<LinePhase>(excitations),
                  Eigen::MatrixXd::Zero(static_cast<Index>(count), static_cast<Index>(width))};
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t column = columns[j];
    const auto share = [&](std::size_t k) { return resonance.observed_frequency[k * width + column]; };
    int divisor = 1;
    for (std::size_t k = 0; k < model.modes(); ++k)
      if (modes.oscillates[k]) divisor = std::lcm(divisor, share(k).denominator);
    for (std::size_t e = 0; column >= model.modes() && e < excitations; ++e)
      divisor = std::lcm(divisor, locked.share(e, column - model.modes()).denominator);
    for (std::size_t k = 0; k < model.modes(); ++k)
      if (modes.oscillates[k]) base.mode[k][j] = share(k).numerator * divisor / share(k).denominator;
    if (column >= model.modes()) {
      const std::size_t leader = column - model.modes();
      for (std::size_t e = 0; e < excitations; ++e)
        base.excitation[e][j] = locked.share(e, leader).numerator * divisor / locked.share(e, leader).denominator;
    }
    base.turns(static_cast<Index>(j), static_cast<Index>(column)) = 1.0 / divisor;
  }
  count_by_modes(base, modes);
  return base;
}

}  // namespace secular
