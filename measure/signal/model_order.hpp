#pragma once

#include <Eigen/Core>

namespace secular {

/// Singular values that show the order of a signal, thesis section 4.4.1, each divided by the number of rows and
/// descending.
struct OrderSingularValues {
  Eigen::VectorXd biased;    ///< of Y^T Y: noise adds its variance to every one
  Eigen::VectorXd unbiased;  ///< of Y(:,1:m)^T Y(:,m+1:2m): no zero lag, noise averages out
};

/// Y is the Hankel matrix of the channels (samples x channels, rows of all channels stacked), with m = delays
/// columns and twice as many for the unbiased ones. At least 3*delays samples: std::invalid_argument.
OrderSingularValues order_singular_values(const Eigen::Ref<const Eigen::MatrixXd>& channels, int delays);

}  // namespace secular
