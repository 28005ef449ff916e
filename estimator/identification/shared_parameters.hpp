#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "estimator/identification/case_regression.hpp"
#include "estimator/identification/condition_scatter.hpp"
#include "estimator/model/compiled_model.hpp"

namespace secular {

/// Estimated lumps and natural frequencies of one case, as its regression gave them. Where it does not separate
/// some of them it still knows combinations (the sum of a natural frequency and a small constant stiffness, for
/// instance).
struct LumpEstimates {
  const CompiledCase* resonance = nullptr;
  std::vector<int> index;  ///< lump, or -1 - mode for a natural frequency
  /// values x index: what of them was estimated. Identity, and combinations of those that are not separated.
  Eigen::MatrixXd combination;
  Eigen::VectorXd values;
  Eigen::MatrixXd plain;  ///< covariance from residuals: the weights
  /// Index x directions: how they change where parameters move along SharedParameters::null_space, by way of what
  /// was subtracted for the expansion's truncation. No columns: not known.
  Eigen::MatrixXd truncation_effect;
  /// Index x symbols: how they change with the parameters that the truncation was taken out with, as far as that is
  /// known: values + combination*truncation_slope*(parameters - truncation_at) are the lumps of the parameters. No
  /// columns: not at all.
  Eigen::MatrixXd truncation_slope;
  Eigen::VectorXd truncation_at;
  ResidualInformation residual_information;  ///< by the same directions as truncation_effect
  Eigen::MatrixXd influence;                 ///< [condition][value]: change where the condition is left out
  Eigen::MatrixXd record_moves;              ///< index x moves: CaseFit::record_moves
  double record_freedom = 0;                 ///< of these
  RowsByCondition rows;                      ///< what the lumps were made of; not needed for rough errors
  bool clustered = false;                    ///< error bars from `rows`, else from `plain`
  double degrees_of_freedom = 0;
};

/// Parameters that all cases share.
struct SharedParameters {
  Eigen::VectorXd values;                        ///< by CompiledModel::symbols
  std::vector<Eigen::MatrixXd> slope;            ///< by case: d values/d its lump estimates
  Eigen::MatrixXd covariance, plain_covariance;  ///< the second from the weights alone
  /// By symbol: the part of the variance that no noise makes, where parameters may be along `null_space` and what
  /// that does to the others by way of the truncation's correction.
  Eigen::VectorXd open_variance;
  Eigen::VectorXd degrees_of_freedom;  ///< by symbol (Satterthwaite over the cases)
  /// Directions in which parameters may move without any lump noticing, each as far as is plausible (one standard
  /// deviation): each parameter of an entangled group may do as much as the whole group is seen to do.
  Eigen::MatrixXd null_space;  ///< symbols x directions
  /// Directions x symbols, times parameters: how far along each these are from where they are likeliest.
  Eigen::MatrixXd null_space_coordinate;
  /// How far along each they are, by directions whose truncation_effect is known. What tells it is that the lumps
  /// have to go together after the truncation is taken out, and each case's ResidualInformation.
  Eigen::VectorXd null_coordinate, null_coordinate_sd;
  std::vector<Eigen::MatrixXd> null_coordinate_slope;  ///< by case: d null_coordinate/d its lump estimates
  Eigen::MatrixXd
      null_coordinate_prior;    ///< directions x directions: what is left of their own uncertainty, as a factor
  Eigen::MatrixXd value_prior;  ///< symbols x directions: what that does to `values`
  /// By rows of ResidualInformation, of unit variance: d values and d null_coordinate/d their targets.
  Eigen::MatrixXd value_by_information, null_coordinate_by_information;
  Eigen::MatrixXd noise_covariance;  ///< of values and then null-space coordinates, by noise alone
  /// What no parameters can give of the lumps (clustered_chi_squared), and how many more lumps than parameters
  /// there are.
  double chi_squared = 0;
  Eigen::Index surplus = 0;
};

/// Along the directions in which the truncation's correction depends on the null space. Empty: zero.
struct NullSpacePlace {
  Eigen::VectorXd corrected_at;  ///< where the truncation was taken out
  Eigen::VectorXd expected;      ///< where parameters are likeliest
};

/// docs/inference.md (7). Weighted nonlinear least squares of all lumps on the parameters, from `start`; weights
/// are the full inverse covariances from residuals. What is known of how the truncation's correction depends on the
/// parameters is part of the fit. Where it depends on the null space, that is an unknown of its own, as expected
/// with standard deviation one: values + combination*truncation_effect*(null_coordinate - corrected_at) are the
/// lumps of the parameters. The error bars come from the scatter between conditions (condition_scatter), so that
/// they do not rest on the weights; `rough_errors`: from what leaving a condition out does to the lumps, carried
/// through the map, which is wider and quick. `given` parameters stay.
SharedParameters shared_parameters(std::span<const LumpEstimates> cases, const Eigen::VectorXd& start,
                                   const std::vector<bool>& given, const NullSpacePlace& place = {},
                                   bool rough_errors = false);

}  // namespace secular
