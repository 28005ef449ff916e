#include "simulate/oscillation_state.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include "estimator/identification/equation_data.hpp"
#include "estimator/identification/predicted_harmonics.hpp"
#include "simulate/base_phases.hpp"
#include "simulate/motion_balance.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Highest line by the highest one on which a mode or a force is; and points of a turn.
constexpr int multiples_of_one = 8, multiples_of_two = 3;
constexpr Index points_by_line = 4;

/// A line of either sign: the torus holds one of each pair.
struct SignedLine {
  Index line = 0;
  bool conjugate = false;

  Complex of(Complex amplitude) const { return conjugate ? std::conj(amplitude) : amplitude; }
};

SignedLine signed_line(const Torus& torus, const LinePhase& phase) {
  if (const auto line = torus.find(phase)) return {*line, false};
  return {torus.find({-phase[0], -phase[1]}).value(), true};
}

OscillationState at_rest(const CompiledModel& model) {
  return {std::vector<double>(model.modes(), 0.0), std::vector<double>(model.modes(), 0.0)};
}

void add(Complex amplitude, Complex rate, double time, std::size_t mode, OscillationState& state) {
  const Complex value = amplitude * std::exp(rate * time);
  state.displacement[mode] += 2 * value.real();
  state.velocity[mode] += 2 * (rate * value).real();
}

OscillationState modes_alone(const CompiledModel& model, const Observation& o, double time) {
  OscillationState state = at_rest(model);
  for (std::size_t k = 0; k < model.modes(); ++k) add(o.amplitude[k], o.rate[k], time, k, state);
  return state;
}

OscillationState with_expansion(const CompiledModel& model, const CompiledCase& resonance,
                                const Eigen::VectorXd& parameters, const Observation& o, double time) {
  OscillationState state = modes_alone(model, o, time);
  const std::vector<Complex> predicted = predicted_harmonics(model, resonance, parameters, o);
  for (std::size_t b = 0; b < resonance.blocks.size(); ++b) {
    const RegressorBlock& block = resonance.blocks[b];
    if (block.kind != BlockKind::harmonic) continue;
    const auto k = static_cast<std::size_t>(block.mode);
    if (is_zero_frequency(block)) {
      state.displacement[k] += predicted[b].real();
      continue;
    }
    double frequency = 0;
    for (std::size_t i = 0; i < block.phase.size(); ++i)  // a decay has no excitation, and no phase of one
      if (block.phase[i] != 0)
        frequency +=
            block.phase[i] * (i < model.modes() ? o.rate[i].imag() : o.excitation_frequency[i - model.modes()]);
    add(predicted[b], Complex(0, frequency), time, k, state);
  }
  return state;
}

std::optional<OscillationState> balanced(const CompiledModel& model, const CompiledCase& resonance,
                                         const Eigen::VectorXd& parameters, const Observation& o, double time) {
  const auto base = base_phases(model, resonance, o);
  if (!base) return std::nullopt;
  const auto dimensions = static_cast<int>(base->rate.size());
  const int highest = base->highest() * (dimensions == 1 ? multiples_of_one : multiples_of_two);
  MotionSetting setting;
  setting.torus = std::make_shared<const Torus>(dimensions, highest, points_by_line * highest);
  for (std::size_t j = 0; j < base->rate.size(); ++j) setting.rate[j] = base->rate[j];
  setting.excitation = Eigen::MatrixXcd::Zero(static_cast<Index>(model.excitations.size()), setting.torus->lines());
  for (std::size_t j = 0; j < base->excitation.size(); ++j) {
    const SignedLine line = signed_line(*setting.torus, base->excitation[j]);
    setting.excitation(static_cast<Index>(j), line.line) = 0.5 * line.of(o.forcing[j]);  // half of the peak
  }
  std::vector<Complex> amplitudes;
  for (std::size_t k = 0; k < model.modes(); ++k) {
    if (base->mode[k] == LinePhase{}) continue;  // at rest
    const SignedLine line = signed_line(*setting.torus, base->mode[k]);
    setting.masters.push_back({k, line.line});
    amplitudes.push_back(line.of(o.amplitude[k]));
  }
  const Motion motion = MotionBalance(model, {}).solve(
      setting, Eigen::Map<const Eigen::VectorXcd>(amplitudes.data(), static_cast<Index>(amplitudes.size())),
      std::span(parameters.data(), static_cast<std::size_t>(parameters.size())));
  if (!motion.converged) return std::nullopt;
  OscillationState state = at_rest(model);
  for (std::size_t k = 0; k < model.modes(); ++k) {
    const auto row = static_cast<Index>(k);
    state.displacement[k] = motion.displacement(row, 0).real();
    for (Index l = 1; l < setting.torus->lines(); ++l)
      add(motion.displacement(row, l), setting.line_rate(l), time, k, state);
  }
  return state;
}

}  // namespace

OscillationState oscillation_state(const CompiledModel& model, const CompiledCase& resonance,
                                   const Eigen::VectorXd& parameters, const Observation& o, double time) {
  if (const auto state = balanced(model, resonance, parameters, o, time)) return *state;
  return with_expansion(model, resonance, parameters, o, time);
}

}  // namespace secular
