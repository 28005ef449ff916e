#pragma once

#include <Eigen/Core>
#include <vector>

#include "measure/observe/observation_set.hpp"

namespace secular {

/// Samples x channels of the part of a record that a window selects; `start_s` is the time of the first.
struct RecordPart {
  Eigen::MatrixXd samples;
  double start_s = 0;
};

RecordPart part_of(const Record& record, const std::vector<std::size_t>& channels, const Window& window);

}  // namespace secular
