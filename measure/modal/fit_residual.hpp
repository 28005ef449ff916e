#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "measure/modal/pole_fit.hpp"

namespace secular {

/// A sum of squares of a residual, chi-squared with `freedom` where it is noise.
struct ExplainedSquares {
  double gain = 0, freedom = 0;
  int tests = 1;  ///< that were made to find it
  /// In noise, of so much or more in one of the tests.
  double probability() const;
};

/// What some signals say of all poles of a fit, linearised: a step of H^-1 g from the fit's, with covariance H^-1.
/// Unknowns are (real, imaginary part) of each pole, rad/s; noise is of unit level.
struct PoleInformation {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
};

/// What a fit of poles leaves of samples (rows x signals), and whether that is more than noise near one of its
/// poles.
class FitResidual {
 public:
  /// `fit`: of these samples by refine_poles or fit_residues. Throws std::invalid_argument as those do.
  FitResidual(const Eigen::Ref<const Eigen::MatrixXd>& samples, double sample_rate_hz, const PoleFit& fit);

  /// Rows x signals, unit of the samples.
  const Eigen::MatrixXd& left() const { return left_; }

  /// Less what lies along the columns of (M6) of all poles, as many powers as a quarter of the rows determines:
  /// noise, whatever the fit lacks near its poles.
  struct Noise {
    Eigen::MatrixXd samples;    ///< rows x signals
    Eigen::Index unknowns = 0;  ///< that were taken from each signal
  };
  Noise noise() const;

  /// Eq. (M6): what is left along the Taylor columns of `pole` (its place in the fit), by power; noise where its
  /// motion is one exponential, not for poles near each other, shapes that differ, and laws of amplitude of any
  /// kind.
  std::vector<ExplainedSquares> along_powers(Eigen::Index pole) const;

  /// Eq. (M5): what the laws of amplitude explain; noise where frequency and damping are constant. `amplitudes`: of
  /// this pole, by record, of whatever unit; `channels` signals belong to each.
  ExplainedSquares along_laws(Eigen::Index pole, const std::vector<double>& amplitudes,
                              Eigen::Index channels) const;

  /// By record, of which each has `channels` signals.
  std::vector<PoleInformation> by_record(Eigen::Index channels) const;

 private:
  Eigen::MatrixXd derivatives() const;
  Eigen::MatrixXd power_columns(Eigen::Index pole, Eigen::Index powers) const;

  PoleFit fit_;
  double rate_;
  Eigen::MatrixXd left_;
  Eigen::VectorXd weight_;  // by signal, of unit noise
  Eigen::MatrixXd basis_;   // orthonormal, of the fit's columns
};

}  // namespace secular
