// Numbers that are claimed, and numbers that only say where the modes are.
#include "diagnose/verdict/given_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "diagnose/verdict/clipped_records.hpp"
#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"

namespace secular {
namespace {

TEST(GivenNumbers, FrequenciesAloneAreAStartWhereOtherParametersHaveNoNumber) {
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const std::size_t damping = symbol_named(model, "mu1");
  ASSERT_FALSE(std::isfinite(model.nominal[damping]));
  GivenNumbers given;
  EXPECT_FALSE(are_rough_frequencies(given, model, {0, damping}));
  given.values = {{"omega0", 80}};
  EXPECT_TRUE(are_rough_frequencies(given, model, {0, damping}));
  EXPECT_FALSE(are_rough_frequencies(given, model, {0}));
  given.values["mu1"] = 0.4;
  EXPECT_FALSE(are_rough_frequencies(given, model, {0, damping}));
}

TEST(GivenNumbers, RecordsAreWhereTheyAreClaimedUnlessTheyShowOtherwise) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  GivenNumbers given;
  given.values = {{"w2", 20}, {"other", 1}};
  const std::vector<double> claimed = claimed_frequencies(given, {"w1", "w2", "w3", "w4"}, {10, 21, none, 40});
  EXPECT_EQ(claimed[0], 10);
  EXPECT_EQ(claimed[1], 20);
  EXPECT_TRUE(std::isnan(claimed[2]));
  EXPECT_EQ(frequencies_of_records(claimed, {10.1, 20.1, 30.1, 44}, {false, false, false, true}),
            (std::vector<double>{10, 20, 30.1, 44}));
}

TEST(ClippedRecords, CountWhereMostAreClipped) {
  EXPECT_TRUE(leaves_clipped_out(0, 5));
  EXPECT_TRUE(leaves_clipped_out(2, 5));
  EXPECT_FALSE(leaves_clipped_out(3, 5));
  EXPECT_FALSE(leaves_clipped_out(2, 4));
}

}  // namespace
}  // namespace secular
