// Designs against exhaustive search.
#include "estimator/planning/exchange.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <set>

namespace secular {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Regression on 1, x, x^2 at points of [-1, 1].
DesignProblem quadratic(int points, double budget, DesignCriterion criterion) {
  DesignProblem problem;
  for (int i = 0; i < points; ++i) {
    const double x = -1 + 2.0 * i / (points - 1);
    const Eigen::Vector3d row(1, 100 * x, 1e-3 * x * x);
    problem.items.push_back({row * row.transpose(), 1.0 + 0.5 * std::abs(x), i});
  }
  problem.wanted = {0, 1, 2};
  problem.scale = Eigen::Vector3d(1, 100, 1e-3);
  problem.criterion = criterion;
  problem.budget = budget;
  return problem;
}

double value_of(const DesignProblem& problem, unsigned chosen, double& cost) {
  MatrixXd sum = MatrixXd::Zero(3, 3);
  cost = 0;
  for (std::size_t i = 0; i < problem.items.size(); ++i)
    if (chosen >> i & 1U) {
      sum += problem.items[i].information;
      cost += problem.items[i].cost;
    }
  const VectorXd sd = standard_deviations(sum);
  if (!sd.allFinite()) return -1e300;
  if (problem.criterion == DesignCriterion::d) {
    const VectorXd unit = sum.diagonal().cwiseSqrt();
    return std::log((unit.cwiseInverse().asDiagonal() * sum * unit.cwiseInverse().asDiagonal()).determinant()) +
           2 * unit.array().log().sum();
  }
  double trace = 0;
  for (const Eigen::Index w : problem.wanted) trace += std::pow(sd(w) / problem.scale(w), 2);
  return -std::log(trace);
}

class Exchange : public testing::TestWithParam<DesignCriterion> {};

TEST_P(Exchange, FindsTheBestSubset) {
  DesignProblem problem = quadratic(11, 6.5, GetParam());
  if (GetParam() == DesignCriterion::c) problem.wanted = {2};
  double best = -1e300, found = 0, cost = 0;
  for (unsigned chosen = 0; chosen < 1U << 11; ++chosen) {
    const double value = value_of(problem, chosen, cost);
    if (cost <= problem.budget) best = std::max(best, value);
  }
  const Design design = optimal_design(problem);
  unsigned bits = 0;
  for (const std::size_t i : design.chosen) bits |= 1U << i;
  found = value_of(problem, bits, cost);
  EXPECT_LE(cost, problem.budget);
  EXPECT_DOUBLE_EQ(cost, design.cost);
  EXPECT_NEAR(found, best, 1e-6) << "exchanges of one item end in a local optimum, here the best one";
}

INSTANTIATE_TEST_SUITE_P(Criteria, Exchange,
                         testing::Values(DesignCriterion::d, DesignCriterion::a, DesignCriterion::c),
                         [](const auto& instance) {
                           return instance.param == DesignCriterion::d   ? "D"
                                  : instance.param == DesignCriterion::a ? "A"
                                                                         : "c";
                         });

TEST(ExchangeRules, OneOfAGroupAndAtLeastSoMany) {
  DesignProblem problem = quadratic(11, 12, DesignCriterion::d);
  for (DesignItem& item : problem.items) item.group /= 2;
  problem.least = 5;
  const Design design = optimal_design(problem);
  EXPECT_TRUE(design.feasible);
  EXPECT_GE(design.chosen.size(), 5u);
  std::set<int> groups;
  for (const std::size_t i : design.chosen) EXPECT_TRUE(groups.insert(problem.items[i].group).second);
  problem.budget = 3;
  EXPECT_FALSE(optimal_design(problem).feasible);
}

TEST(StandardDeviations, InfiniteWhereNothingIsSeen) {
  MatrixXd information = MatrixXd::Zero(3, 3);
  information(0, 0) = 4;
  const Eigen::Vector3d row(0, 1, 1);
  information += row * row.transpose();
  const VectorXd sd = standard_deviations(information);
  EXPECT_DOUBLE_EQ(sd(0), 0.5);
  EXPECT_TRUE(std::isinf(sd(1)));
  EXPECT_TRUE(std::isinf(sd(2)));
}

}  // namespace
}  // namespace secular
