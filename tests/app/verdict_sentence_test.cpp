#include "jobs/identify/verdict_sentence.hpp"

#include <gtest/gtest.h>

namespace secular {
namespace {

// `numbers` of four parameters, and `tested` equations of one case that hold.
Estimate estimate_with(std::size_t numbers, std::size_t tested) {
  Estimate estimate;
  estimate.cases = {nullptr};
  for (std::size_t p = 0; p < 4; ++p) {
    EstimatedValue value;
    value.name = "mu" + std::to_string(p);
    if (p < numbers) value.value = 1;
    value.sd = 0.01;
    value.significant = true;
    estimate.parameters.push_back(value);
  }
  if (tested > 0) estimate.lack_of_fit = {{"free", std::vector<LackOfFit>(tested)}};
  return estimate;
}

TEST(VerdictSentence, SaysHowMuchWasTested) {
  EXPECT_EQ(verdict_sentence(estimate_with(4, 3), {}).find("No contradiction in 3 equations tested: 4 of 4"), 0u);
  EXPECT_EQ(verdict_tone(estimate_with(4, 3), {}), report::Tone::good);
  EXPECT_EQ(verdict_sentence(estimate_with(4, 0), {}).find("No equation could be tested"), 0u);
  EXPECT_EQ(verdict_tone(estimate_with(4, 0), {}), report::Tone::caution);
}

TEST(VerdictSentence, IsNotGreenOnLittleOrBesideMotionThatIsLeft) {
  EXPECT_EQ(verdict_tone(estimate_with(2, 3), {3, 0}), report::Tone::good);
  EXPECT_EQ(verdict_tone(estimate_with(1, 3), {3, 0}), report::Tone::caution);
  EXPECT_EQ(verdict_tone(estimate_with(0, 3), {3, 0}), report::Tone::bad);
  EXPECT_EQ(verdict_tone(estimate_with(4, 3), {3, 2}), report::Tone::caution);
  EXPECT_NE(verdict_sentence(estimate_with(4, 3), {3, 2}).find("2 of 3 records leave what is not white"),
            std::string::npos);
  Estimate misses = estimate_with(4, 3);
  misses.lack_of_fit.front().equations[1].significant = true;
  EXPECT_EQ(verdict_tone(misses, {}), report::Tone::caution);
  EXPECT_EQ(verdict_sentence(misses, {}).find("The model does not hold"), 0u);
}

}  // namespace
}  // namespace secular
