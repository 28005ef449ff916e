#pragma once

#include <Eigen/Core>
#include <complex>

#include "motion/balance/torus.hpp"

namespace secular {

/// A channel that is cut at +-level after noise of a standard deviation came in (see saturated), on lines of a
/// torus: half-amplitudes of exp(i phase).
struct ChannelCut {
  double level = 0;
  double noise_sd = 0;

  /// Lines of the reading that is expected on the mean; what stays clear of the level is not touched.
  void apply(const Torus& torus, Eigen::MatrixXcd& lines, Eigen::Index row) const;

  /// What one line was before the cut over what is shown of it: the line that, with all others as they are in
  /// `lines` (one row), is shown as `shown`. Newton's method with the slopes of the describing function of a
  /// sinusoid, along the line's own phase and across it.
  std::complex<double> uncut_share(const Torus& torus, const Eigen::MatrixXcd& lines, Eigen::Index line,
                                   std::complex<double> shown) const;
};

/// A cut is undone to this share of a line, in no more than so many steps.
constexpr double undone_cut = 1e-10;
constexpr int most_undoings = 30;

}  // namespace secular
