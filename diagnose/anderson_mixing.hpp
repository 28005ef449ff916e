#pragma once

#include <Eigen/Core>
#include <vector>

namespace secular {

/// Fixed points of x -> x + f(x), faster than by repeating the map: the next x is where the latest steps f would
/// cancel if f were linear in between (Anderson 1965). Where the map contracts slowly or not at all in a few
/// directions only, those are learnt; where steps grow, what was learnt is forgotten and the plain step is
/// shortened.
class AndersonMixing {
 public:
  /// `memory`: so many differences are kept at most.
  explicit AndersonMixing(std::size_t memory) : memory_(memory) {}

  /// The next point after `x`, where the step is `f`; both of the size of the first call's.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& f);

 private:
  std::size_t memory_;
  std::vector<Eigen::VectorXd> changes_, step_changes_;  // of x and of f
  Eigen::VectorXd last_x_, last_f_;
  double share_ = 1;
};

}  // namespace secular
