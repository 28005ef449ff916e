#pragma once

#include <Eigen/Dense>
#include <vector>

#include "diagnose/evidence/held_lines.hpp"

namespace secular {

/// What rows of a condition do to first order near a motion in balance. With r the rows, s the slaved lines' steps
/// (HeldLines::Values) and y their entries, a small change of readings or unknowns moves r by dr and s by ds where
/// the lines are held; they follow to s = 0, and the rows change by
///   dr - (dr/dy) (ds/dy)^-1 ds    (docs/inference.md (39)).
class FollowedLines {
 public:
  /// `displacement`: a motion in balance, modes x lines. Keeps nothing of `held`.
  FollowedLines(HeldLines& held, const Eigen::MatrixXcd& displacement);

  const std::vector<SlavedLine>& slaves() const { return slaves_; }
  const BalanceSweep::Path& path() const { return path_; }
  /// Of the motion as it is.
  const HeldLines::Values& here() const { return along_.here; }
  Eigen::Index rows() const { return along_.by_line.rows.rows(); }

  /// Change of the rows, from what it is with the lines held.
  Eigen::VectorXd change(Eigen::VectorXd rows, const Eigen::VectorXd& steps) const;

 private:
  std::vector<SlavedLine> slaves_;
  BalanceSweep::Path path_;
  HeldLines::AlongLines along_;
  Eigen::PartialPivLU<Eigen::MatrixXd> to_balance_;
};

}  // namespace secular
