#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// What the sensors of a test add, seen in the modal signals.
struct PlanningNoise {
  std::vector<double> response_sd;  ///< [mode] of one sample of the modal signal, white
  int derivatives = 2;              ///< of the modal signal: 2 for accelerations
  double excitation_sd = 0;         ///< of one sample
  double sample_rate_hz = 256, ensemble_s = 4;
  double dwell_scatter = 0;  ///< relative scatter of a response's amplitude from dwell to dwell

  double samples() const { return sample_rate_hz * ensemble_s; }
};

/// A steady response at one excitation.
struct DwellState {
  double frequency = 0, forcing = 0;            ///< rad/s, peak
  std::vector<std::complex<double>> amplitude;  ///< [mode] half of the peak
  std::vector<double> frequency_shift;          ///< [mode] rad/s, as ModeAmplitudes
};

/// Coefficients that a campaign in one case estimates together: lumps of the modulation equations and of the
/// first-order harmonics, natural frequencies.
struct PlanUnknowns {
  std::vector<std::string> names;
  std::vector<int> lump;   ///< index into CompiledCase::lumps, -1 for a natural frequency
  std::vector<int> mode;   ///< of a natural frequency, otherwise -1
  Eigen::VectorXd values;  ///< at the rough parameters
};

/// Whether dwells of the case could be planned for it, or with it known.
bool is_lump_or_frequency(const CompiledModel& model, const CompiledCase& resonance, const std::string& name);

/// `fixed`: names taken as known. Throws std::invalid_argument for one that is_lump_or_frequency refuses.
PlanUnknowns plan_unknowns(const CompiledModel& model, const CompiledCase& resonance,
                           const Eigen::Ref<const Eigen::VectorXd>& parameters,
                           const std::vector<std::string>& fixed);

/// What a dwell is planned for.
struct PlannedTest {
  const CompiledModel& model;
  const CompiledCase& resonance;
  const Eigen::VectorXd& parameters;  ///< rough values, by CompiledModel::symbols
  const PlanUnknowns& unknowns;
  const PlanningNoise& noise;
};

/// Fisher information about the unknowns of `ensembles` ensembles at one dwell. The modulation equations' columns
/// (RegressorBlock::columns) are whitened by what the noise of the amplitudes, of the force, of the frequencies of
/// modes that the excitation does not lock, and the scatter between dwells make of the equations' residuals, first
/// order; harmonics by their own noise. `symmetry`: rows n of ResponseField::symmetries() over all modes (0 at
/// rest), empty where every phase is locked. [unknown][unknown], in 1/unit^2.
Eigen::MatrixXd dwell_information(const PlannedTest& test, const DwellState& state,
                                  const Eigen::Ref<const Eigen::MatrixXd>& symmetry, int ensembles);

}  // namespace secular
