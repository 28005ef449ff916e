#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnose/effects/candidate.hpp"
#include "diagnose/inference/refit.hpp"

namespace secular {

/// What a candidate explains to first order beside what is fitted already, and where its nonlinear fit should
/// begin.
struct Screening {
  double gain = 0;        ///< fall of chi-squared
  Eigen::VectorXd start;  ///< unknowns; empty where the data do not see the candidate
  Eigen::VectorXd scale;  ///< of its strengths
};

/// Scales of unknowns (see unit_slopes) are much the same wherever a fit begins: the latest of each.
class KnownScales {
 public:
  explicit KnownScales(Eigen::Index unknowns) : scales_(Eigen::VectorXd::Zero(unknowns)) {}
  void remember(const std::vector<std::size_t>& which, const Eigen::VectorXd& scale);
  const Eigen::VectorXd& all() const { return scales_; }

 private:
  Eigen::VectorXd scales_;
};

/// Screens every candidate from the fit `base` on, start by start of their shapes, by slopes in the strengths of
/// all at once.
std::vector<Screening> screen_all(Discrepancy& discrepancy, const Refit& base,
                                  const std::vector<Candidate>& candidates, KnownScales& scales, unsigned threads);

/// Columns without what an orthonormal basis spans.
Eigen::MatrixXd without_span(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& columns);
/// Orthonormal basis of the columns, without directions that are rounding.
Eigen::MatrixXd basis_of(const Eigen::MatrixXd& columns);

}  // namespace secular
