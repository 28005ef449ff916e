#pragma once

#include <Eigen/Core>
#include <string>

#include "diagnose/inference/inference.hpp"
#include "tests/diagnose/laboratory.hpp"

namespace secular::testing_support {

/// An explanation of which one number was fitted.
inline Explanation explanation(const Laboratory& lab, const Eigen::VectorXd& unknowns, const std::string& symbol,
                               double sd) {
  Explanation e;
  e.fit.unknowns = unknowns;
  e.fit.free = {lab.symbol(symbol)};
  e.fit.scale = Eigen::VectorXd::Constant(1, sd);
  e.fit.covariance = Eigen::MatrixXd::Constant(1, 1, sd * sd);
  e.fit.identifiable = {true};
  return e;
}

}  // namespace secular::testing_support
