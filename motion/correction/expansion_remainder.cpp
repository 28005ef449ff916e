#include "motion/correction/expansion_remainder.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

// [mode], rad/s: the frequency of the frame in which `modulation` gives dA/dt.
std::vector<double> frame_frequencies(const CompiledModel& model, const CompiledCase& resonance,
                                      const Eigen::VectorXd& parameters) {
  const std::size_t modes = model.modes(), symbols = model.symbols.size(), width = modes + model.excitations.size();
  std::vector<double> result(modes, 0.0);
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t i = 0; i < width; ++i) {
      const Ratio share = resonance.observed_frequency[k * width + i];
      const std::size_t at = i < modes ? i : symbols + i - modes;
      result[k] += share.numerator * parameters(static_cast<Eigen::Index>(at)) / share.denominator;
    }
  return result;
}

}  // namespace

ExpansionRemainder::ExpansionRemainder(const CompiledModel& model, const CompiledCase& resonance)
    : model_(model), resonance_(resonance), motions_(model, resonance) {}

std::optional<std::vector<Complex>> ExpansionRemainder::at(const Eigen::VectorXd& parameters,
                                                           const std::vector<Complex>& amplitude) const {
  const std::size_t modes = model_.modes(), excitations = model_.excitations.size();
  const auto symbols = static_cast<Eigen::Index>(model_.symbols.size());
  Observation motion;
  motion.amplitude = amplitude;
  motion.excitation_frequency.assign(parameters.data() + symbols,
                                     parameters.data() + symbols + static_cast<Eigen::Index>(excitations));
  motion.forcing.assign(excitations, 0);
  if (resonance_.excited)
    for (std::size_t j = 0; j < excitations; ++j)
      motion.forcing[j] = parameters(symbols + static_cast<Eigen::Index>(excitations + j));
  std::vector<Complex> derived(modes);
  resonance_.modulation(parameters.data(), motion.excitation_frequency.data(), amplitude.data(),
                        motion.forcing.data(), derived.data());
  const std::vector<double> frame = frame_frequencies(model_, resonance_, parameters);
  motion.rate.resize(modes);
  for (std::size_t k = 0; k < modes; ++k)
    motion.rate[k] = Complex(0, frame[k]) + (amplitude[k] == 0.0 ? 0.0 : derived[k] / amplitude[k]);
  const std::optional<BalancedMotions::Balanced> balanced = motions_.in_balance(parameters.head(symbols), motion);
  if (!balanced) return std::nullopt;
  std::vector<Complex> result(modes, 0.0);
  for (std::size_t k = 0; k < modes; ++k)
    if (const auto rate = motions_.rate_of(k, *balanced)) result[k] = (*rate - motion.rate[k]) * amplitude[k];
  return result;
}

}  // namespace secular
