#include "diagnose/evidence/left_of_segment.hpp"

#include <cmath>

#include "diagnose/evidence/noise_levels.hpp"

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

LeftOfSegment left_of_segment(const FrozenSegment& frozen, const VectorXd& error) {
  const auto& [of_state, of_change, foreign] = frozen.directions;
  LeftOfSegment left;
  left.white = white_variance(error, frozen.samples(), frozen.silent);
  left.changes = of_change.transpose() * error;
  left.rest = error - of_state * (of_state.transpose() * error) - of_change * left.changes;
  const auto silent = static_cast<Index>(frozen.silent.size()) * frozen.segment.response.rows();
  left.rest_rms =
      left.rest.norm() / std::sqrt(static_cast<double>(error.size() - silent - of_state.cols() - of_change.cols()));
  return left;
}

std::vector<LeftOfSegment> left_of_segments(std::span<const FrozenSegment> segments,
                                            const std::vector<VectorXd>& errors) {
  std::vector<LeftOfSegment> all;
  for (std::size_t i = 0; i < segments.size(); ++i) all.push_back(left_of_segment(segments[i], errors[i]));
  return all;
}

}  // namespace secular
