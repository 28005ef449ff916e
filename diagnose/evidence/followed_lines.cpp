#include "diagnose/evidence/followed_lines.hpp"

namespace secular {

FollowedLines::FollowedLines(HeldLines& held, const Eigen::MatrixXcd& displacement)
    : slaves_(held.slaves()),
      path_(held.path(displacement)),
      along_(held.along_lines(path_, slaves_)),
      to_balance_(along_.by_line.steps) {}

Eigen::VectorXd FollowedLines::change(Eigen::VectorXd rows, const Eigen::VectorXd& steps) const {
  if (!slaves_.empty()) rows -= along_.by_line.rows * to_balance_.solve(steps);
  return rows;
}

}  // namespace secular
