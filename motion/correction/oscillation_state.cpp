#include "motion/correction/oscillation_state.hpp"

#include <complex>

#include "estimator/identification/predicted_harmonics.hpp"
#include "estimator/model/zero_frequency.hpp"
#include "measure/observe/observed_blocks.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

void add(Complex amplitude, Complex rate, double time, std::size_t mode, OscillationState& state) {
  const Complex value = amplitude * std::exp(rate * time);
  state.displacement[mode] += 2 * value.real();
  state.velocity[mode] += 2 * (rate * value).real();
}

OscillationState with_expansion(const CompiledModel& model, const CompiledCase& resonance,
                                const Eigen::VectorXd& parameters, const Observation& o, double time) {
  OscillationState state = at_rest(model);
  for (std::size_t k = 0; k < model.modes(); ++k) add(o.amplitude[k], o.rate[k], time, k, state);
  const std::vector<Complex> predicted = predicted_harmonics(model, resonance, parameters, o);
  for (std::size_t b = 0; b < resonance.blocks.size(); ++b) {
    const RegressorBlock& block = resonance.blocks[b];
    if (block.kind != BlockKind::harmonic) continue;
    const auto k = static_cast<std::size_t>(block.mode);
    if (is_zero_frequency(block)) {
      state.displacement[k] += predicted[b].real();
      continue;
    }
    add(predicted[b], Complex(0, block_frequency(block, o)), time, k, state);
  }
  return state;
}

}  // namespace

OscillationState at_rest(const CompiledModel& model) {
  return {std::vector<double>(model.modes(), 0.0), std::vector<double>(model.modes(), 0.0)};
}

OscillationStates::OscillationStates(const CompiledModel& model, const CompiledCase& resonance)
    : model_(model), resonance_(resonance), motions_(model, resonance) {}

OscillationState OscillationStates::at(const Eigen::VectorXd& parameters, const Observation& o, double time) const {
  const auto balanced = motions_.at(parameters, o);
  if (!balanced) return with_expansion(model_, resonance_, parameters, o, time);
  OscillationState state = at_rest(model_);
  for (std::size_t k = 0; k < model_.modes(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    state.displacement[k] = balanced->motion.displacement(row, 0).real();
    for (Eigen::Index l = 1; l < balanced->setting.torus->lines(); ++l)
      add(balanced->motion.displacement(row, l), balanced->setting.line_rate(l), time, k, state);
  }
  return state;
}

}  // namespace secular
