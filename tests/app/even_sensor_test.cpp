// Means that grow as the square of the motion are those of a sensor whose second harmonics are wrong.
#include "estimator/identification/even_sensor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "jobs/identify/identification.hpp"
#include "tests/app/hardening_oscillator.hpp"
#include "tests/app/oscillator_estimate.hpp"
#include "tests/identification/virtual_campaign.hpp"

namespace secular {
namespace {

using testing_support::value_of;
using testing_support::warns;

constexpr double quadratic_told = 4e5;

// Twelve dwells of an oscillator with a quadratic_told term.
SimulatedCampaign lopsided_dwells(std::uint64_t seed) {
  return testing_support::oscillator_campaign(
      testing_support::lopsided_oscillator() + testing_support::dwells_at_two_levels, seed);
}

// What a sensor makes of a response in a record.
using SensorLaw = std::function<double(double response, std::size_t record)>;

Identification identified_by_sensor(SimulatedCampaign made, const SensorLaw& sensor) {
  for (std::size_t r = 0; r < made.samples.size(); ++r)
    for (double& y : made.samples[r].channels[1]) y = sensor(y, r);
  return testing_support::identified_primary(made);
}

TEST(EvenSensor, IsAllowedForInWhatSecondHarmonicsTell) {
  const SimulatedCampaign made = lopsided_dwells(11);
  const double largest = testing_support::largest_response(made);
  for (const double share : {0.03, -0.06}) {
    const Identification id =
        identified_by_sensor(made, [&](double y, std::size_t) { return y * (1 + share * y / largest); });
    EXPECT_TRUE(warns(id.estimate.warnings, "grows as the square of its motion"));
    const EstimatedValue& a2 = value_of(id.estimate, "a2");
    EXPECT_GT(std::abs(*a2.value / quadratic_told - 1), 0.3) << share;
    EXPECT_LT(std::abs(*a2.value - quadratic_told), 3 * a2.sd) << share;
    const EstimatedValue& a3 = value_of(id.estimate, "a3");
    EXPECT_LT(std::abs(*a3.value - 2.5e8), 3 * a3.sd) << share;
  }
}

// Zeros that differ from record to record, or drift as levels go up, do not follow the square of the motion.
TEST(EvenSensor, IsNoOffset) {
  const SimulatedCampaign made = lopsided_dwells(12);
  const SensorLaw sensors[] = {[](double y, std::size_t) { return y; }, [](double y, std::size_t) { return y + 1; },
                               [](double y, std::size_t r) { return y + 0.1 * static_cast<double>(r); },
                               [](double y, std::size_t r) { return y + 0.2 * static_cast<double>(7 * r % 12); }};
  for (const SensorLaw& sensor : sensors) {
    const Identification id = identified_by_sensor(made, sensor);
    EXPECT_FALSE(warns(id.estimate.warnings, "grows as the square of its motion"));
    EXPECT_LT(value_of(id.estimate, "a2").sd, 0.01 * quadratic_told);
    EXPECT_LT(std::abs(*value_of(id.estimate, "a2").value - quadratic_told), 4 * value_of(id.estimate, "a2").sd);
  }
}

}  // namespace
}  // namespace secular
