#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// Filters that make noise white. Samples lie in rows x (channels of record 0, of record 1, ...). Each channel has
/// its own finite filter, a linear predictor's error, the same in all records; the channels of each record are then
/// mixed until their noise has unit covariance. A sum of exponentials stays one with the same poles: behind the
/// filter each of them has only another amplitude.
class NoiseWhitening {
 public:
  /// From what a fit left, of which `unknowns` were taken from each signal. Predictors by Burg's recursion over all
  /// records, their length by Schwarz's criterion; what is below `floor` (by channel's unit) counts as rounding.
  /// Throws std::invalid_argument for signals that are not whole records or too few rows.
  NoiseWhitening(const Eigen::Ref<const Eigen::MatrixXd>& left, Eigen::Index channels, Eigen::Index unknowns,
                 double floor);

  /// Fewer rows by order().
  Eigen::MatrixXd operator()(const Eigen::Ref<const Eigen::MatrixXd>& samples) const;

  Eigen::Index order() const { return order_; }

 private:
  Eigen::MatrixXd filtered(const Eigen::Ref<const Eigen::MatrixXd>& samples) const;

  Eigen::Index order_ = 0;                // of the longest predictor
  std::vector<Eigen::VectorXd> filters_;  // by channel, [0] = 1
  std::vector<Eigen::MatrixXd> mixing_;   // by record
};

}  // namespace secular
