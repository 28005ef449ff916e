#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "estimator/identification/observation_set.hpp"

namespace secular {

/// A number with its error bar, or the reason why there is none.
struct EstimatedValue {
  std::string name;
  std::string definition;  ///< lumps: the combination of symbols
  std::optional<double> value;
  double sd = 0, degrees_of_freedom = 0;
  double truncation = 0;  ///< what was subtracted for the expansion's truncation; half of it is in sd
  std::string unit;
  bool identifiable = false;
  bool significant = false;  ///< differs from zero at 95 %
  bool fixed = false;        ///< given by the user
  std::string from;          ///< the equation it comes from
  std::vector<std::string> entangled_with;
};

/// How one block of equations was fitted.
struct BlockQuality {
  std::string name;
  std::size_t equations = 0, conditions = 0;
  double normalised_residual = 0;  ///< residual over what the measured noise explains; 1 is perfect
  double condition_index = 0;      ///< largest, of scaled columns
  bool clustered = false;          ///< covariance from scatter between conditions
  std::map<std::string, double> variance_inflation;
};

struct Estimate {
  std::vector<EstimatedValue> parameters, lumps;
  std::vector<BlockQuality> blocks;
  Eigen::VectorXd parameter_values;  ///< by CompiledModel::symbols: a representative that reproduces the lumps
  std::vector<std::string> warnings;
};

struct EstimateOptions {
  std::map<std::string, double> fixed;  ///< parameters that are not estimated
};

/// Regression of all observations on the generated rows. Modulation equations first, natural frequencies with them;
/// then those first-order harmonics that see a parameter which the modulation equations leave open. Every equation
/// is whitened by the noise of everything measured in it (amplitudes, forces, frequencies, rates); error bars come
/// from the scatter between conditions. Physical parameters follow from the lumps by weighted nonlinear least
/// squares, as far as the lumps determine them. Throws InputError where no observations are left or a fixed name is
/// unknown.
Estimate estimate(const ObservationSet& set, const std::string& coordinate_unit,
                  const std::vector<std::string>& excitation_units, const EstimateOptions& options);

/// Takes the expansion's truncation out of an estimate. `replayed` is the same regression on what the full
/// equations do at `replay_parameters`: where it does not return them, the expansion is biased by the difference,
/// which is subtracted. Half of it joins the standard deviation, because it depends somewhat on how lumps split
/// into parameters. The result's parameter_values reproduce the corrected lumps, so that the correction can be
/// repeated from there.
Estimate truncation_corrected(const Estimate& raw, const Estimate& replayed,
                              const Eigen::VectorXd& replay_parameters, const CompiledModel& model,
                              const CompiledCase& resonance);

}  // namespace secular
