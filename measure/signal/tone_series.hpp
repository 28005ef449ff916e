#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "measure/signal/folded_window.hpp"
#include "measure/signal/pole.hpp"

namespace secular {

struct ToneSeries {
  std::vector<Pole> poles;  ///< near the maximum of the likelihood
  double start_cost = 0;    ///< sum over channels of the log of the residual variance, at the start
  bool moved = false;
  bool far = false;  ///< the maximum is beyond the reach of the series: go on from `poles` with another
};

/// Steps towards the maximum of the likelihood with one pass over the samples. Between start and maximum a tone
/// turns by a small angle d at the ends of the window, and its functions there are the series of exp(d tau X) in
/// their products with powers of time. Those are projected on the data once, to the fifth power; all other sums
/// are known in closed form. What the series leaves out, of the order d^5/240, is for the caller to correct.
/// `functions` are those of the start, with closed moments; `energy` is the sum of squares by channel.
ToneSeries follow_series(std::span<const Pole> start, const FoldedFunctions& functions, const Eigen::MatrixXd& even,
                         const Eigen::MatrixXd& odd, const Eigen::VectorXd& energy);

}  // namespace secular
