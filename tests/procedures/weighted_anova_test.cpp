// Added-last F tests of a generated equation, weighted as the regression is and with equal weights.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/identification/modulation_observations.hpp"
#include "thesis/procedures/added_last_anova.hpp"
#include "thesis/procedures/block_rows.hpp"

namespace secular {
namespace {

using testing_support::OneMode;

struct Tested {
  double f, p, value, sd;
};

Tested drag(const BlockRows& rows) {
  const auto at = static_cast<int>(std::find(rows.names.begin(), rows.names.end(), "mu2") - rows.names.begin());
  const AnovaTable table =
      added_last_anova(rows.regression.design, rows.regression.response, rows.condition, {{"mu2", {at}}});
  const LinearFit& fit = rows.regression.fit;
  return {table.rows[0].f, table.rows[0].p, fit.coefficients(at), std::sqrt(fit.plain_covariance(at, at))};
}

// Growth rates whose noise grows thirtyfold over the conditions, drag that is not there: with the weights of the
// noise F follows its distribution, and the estimate scatters less than with equal weights (Gauss and Markov).
TEST(StatisticalWeightedAnova, FollowsItsLawUnderUnequalNoise) {
  OneMode truth;
  truth.growth_sd = 1e-4;
  truth.growth_spread = 30;
  const std::vector<double> natural = {testing_support::w0};
  std::size_t block = 0;
  while (truth.resonance.blocks[block].kind != BlockKind::modulation) ++block;
  constexpr int draws = 150;
  int below = 0;
  double weighted_square = 0, equal_square = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const ObservationSet set = truth.set(static_cast<std::uint64_t>(draw) + 1);
    const BlockRows weighted_rows = weighted_block_rows(set, block, natural);
    const Tested weighted = drag(weighted_rows);
    const Tested equal = drag(block_rows(set, block, natural));
    below += weighted.p < 0.2;
    weighted_square += weighted.value * weighted.value / draws;
    equal_square += equal.value * equal.value / draws;
    // One column added last: F is the square of t, but for the rounding of the sums of squares whose difference it
    // is.
    const double square = std::pow(weighted.value / weighted.sd, 2);
    const auto rows = static_cast<double>(weighted_rows.regression.response.size());
    EXPECT_NEAR(weighted.f, square, 1e-7 * square + rows * rows * std::numeric_limits<double>::epsilon());
  }
  EXPECT_NEAR(below, 0.2 * draws, 4 * std::sqrt(0.16 * draws));
  EXPECT_LT(weighted_square, equal_square);
}

}  // namespace
}  // namespace secular
