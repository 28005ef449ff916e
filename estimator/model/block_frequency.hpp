#pragma once

#include <cstddef>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// rad/s at which the line of a block turns: the sum of its phase's parts, each times what `frequency(i)` says of
/// mode i or, behind the modes, of an excitation; asked for those that take part alone. It may be negative.
template <class Frequency>
double block_frequency(const RegressorBlock& block, const Frequency& frequency) {
  double sum = 0;
  for (std::size_t i = 0; i < block.phase.size(); ++i)
    if (block.phase[i] != 0) sum += block.phase[i] * frequency(i);
  return sum;
}

}  // namespace secular
