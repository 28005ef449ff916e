#include "measure/observe/steady_amplitude.hpp"

#include <Eigen/Dense>
#include <complex>

#include "measure/observe/mode_frequencies.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What turns the phases that a resonance leaves free, by free frequency: of amplitude B_k, i coupling_k B_k.
MatrixXd turns(const ModeFrequencies& modes, const std::vector<Complex>& amplitude) {
  MatrixXd turned(2 * modes.coupling.rows(), modes.coupling.cols());
  for (Index k = 0; k < modes.coupling.rows(); ++k)
    for (Index f = 0; f < modes.coupling.cols(); ++f) {
      const Complex turn = Complex(0, modes.coupling(k, f)) * amplitude[static_cast<std::size_t>(k)];
      turned(2 * k, f) = turn.real();
      turned(2 * k + 1, f) = turn.imag();
    }
  return turned;
}

}  // namespace

void to_steady_amplitudes(ObservationSet& drifting, const VectorXd& parameters) {
  const CompiledModel& model = *drifting.model;
  const CompiledCase& resonance = *drifting.resonance;
  const ModeFrequencies modes = mode_frequencies(model, resonance);
  const auto count = static_cast<Index>(model.modes()), free = static_cast<Index>(modes.free.size());
  for (Observation& o : drifting.observations) {
    // The equations' frame turns with the free natural frequencies, the motion with what is observed of them.
    VectorXd natural(free), seen(free);
    for (Index i = 0; i < free; ++i) {
      natural(i) = parameters(static_cast<Index>(modes.free[static_cast<std::size_t>(i)]));
      seen(i) = o.rate[modes.free[static_cast<std::size_t>(i)]].imag();
    }
    const VectorXd frame = modes.observed(seen, o.excitation_frequency),
                   off = frame - modes.observed(natural, o.excitation_frequency);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(2 * count, 2 * count);
    resonance.modulation_jacobian(parameters.data(), o.excitation_frequency.data(), o.amplitude.data(),
                                  o.forcing.data(), jacobian.data());
    VectorXd drift(2 * count);
    for (Index k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const Complex rate = modes.oscillates[at] ? (o.rate[at] - Complex(0, frame(k))) * o.amplitude[at] : Complex();
      drift(2 * k) = rate.real();
      drift(2 * k + 1) = rate.imag();
      if (!modes.oscillates[at]) continue;
      jacobian(2 * k, 2 * k + 1) += off(k);  // minus i*off
      jacobian(2 * k + 1, 2 * k) -= off(k);
    }
    // Beside the amplitudes the frequency is sought that the motion settles to: its last columns.
    MatrixXd sought(2 * count, 2 * count + free);
    const MatrixXd turned = turns(modes, o.amplitude);
    sought << jacobian, turned / (turned.norm() > 0 ? turned.norm() : 1);
    if (free > 0)
      sought.leftCols(2 * count) -= jacobian * turned * turned.completeOrthogonalDecomposition().pseudoInverse();
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(1e-6);
    solver.compute(sought);
    const VectorXd step = solver.solve(drift);
    for (Index k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (!modes.oscillates[at]) continue;
      o.amplitude[at] -= Complex(step(2 * k), step(2 * k + 1));
      o.rate[at].real(0);
    }
  }
}

}  // namespace secular
