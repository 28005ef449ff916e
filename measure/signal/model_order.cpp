#include "measure/signal/model_order.hpp"

#include <Eigen/Dense>
#include <stdexcept>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;

OrderSingularValues order_singular_values(const Eigen::Ref<const MatrixXd>& channels, int delays) {
  const Index m = delays, samples = channels.rows();
  if (m < 1 || samples < 3 * m)
    throw std::invalid_argument("singular values of a Hankel matrix need three samples for every delay");
  const Index rows = samples - 2 * m + 1, short_rows = samples - m + 1;
  MatrixXd zero_lag = MatrixXd::Zero(m, m), lagged = MatrixXd::Zero(m, m);
  for (Index c = 0; c < channels.cols(); ++c) {
    MatrixXd hankel(short_rows, m);
    for (Index k = 0; k < m; ++k) hankel.col(k) = channels.col(c).segment(k, short_rows);
    zero_lag += hankel.transpose() * hankel;
    lagged += hankel.topRows(rows).transpose() * hankel.bottomRows(rows);
  }
  const auto channel_count = static_cast<double>(channels.cols());
  OrderSingularValues values;
  values.biased = zero_lag.bdcSvd().singularValues() / (channel_count * static_cast<double>(short_rows));
  values.unbiased = lagged.bdcSvd().singularValues() / (channel_count * static_cast<double>(rows));
  return values;
}

}  // namespace secular
