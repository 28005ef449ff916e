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
  /// `memory`: differences of arguments that are used. `dependent`: differences of remainders that depend on one
  /// another to this share say nothing new; the level of errors in the values of g.
  AndersonAcceleration(std::size_t memory, double dependent) : memory_(memory), dependent_(dependent) {}

  /// The argument after `x`, where g is `value`. `weight`, by component: remainders count times this.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& value, const Eigen::VectorXd& weight);
  /// The same with all components of equal weight.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& value);

 private:
  std::size_t memory_;
  double dependent_;
  std::deque<Eigen::VectorXd> values_, remainders_;
};

}  // namespace secular
