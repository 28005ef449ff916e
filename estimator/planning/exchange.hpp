#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace secular {

enum class DesignCriterion {
  d,  ///< smallest determinant of the wanted parameters' covariance
  a,  ///< smallest sum of their variances, each over its value squared
  c   ///< smallest variance of one
};

/// Something that can be measured: its information and what it costs. Of one group at most one is chosen (the same
/// response with different numbers of ensembles).
struct DesignItem {
  Eigen::MatrixXd information;
  double cost = 0;
  int group = 0;
};

struct DesignProblem {
  std::vector<DesignItem> items;
  std::vector<Eigen::Index> wanted;  ///< unknowns to be determined; the others are determined along the way
  Eigen::VectorXd scale;             ///< [unknown] what counts as one of it, for criterion a
  DesignCriterion criterion = DesignCriterion::d;
  double budget = 0;
  std::size_t least = 0;          ///< items to choose at least
  std::function<void()> pulse{};  ///< called many times a second; what it throws ends the search
};

struct Design {
  std::vector<std::size_t> chosen;  ///< ascending
  double cost = 0;
  double value = 0;       ///< the criterion as a logarithm: larger is better
  Eigen::VectorXd sd;     ///< [unknown]; infinite where the design does not determine it
  bool feasible = false;  ///< `least` items fit into the budget
};

/// Covariance diagonal's square root for an information matrix, infinite in directions that it does not see.
Eigen::VectorXd standard_deviations(const Eigen::Ref<const Eigen::MatrixXd>& information);

/// Greedy by gain over cost, then exchanges (one out, one in), additions and removals while they improve the
/// criterion within the budget (Fedorov 1972, with costs). Deterministic; finds a local optimum. Throws
/// std::invalid_argument for no items, sizes that differ or costs that are not positive.
Design optimal_design(const DesignProblem& problem);

}  // namespace secular
