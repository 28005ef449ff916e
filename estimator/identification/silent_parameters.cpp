#include "estimator/identification/silent_parameters.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/hertz.hpp"

namespace secular {
namespace {

/// Phases of the modes are spread by multiples of irrational numbers (Kronecker's sequence).
constexpr int phase_samples = 64;

}  // namespace

Eigen::VectorXd sizes_by_force(const CompiledModel& model, std::span<const ObservationSet* const> sets,
                               const Eigen::VectorXd& parameters) {
  const std::size_t modes = model.modes(), symbols = model.symbols.size();
  std::vector<double> peak(modes, 0.0);
  for (const ObservationSet* set : sets)
    for (const Observation& o : set->observations)
      for (std::size_t k = 0; k < modes; ++k) peak[k] = std::max(peak[k], 2 * std::abs(o.amplitude[k]));
  const std::vector<ExcitationSample> silence(model.excitations.size());
  std::vector<double> q(modes), v(modes), acceleration(modes), slope(modes * symbols);
  std::vector<double> forces(modes, 0.0), effect(modes * symbols, 0.0);  // sums of squares
  for (int i = 0; i < phase_samples; ++i) {
    for (std::size_t k = 0; k < modes; ++k) {
      const double w = parameters(static_cast<Eigen::Index>(k));
      const double phase = two_pi * std::fmod((i + 0.5) * std::sqrt(static_cast<double>(2 + k)), 1.0);
      q[k] = peak[k] * std::cos(phase);
      v[k] = -w * peak[k] * std::sin(phase);
    }
    model.acceleration(parameters.data(), silence.data(), q.data(), v.data(), acceleration.data());
    model.acceleration_by_parameters(parameters.data(), silence.data(), q.data(), v.data(), slope.data());
    for (std::size_t k = 0; k < modes; ++k) {
      const double w = parameters(static_cast<Eigen::Index>(k));
      forces[k] += std::pow(acceleration[k] + w * w * q[k], 2);
    }
    for (std::size_t s = 0; s < slope.size(); ++s) effect[s] += slope[s] * slope[s];
  }
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(symbols));
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t p = 0; p < symbols; ++p) {
      if (!(peak[k] > 0 && effect[k * symbols + p] > 0)) continue;
      double& size = sizes(static_cast<Eigen::Index>(p));
      const double here = std::sqrt(forces[k] / effect[k * symbols + p]);
      if (size == 0 || here < size) size = here;
    }
  return sizes;
}

}  // namespace secular
