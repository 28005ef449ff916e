#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// Rows that take a stretch of samples to its cosines (the orthonormal transform DCT-II: stationary noise of any
/// colour is as good as independent in them), the slowest first.
Eigen::MatrixXd cosines(Eigen::Index samples);

/// Stretches of one record and channel in their cosines, and how many of each cosine's degrees of freedom are left
/// in it.
struct CosineStretches {
  Eigen::MatrixXd values;   ///< cosine x stretch
  Eigen::MatrixXd freedom;  ///< the same, 0 to 1
};

/// Standard deviation of the noise by cosine: in bands of half an octave that of the middle stretch, all of them
/// smaller by what the quietest quarter of stretches holds less in all bands together, as what a model misses is
/// largest where the motion is. What is left about the cosines of the motion, `of_motion`, is no noise: there it is
/// as in the bands on either side. Nowhere less than what all bands of all stretches hold, spikes that nobody
/// masked as well: the least of their means, or `white` where that is less (a tone counts in third differences).
Eigen::VectorXd noise_by_band(const CosineStretches& stretches, const std::vector<Eigen::Index>& of_motion,
                              double white);

/// Noise of the channels of stretches of as many samples.
struct NoiseInCosines {
  Eigen::MatrixXd cosines;
  Eigen::MatrixXd sd;  ///< cosine x channel
  double least = 0;    ///< standard deviation of what is white in it
};

}  // namespace secular
