#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "numerics/cluster_scatter.hpp"

namespace secular {

/// The rows of one case's regression, condition by condition, in coordinates in which all of them together are
/// orthonormal (LinearFit::basis).
struct RowsByCondition {
  Eigen::MatrixXd entries;    ///< coordinates x entries: of the lumps and natural frequencies that parameters make
  Eigen::MatrixXd others;     ///< coordinates x others: of what else the case estimates, and what it has lost
  Eigen::VectorXd reference;  ///< by entry: what it is counted from
  Eigen::VectorXd estimate;   ///< coordinates of the case's own estimate
  Eigen::MatrixXd kept;       ///< LinearFit::kept
  double residual_sd = 1;
  /// Of rows about the mean of what is the same equation of the same condition: what noise alone makes of them.
  double repeat_variance = 0;
  double repeat_freedom = 0;
  /// Coordinates x coordinates: covariance of rows times such noise; empty: of rows that are independent.
  Eigen::MatrixXd repeat_gram;
  std::vector<Eigen::MatrixXd> gram;   ///< by condition, coordinates x coordinates
  std::vector<Eigen::VectorXd> score;  ///< by condition: rows times residuals of the case's own estimate
};

/// How the rows of one case depend on what all cases have in common.
struct CommonFit {
  const RowsByCondition* rows = nullptr;
  Eigen::MatrixXd slope;   ///< entries x unknowns
  Eigen::VectorXd values;  ///< by entry, at the fit
};

/// cluster_scatter() of the common fit, condition by condition, kept above the scatter of repeats:
/// docs/inference.md (8), (9), (27), (45). The unknowns are fitted to the rows themselves: the case's own estimate
/// has many more coefficients, of which some rest on a few conditions. `further`: rows of unit variance x unknowns
/// of what else is known, which adds no scatter of its own. `directions`: unknowns x directions along which they
/// are fitted. Nothing where one condition alone determines a direction.
std::optional<ClusterScatter> condition_scatter(std::span<const CommonFit> cases, const Eigen::MatrixXd& further,
                                                const Eigen::MatrixXd& directions);

}  // namespace secular
