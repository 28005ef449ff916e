#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "estimator/identification/estimate.hpp"
#include "jobs/shared/model_loading.hpp"

namespace secular {

/// A coefficient that follows from the rest position and other estimates (perturb/rest_position.hpp).
struct FollowingEstimate {
  std::string name;
  double value = 0, sd = 0;
  bool doubtful = false;  ///< one of those that it follows from is, or (R4) finds it far from linear
  std::string doubtful_because = {};
};

/// The coefficients that follow from the numbers by name.
using FollowingLaw = std::function<std::vector<FollowingCoefficient>(const std::map<std::string, double>&)>;

/// What follows from an estimate, with standard deviations to first order in its covariance, and whether these are
/// to be trusted, docs/inference.md (R4).
std::vector<FollowingEstimate> following_estimates(const FollowingLaw& law, const Estimate& estimate);

}  // namespace secular
