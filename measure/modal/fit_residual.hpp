#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "measure/modal/pole_fit.hpp"

namespace secular {

/// What a fit of poles leaves of samples (rows x signals), and whether that is more than noise near one of its
/// poles.
class FitResidual {
 public:
  /// `fit`: of these samples by refine_poles or fit_residues. Throws std::invalid_argument as those do.
  FitResidual(const Eigen::Ref<const Eigen::MatrixXd>& samples, double sample_rate_hz, const PoleFit& fit);

  /// Rows x signals, unit of the samples.
  const Eigen::MatrixXd& left() const { return left_; }

  /// Eq. (M6): probability, were the motion of `pole` (its place in the fit) one exponential, of so much left along
  /// its Taylor columns. For poles near each other, shapes that differ, and laws of amplitude of any kind.
  double probability_of_one_exponential(Eigen::Index pole) const;

  /// Eq. (M5): the sum of squares that the laws of amplitude explain, chi-squared with law_freedom degrees of
  /// freedom where frequency and damping are constant. `amplitudes`: of this pole, by record, of whatever unit;
  /// `channels` signals belong to each.
  double law_gain(Eigen::Index pole, const std::vector<double>& amplitudes, Eigen::Index channels) const;
  static constexpr int law_freedom = 4;

 private:
  Eigen::MatrixXd projected(const Eigen::MatrixXd& columns) const;

  PoleFit fit_;
  double rate_;
  Eigen::MatrixXd left_;
  Eigen::VectorXd weight_;  // by signal, of unit noise
  Eigen::MatrixXd basis_;   // orthonormal, of the fit's columns
};

}  // namespace secular
