#pragma once

#include <string>

#include "measure/observe/observation_set.hpp"
#include "thesis/procedures/two_mode_regression.hpp"

namespace secular {

/// A generated equation as a real regression: two rows (real and imaginary part) for every observation that has it.
struct BlockRows {
  RealRegression regression;
  std::vector<std::string> names;  ///< of the columns: lumps, then the natural frequency in modulation equations
  std::vector<int> condition;
};

/// Modulation equations are divided by the amplitude (their unit becomes 1/s) and turned by its phase: the real
/// part is the mode's growth, the imaginary part its frequency. Columns come from RegressorBlock::columns;
/// `natural_frequency` [mode] enters their coefficients alone. `fixed` names columns that are left out (their lumps
/// are zero). Throws std::invalid_argument where no observation has the block.
BlockRows block_rows(const ObservationSet& set, std::size_t block, const std::vector<double>& natural_frequency,
                     const std::vector<std::string>& fixed = {});

/// The same equation as `identify` regresses it: rows whitened by the joint noise of everything measured in them,
/// outlying ensembles down-weighted, the natural frequency counted from `natural_frequency`. With these weights
/// residuals have equal variances, as the analysis of variance supposes; equal weights give small amplitudes, whose
/// rows are noisy after the division, as much say as large ones.
BlockRows weighted_block_rows(const ObservationSet& set, std::size_t block,
                              const std::vector<double>& natural_frequency,
                              const std::vector<std::string>& fixed = {});

/// Mean of the modes' observed frequencies, rad/s: close to the natural ones at a resonance.
std::vector<double> mean_frequencies(const ObservationSet& set);

}  // namespace secular
