#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace secular {

/// Step of the five-point differences below, relative to a variable's magnitude. Truncation h^4 and rounding eps/h
/// balance near eps^(1/5); a power of two keeps x + h - x == h in most cases.
inline constexpr double difference_step = 0x1p-10;

/// d f / d x, [rows of f][size of x], by five-point central differences
/// f' = (f(x-2h) - 8 f(x-h) + 8 f(x+h) - f(x+2h)) / 12h (Abramowitz & Stegun 25.3.6): exact but for rounding, about
/// 1e-13 relative, for polynomials to degree 4. h_i = difference_step * max(|x_i|, magnitude_i). `function` may
/// return a reference to what it overwrites when it is called again.
template <class Function>
Eigen::MatrixXd difference_jacobian(const Function& function, const Eigen::Ref<const Eigen::VectorXd>& at,
                                    const Eigen::Ref<const Eigen::VectorXd>& magnitude, Eigen::Index rows) {
  Eigen::MatrixXd jacobian(rows, at.size());
  Eigen::VectorXd x = at, near(rows), far(rows);
  for (Eigen::Index c = 0; c < at.size(); ++c) {
    const double h = difference_step * std::max(std::abs(at(c)), magnitude(c));
    const auto moved = [&](double steps) -> decltype(auto) {
      x(c) = at(c) + steps * h;
      return function(x);
    };
    near = moved(1);
    near -= moved(-1);
    far = moved(2);
    far -= moved(-2);
    x(c) = at(c);
    jacobian.col(c) = (8 * near - far) / (12 * h);
  }
  return jacobian;
}

/// d^2 f(x + t u) / dt^2 at t = 0 by five-point central differences (Abramowitz & Stegun 25.3.24) with a step for
/// unknowns of the order of one.
template <class Function>
Eigen::VectorXd second_difference(const Function& function, const Eigen::Ref<const Eigen::VectorXd>& at,
                                  const Eigen::Ref<const Eigen::VectorXd>& direction) {
  constexpr double h = 0x1p-8;
  const auto moved = [&](double steps) -> Eigen::VectorXd {
    const Eigen::VectorXd x = at + steps * h * direction;
    return function(x);
  };
  const Eigen::VectorXd near = moved(1) + moved(-1);
  const Eigen::VectorXd far = moved(2) + moved(-2);
  const Eigen::VectorXd centre = moved(0);
  return (16 * near - far - 30 * centre) / (12 * h * h);
}

}  // namespace secular
