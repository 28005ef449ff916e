#include "estimator/stability/bifurcation_diagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields.hpp"

namespace secular {
namespace {

using namespace testing_support;

TEST(BifurcationDiagram, PitchforkHasTwoBranches) {
  DiagramOptions options;
  options.continuation.lower = -1;
  options.continuation.upper = 1;
  options.starts_at = vector({-0.5, 0.5});
  options.lower = vector({-2});
  options.upper = vector({2});
  const BifurcationDiagram diagram = bifurcation_diagram(pitchfork_field(), vector({0}), 0, options);
  EXPECT_EQ(diagram.status, DiagramStatus::complete);
  EXPECT_EQ(diagram.branches.size(), 2u);
}

TEST(BifurcationDiagram, ParametricResonance) {
  const Parametric model;
  DiagramOptions options;
  options.continuation.lower = -4;
  options.continuation.upper = 4;
  options.starts_at = vector({-2, 0, 1, 3});
  options.lower = vector({-4, -4});
  options.upper = vector({4, 4});
  const BifurcationDiagram diagram = bifurcation_diagram(model.field(), vector({0, 0.8}), 0, options);
  EXPECT_EQ(diagram.branches.size(), 2u);  // the trivial one, and a closed one through both thresholds
}

TEST(BifurcationDiagram, IsolatedBranchesAreFoundByTheSearch) {
  // x' = x (1 - (x - 3)^2 - p^2): a circle about (3, 0) apart from the trivial branch.
  const VectorField field(1, {"p"}, [](const ConstVector& x, const ConstVector& p, OutVector rate) {
    rate(0) = x(0) * (1 - (x(0) - 3) * (x(0) - 3) - p(0) * p(0));
  });
  DiagramOptions options;
  options.continuation.lower = -2;
  options.continuation.upper = 2;
  options.starts_at = vector({0, 0.5});
  options.lower = vector({-5});
  options.upper = vector({5});
  const BifurcationDiagram diagram = bifurcation_diagram(field, vector({0}), 0, options);
  ASSERT_EQ(diagram.branches.size(), 2u);
  EXPECT_EQ(std::count_if(diagram.branches.begin(), diagram.branches.end(),
                          [](const Branch& branch) { return branch.closed; }),
            1);
}

}  // namespace
}  // namespace secular
