#include "estimator/identification/predicted_harmonics.hpp"

namespace secular {

using Complex = std::complex<double>;

std::vector<Complex> predicted_harmonics(const CompiledModel& model, const CompiledCase& resonance,
                                         const Eigen::VectorXd& parameters, const Observation& o) {
  std::vector<double> lumps(resonance.lumps.size());
  if (!lumps.empty()) resonance.evaluate_lumps(parameters.data(), lumps.data());
  std::vector<const Complex*> amplitude, forcing;
  std::vector<const double*> frequency;
  for (const Complex& a : o.amplitude) amplitude.push_back(&a);
  // A case without excitation has no forces to be observed.
  const std::vector<Complex> no_force(model.excitations.size(), 0.0);
  const std::vector<double> no_frequency(model.excitations.size(), 0.0);
  for (std::size_t j = 0; j < model.excitations.size(); ++j) {
    forcing.push_back(j < o.forcing.size() ? &o.forcing[j] : &no_force[j]);
    frequency.push_back(j < o.excitation_frequency.size() ? &o.excitation_frequency[j] : &no_frequency[j]);
  }
  const ObservationBatch batch{1, parameters.data(), frequency.data(), amplitude.data(), forcing.data()};
  std::vector<Complex> result(resonance.blocks.size(), 0.0);
  for (std::size_t b = 0; b < resonance.blocks.size(); ++b) {
    const RegressorBlock& block = resonance.blocks[b];
    if (block.kind != BlockKind::harmonic) continue;
    std::vector<Complex> column(block.lumps.size());
    std::vector<Complex*> columns;
    for (Complex& c : column) columns.push_back(&c);
    block.columns(batch, columns.data());
    for (std::size_t j = 0; j < column.size(); ++j)
      result[b] += lumps[static_cast<std::size_t>(block.lumps[j])] * column[j];
  }
  return result;
}

}  // namespace secular
