#include "estimator/identification/setting_functions.hpp"

#include <cmath>

#include "estimator/thresholds.hpp"
#include "numerics/explained_variation.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// That random departures are taken to follow the settings.
constexpr auto& structure_alarm = estimator_thresholds().setting_alarm;

/// With fewer degrees of freedom the F law sees a law only where it is nearly all: 0.8 of the variance with two
/// functions.
constexpr auto& freedom_beside_settings = estimator_thresholds().freedom_beside_settings;

/// What is left of a function beside others, by rounding.
constexpr double dependent_function = 1e-6;

}  // namespace

MatrixXd independent_functions(const std::vector<VectorXd>& of_records) {
  const auto count = static_cast<Index>(of_records.size());
  if (of_records.empty()) return MatrixXd(0, 0);
  MatrixXd independent = MatrixXd::Constant(count, 1, 1 / std::sqrt(static_cast<double>(count)));
  for (Index s = 1; s < of_records.front().size(); ++s) {
    VectorXd function(count);
    for (Index r = 0; r < count; ++r) function(r) = of_records[static_cast<std::size_t>(r)](s);
    const double before = function.norm();
    for (int pass = 0; pass < 2; ++pass) function -= independent * (independent.transpose() * function);
    if (!(function.norm() > dependent_function * before) || 2 * (independent.cols() + 1) > count) continue;
    independent.conservativeResize(count, independent.cols() + 1);
    independent.rightCols(1) = function.normalized();
  }
  return independent;
}

Following follows_settings(const VectorXd& own, const MatrixXd& functions, double tests) {
  if (own.size() == 0) return Following::too_few;
  const ExplainedVariation explained = explained_variation(own, functions);
  if (explained.rank < 2 || explained.freedom < freedom_beside_settings || !(explained.left > 0))
    return Following::too_few;
  return tests * explained.p_value() < structure_alarm ? Following::settings : Following::at_random;
}

}  // namespace secular
