#include "motion/response/bifurcation_diagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields.hpp"
#include "motion/response/fixed_points.hpp"
#include "motion/response/spectrum.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::VectorXd;

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

// At other parameters than those searched by the diagram, its branches hold every fixed point that a new search
// finds, and the search finds every one that they hold.
TEST(BifurcationDiagram, BranchesAndSearchesAgree) {
  const VectorField field = coupled_modes();
  DiagramOptions options;
  options.continuation.lower = -2;
  options.continuation.upper = 3;
  options.starts_at = VectorXd::LinSpaced(4, -1.5, 2.5);
  options.lower = VectorXd::Constant(4, -4);
  options.upper = VectorXd::Constant(4, 4);
  const BifurcationDiagram diagram = bifurcation_diagram(field, vector({0}), 0, options);
  EXPECT_EQ(diagram.status, DiagramStatus::complete);
  EXPECT_GT(diagram.branches.size(), 1u);
  for (const Branch& branch : diagram.branches)
    for (const SpecialPoint& special : branch.special) {
      const VectorXd parameters = vector({special.at.parameter});
      EXPECT_TRUE(special.polished);
      EXPECT_LT(field.rate(special.at.state, parameters).norm(), 1e-11);
      const Spectrum spectrum = spectrum_of(field.jacobian(special.at.state, parameters));
      const double zero = special.kind == SpecialKind::hopf ? std::abs(most_neutral_pair(spectrum).sum)
                                                            : spectrum.eigenvalues.cwiseAbs().minCoeff();
      EXPECT_LT(zero, 1e-9) << name_of(special.kind) << " at " << special.at.parameter;
    }
  FixedPointOptions search;
  search.lower = options.lower;
  search.upper = options.upper;
  for (const double value : {-0.7, 0.3, 0.9, 1.6}) {
    std::size_t on_branches = 0;
    for (const Branch& branch : diagram.branches)
      for (std::size_t i = 1; i < branch.points.size(); ++i)
        if ((branch.points[i - 1].parameter < value) != (branch.points[i].parameter < value)) ++on_branches;
    EXPECT_EQ(find_fixed_points(field, vector({value}), search).points.size(), on_branches) << value;
  }
}

TEST(BifurcationDiagram, CirclesOfFixedPointsAreReported) {
  Combination model;
  model.mu2 = model.mu1;  // otherwise the solutions drift along their circles
  model.cubic = 0.5;
  DiagramOptions options;
  options.starts_at = vector({0.4});
  options.lower = VectorXd::Constant(4, -3);
  options.upper = VectorXd::Constant(4, 3);
  const BifurcationDiagram diagram = bifurcation_diagram(model.field(), vector({0.2, 0}), 1, options);
  EXPECT_EQ(diagram.status, DiagramStatus::search_limit);
  EXPECT_TRUE(diagram.branches.empty());
}

}  // namespace
}  // namespace secular
