#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "diagnose/evidence/left_of_segment.hpp"
#include "diagnose/evidence/noise_bands.hpp"

namespace secular {

/// Coloured noise of all decays together, of segments that are as long as the first one (docs/inference.md (29)).
/// Nothing where it is white, or where segments or decays are too few to tell: what one decay alone leaves may be
/// its motion's as well. `natural_frequency`: by mode, rad/s.
std::shared_ptr<const NoiseInCosines> noise_of_decays(std::span<const FrozenSegment> segments,
                                                      std::span<const LeftOfSegment> left,
                                                      const Eigen::VectorXd& natural_frequency);

/// Standard deviation of what such noise makes along orthonormal columns of errors, channel after channel.
Eigen::VectorXd sd_along(const NoiseInCosines& noise, const Eigen::MatrixXd& columns);

}  // namespace secular
