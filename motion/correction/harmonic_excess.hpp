#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "estimator/identification/estimate.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// A harmonic of a case that is measured larger than the full equations make it, docs/inference.md (55).
struct HarmonicExcess {
  const CompiledCase* resonance = nullptr;
  std::size_t block = 0;
  int multiple = 0;  ///< its frequency in those of the largest motion, at least 2
  /// Root mean square over the dwells, the larger the motion the more, as a share of the largest mode's motion, as
  /// channels show both.
  double measured = 0;
  double expected = 0;  ///< the same of what model and excitation make
  double share = 0;     ///< the same of what is surely beyond that
};

/// Of dwells, at amplitudes and excitations as measured, all lines of the excitation with them; those alone that
/// are beyond noise and error bars at a level of 0.1 %. `derivatives`: of ModalProjection. Cases without a balance
/// (BalancedMotions::known) or with tables of lines have none.
std::vector<HarmonicExcess> harmonic_excess(std::span<const ObservationSet> measured, const Estimate& estimate,
                                            int derivatives, unsigned threads);

}  // namespace secular
