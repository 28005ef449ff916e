#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "measure/signal/pole.hpp"

namespace secular {

struct FoldedWindow;

/// Sums over a window of products of functions G with powers of time tau (half windows from its centre).
struct TimedMoments {
  Eigen::MatrixXd zeroth, first, second;  ///< G^T G, G^T (tau G), (tau G)^T (tau G)
};

/// The moments of constants, cosines and sines without a pass over the samples: products are cosines and sines of
/// sums and differences of frequencies, and their sums over the window are sin(N y)/sin(y) and its derivatives.
/// None for other families, and where the closed form loses digits: two frequencies within a sixth of a bin of each
/// other (or of zero, or of the Nyquist frequency) without being equal, a sine or cosine that nearly vanishes.
std::optional<TimedMoments> circular_moments(std::span<const Pole> poles, const FoldedWindow& window);

}  // namespace secular
