#include "estimator/model/zero_frequency.hpp"

#include <algorithm>

namespace secular {

bool is_zero_frequency(const RegressorBlock& block) {
  return block.kind == BlockKind::harmonic &&
         std::all_of(block.phase.begin(), block.phase.end(), [](int p) { return p == 0; });
}

}  // namespace secular
