// Free decays from a natural frequency that is a third off: fits begin with one turn (docs/inference.md (40)).
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "diagnose/verdict/diagnosis.hpp"
#include "generated/registry.hpp"
#include "tests/diagnose/pendulum_swing.hpp"

namespace secular {
namespace {

// Two decays of a pendulum that the model says swings with 5.77 rad/s.
SimulatedCampaign two_swings(double omega0, std::uint64_t seed) {
  const auto text = [](double value) { return std::to_string(value); };
  const double square = omega0 * omega0;
  const std::string experiment = R"(schema = 1
name = "swings"
model = "pendulum"
sample_rate_hz = 50.0
[parameters]
mu1 = 0.02
mu2 = 0.05
fc = 0.0
omega0 = )" + text(omega0) +
                                 "\nalpha3 = " + text(-square / 6) + "\nalpha5 = " + text(square / 120) + R"(
[[response]]
name = "swing"
quantity = "angle"
unit = "rad"
noise_sd = 1e-3
[[free_decay]]
initial_displacement = [0.9]
duration_s = 30.0
[[free_decay]]
initial_displacement = [0.6]
duration_s = 30.0
)";
  return testing_support::simulated(*generated::find_compiled_model("pendulum"), experiment, seed);
}

TEST(RoughStart, AFrequencyAThirdOffIsNoGap) {
  const CompiledModel& model = *generated::find_compiled_model("pendulum");
  for (const double omega0 : {4.2, 8.8}) {
    const SimulatedCampaign data = two_swings(omega0, 1);
    const RecordReader read = [&](std::size_t r) { return data.samples[r]; };
    std::vector<std::size_t> own(model.symbols.size());
    for (std::size_t s = 0; s < own.size(); ++s) own[s] = s;
    const Diagnosis d = diagnose({data.campaign, read, model, own}, {}, {});
    EXPECT_EQ(d.verdict, "no_gap") << omega0 << ": " << d.gap.p_value;
    ASSERT_EQ(d.fitted.names.front(), "omega0");
    EXPECT_NEAR(d.fitted.values(0), omega0, 4.5 * std::sqrt(d.fitted.covariance(0, 0)));
  }
}

}  // namespace
}  // namespace secular
