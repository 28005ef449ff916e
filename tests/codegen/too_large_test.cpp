// What would not come to an end is refused with its place, in an equation as in a case.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "codegen/canonical/canonical_model.hpp"
#include "input/input_error.hpp"
#include "perturb/model.hpp"

namespace secular {
namespace {

std::string refusal(const std::string& force, int order = 1) {
  const Model model = read_model_text(
      fmt::format("schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\n"
                  "equation = \"D2(x) + w^2*x = -2*mu*D(x) {} + e*F*cos(Omega*t)\"\n[[case]]\nname = \"primary\"\n"
                  "relations = [\"Omega = w + eps*sigma\"]\n"
                  "order = {{ mu = 1, a = 1, b = 0, c = 0, d = 0, g = 0, h = 0, e = 1 }}\nexpand_to = {}\n",
                  force, order),
      "model.toml");
  try {
    canonical_model(model);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TooLarge, DivisorsOfDifferentFractionsNeedNoCommonDenominator) {
  EXPECT_EQ(refusal("- a*x^3/((b+c+d+g+h)^11-1) + a*x*D(x)^2/((b+c+d+g+h)^10-1)"), "");
}

TEST(TooLarge, DivisorsOfACaseAreRefusedWithIt) {
  const std::string message = refusal("- a*x^2/((b+c+d+g+h)^11-1) + a*x*D(x)/((b+c+d+g+h)^10-1)", 2);
  for (const char* const part :
       {"model.toml", "case primary", "terms that may have a factor in common", "lower expand_to"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(TooLarge, DivisorsOfAnEquationAreRefusedWithIt) {
  const std::string message = refusal("- a*x^3/((b+c+d+g+h)^11-1) - a*x^3/((b+c+d+g+h)^10-1)");
  for (const char* const part :
       {"model.toml", "equation of 'x'", "terms that may have a factor in common", "lower expand_to"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

}  // namespace
}  // namespace secular
