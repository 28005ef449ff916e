#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// Windows of one record: `length` samples each, the k-th from sample k*step.
struct EnsembleLayout {
  Eigen::Index length = 0, step = 0, count = 0;
  double share() const;  ///< of a window that the next one sees again
};

/// As many windows as fit, `overlap` in [0, 1) of each shared with the next (thesis 4.4.1: 16 s of 160 s, 0.75:
/// 37). Throws std::invalid_argument if none fits.
EnsembleLayout ensemble_layout(Eigen::Index samples, Eigen::Index length, double overlap);

/// Correlation of estimates from two windows of white noise `lag` windows apart: the share of common samples.
double ensemble_correlation(const EnsembleLayout& layout, Eigen::Index lag);

/// Mean over ensembles that overlap, with the covariance that overlapping leaves: the scatter of K correlated
/// values shows less than their variance and their mean averages less than K independent ones do.
struct EnsembleMean {
  Eigen::VectorXd mean;           ///< [quantity]
  Eigen::MatrixXd covariance;     ///< of the mean
  double independent = 0;         ///< K / (1 + 2 sum (1 - j/K) rho_j): ensembles that the mean is worth
  double degrees_of_freedom = 0;  ///< of the covariance (Satterthwaite)
};

/// values: ensembles x quantities, at least two rows.
EnsembleMean ensemble_mean(const Eigen::Ref<const Eigen::MatrixXd>& values, const EnsembleLayout& layout);

}  // namespace secular
