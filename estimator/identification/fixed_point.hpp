#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>

namespace secular {

/// Anderson's acceleration of x = g(x) (D. G. Anderson, J. ACM 12 (1965) 547-560, of type II): the next argument is
/// the combination of values g(x) for which the same combination of the remainders g(x) - x, taken as affine in x,
/// is smallest. Directions in which g does not contract, or moves things apart, are found from the arguments
/// before.
class AndersonAcceleration {
 public:
  /// `memory`: differences of arguments that are used.
  explicit AndersonAcceleration(std::size_t memory) : memory_(memory) {}

  /// The argument after `x`, where g is `value`. `weight`, by component: remainders count times this.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& value, const Eigen::VectorXd& weight);

 private:
  std::size_t memory_;
  std::deque<Eigen::VectorXd> values_, remainders_;
};

}  // namespace secular
