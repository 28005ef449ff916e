#pragma once

#include "estimator/model/block_frequency.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// rad/s at which the line of a block turns in an observation; a decay has no excitation, and no phase of one.
inline double block_frequency(const RegressorBlock& block, const Observation& o) {
  return block_frequency(block, [&](std::size_t i) {
    return i < o.rate.size() ? o.rate[i].imag() : o.excitation_frequency[i - o.rate.size()];
  });
}

}  // namespace secular
