// Numbers that are claimed, and numbers that only say where the modes are.
#include "diagnose/verdict/given_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace secular
