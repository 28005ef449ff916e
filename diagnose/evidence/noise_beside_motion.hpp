#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace secular {

/// What is left of a reading beside a motion, sample by sample.
struct SampledRest {
  std::vector<double> rest;
  double sample_s = 0;
};

/// docs/inference.md (66): power beside the natural frequencies (rad/s) in what is left, over that of the white
/// noise that third differences show; the lower end of its 95 % interval, and at least 1.
double noise_beside_motion(std::span<const SampledRest> left, const Eigen::VectorXd& natural_frequency);

}  // namespace secular
