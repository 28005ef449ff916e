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
  double of_records = 0;  ///< share of its variance that is the records' own (Discrepancy::share_of_records)
  Eigen::VectorXd start;  ///< unknowns; empty where the data do not see the candidate
  Eigen::VectorXd scale;  ///< of its strengths
};

/// Scales of unknowns (see unit_slopes) are much the same wherever a fit begins: the latest of each.
class KnownScales {
 public:
  explicit KnownScales(Eigen::Index unknowns) : scales_(Eigen::VectorXd::Zero(unknowns)) {}
  /// `which`: indices of unknowns; `scale`: one each, zeros are passed over.
  void remember(const std::vector<std::size_t>& which, const Eigen::VectorXd& scale);
  /// By unknown of the discrepancy, 0 where none is known.
  const Eigen::VectorXd& all() const { return scales_; }

 private:
  Eigen::VectorXd scales_;
};

/// Screens every candidate from the fit `base` on, start by start of their shapes, by slopes in the strengths of
/// all at once. In the order of `candidates`; no gain for those that the data do not see and for passive
/// ones whose strength would be negative. `discrepancy` is moved to the unknowns of `base` first (approach),
/// `scales` are kept for the next screening. The result does not depend on `threads`.
std::vector<Screening> screen_all(Discrepancy& discrepancy, const Refit& base,
                                  const std::vector<Candidate>& candidates, KnownScales& scales, unsigned threads);

/// Orthonormal basis of the columns, without directions whose singular value is below a millionth of the largest,
/// of columns of unit length. No columns where all are zero.
Eigen::MatrixXd basis_of(const Eigen::MatrixXd& columns);

}  // namespace secular
