#include "diagnose/evidence/followed_lines.hpp"

namespace secular {

FollowedLines::FollowedLines(HeldLines& held, const Eigen::MatrixXcd& displacement)
    : slaves_(held.slaves()),
      path_(held.path(displacement)),
      here_(held.at(path_, slaves_)),
      by_line_(held.line_slopes(path_, slaves_)),
      to_balance_(by_line_.steps) {}

Eigen::VectorXd FollowedLines::change(Eigen::VectorXd rows, const Eigen::VectorXd& steps) const {
  if (!slaves_.empty()) rows -= by_line_.rows * to_balance_.solve(steps);
  return rows;
}

}  // namespace secular
