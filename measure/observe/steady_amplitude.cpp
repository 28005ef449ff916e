#include "measure/observe/steady_amplitude.hpp"

#include <Eigen/Dense>
#include <complex>

#include "measure/observe/mode_frequencies.hpp"

namespace secular {

using Complex = std::complex<double>;
using Eigen::Index;

void to_steady_amplitudes(ObservationSet& drifting, const Eigen::VectorXd& parameters) {
  const CompiledModel& model = *drifting.model;
  const CompiledCase& resonance = *drifting.resonance;
  const ModeFrequencies modes = mode_frequencies(model, resonance);
  const auto count = static_cast<Index>(model.modes());
  for (Observation& o : drifting.observations) {
    Eigen::VectorXd u(static_cast<Index>(modes.free.size()));
    for (Index i = 0; i < u.size(); ++i)
      u(i) = parameters(static_cast<Index>(modes.free[static_cast<std::size_t>(i)]));
    const Eigen::VectorXd frame = modes.observed(u, o.excitation_frequency);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(2 * count, 2 * count);
    resonance.modulation_jacobian(parameters.data(), o.excitation_frequency.data(), o.amplitude.data(),
                                  o.forcing.data(), jacobian.data());
    Eigen::VectorXd drift(2 * count);
    for (Index k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const Complex rate = modes.oscillates[at] ? (o.rate[at] - Complex(0, frame(k))) * o.amplitude[at] : Complex();
      drift(2 * k) = rate.real();
      drift(2 * k + 1) = rate.imag();
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-6);
    solver.compute(jacobian);
    const Eigen::VectorXd step = solver.solve(drift);
    for (Index k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (!modes.oscillates[at]) continue;
      o.amplitude[at] -= Complex(step(2 * k), step(2 * k + 1));
      o.rate[at].real(0);
    }
  }
}

}  // namespace secular
