#include "measure/observe/response_tones.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "generated/registry.hpp"

namespace secular {
namespace {

const CompiledCase& first_case(const CompiledModel& model) {
  return model.cases.front();
}

// Principal parametric resonance, Omega = 2*omega0: the mode moves at half of the excitation's frequency.
TEST(ResponseTones, OfAModeThatMovesAtHalfTheExcitationsFrequency) {
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const CompiledCase& resonance = first_case(model);
  const ModeFrequencies modes = mode_frequencies(model, resonance);
  ASSERT_TRUE(modes.free.empty());
  const ToneSetting setting{{160}, Eigen::VectorXd(), 0.5, 1000};
  const ResponseTones tones(model, resonance, modes, setting, Window{});
  ASSERT_EQ(tones.main(), 1U);
  ASSERT_EQ(tones.mode_index(0), 0);
  EXPECT_DOUBLE_EQ(tones.tones().front().at(setting.free), 80);
  // Combinations of up to three of 80 and 160 rad/s, and harmonics of the case beyond: multiples of 80, each once.
  std::vector<double> frequencies;
  for (const RelatedTone& tone : tones.tones()) frequencies.push_back(tone.at(setting.free));
  std::sort(frequencies.begin(), frequencies.end());
  ASSERT_GE(frequencies.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_DOUBLE_EQ(frequencies[i], 80 * static_cast<double>(i + 1));
  for (std::size_t i = 6; i < frequencies.size(); ++i) {
    EXPECT_GT(frequencies[i], frequencies[i - 1] + 1);
    EXPECT_DOUBLE_EQ(std::remainder(frequencies[i], 80), 0);
  }
  for (std::size_t b = 0; b < resonance.blocks.size(); ++b) {
    if (tones.block_index(b) < 0) continue;
    double frequency = 0;
    for (std::size_t i = 0; i < resonance.blocks[b].phase.size(); ++i)
      frequency += resonance.blocks[b].phase[i] * (i == 0 ? 80 : 160);
    EXPECT_EQ(tones.reversed(b), frequency < 0);
    EXPECT_DOUBLE_EQ(tones.tones()[static_cast<std::size_t>(tones.block_index(b))].at(setting.free),
                     std::abs(frequency));
  }
  const RelatedTones related = tones.related(2);
  EXPECT_EQ(related.fixed.size(), 2);
  EXPECT_EQ(related.coupling.cols(), 0);
}

TEST(ResponseTones, WhatSamplesDoNotShowHasNoTone) {
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const CompiledCase& resonance = first_case(model);
  const ToneSetting coarse{{160}, Eigen::VectorXd(), 50, 1000};  // the mode lies within two bins of zero
  const ResponseTones tones(model, resonance, mode_frequencies(model, resonance), coarse, Window{});
  EXPECT_EQ(tones.main(), 0U);
  EXPECT_EQ(tones.mode_index(0), -1);
}

}  // namespace
}  // namespace secular
