// Means that grow as the square of the motion are those of a sensor whose second harmonics are wrong.
#include "estimator/identification/even_sensor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "generated/registry.hpp"
#include "jobs/identify/identification.hpp"
#include "motion/simulate/experiment.hpp"
#include "tests/app/hardening_oscillator.hpp"
#include "tests/identification/virtual_campaign.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

using testing_support::value_of;
using testing_support::warns;

constexpr double quadratic_told = 4e5;

// Twelve dwells of an oscillator with a quadratic_told term.
SimulatedCampaign lopsided_dwells(std::uint64_t seed) {
  std::string text = testing_support::hardening_oscillator;
  text.replace(text.find("a2 = 0.0"), 8, "a2 = 4e5");
  const auto file = testing_support::process_folder() / "even_sensor.toml";
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text << R"([[dwell]]
frequencies_hz = [19.7, 19.85, 20.0, 20.1, 20.2, 20.35]
amplitudes = [0.2, 0.4]
settle_s = 12.0
ensembles = 4
ensemble_s = 2.0
)";
  const CompiledModel& model = *generated::find_compiled_model("duffing");
  return run_virtual_test(read_experiment(file, model), model, seed, 2);
}

// What a sensor makes of a response in a record.
using SensorLaw = std::function<double(double response, std::size_t record)>;

Identification identified_by_sensor(SimulatedCampaign made, const SensorLaw& sensor) {
  for (std::size_t r = 0; r < made.samples.size(); ++r)
    for (double& y : made.samples[r].channels[1]) y = sensor(y, r);
  IdentificationRequest request;
  request.model = "duffing";
  request.resonances = {"primary"};
  return identify_by_modulation(request, made.campaign, [&](std::size_t r) { return made.samples[r]; });
}

double largest_of(const SimulatedCampaign& made) {
  double largest = 0;
  for (const Record& record : made.samples)
    for (const double y : record.channels[1]) largest = std::max(largest, std::abs(y));
  return largest;
}

TEST(EvenSensor, IsAllowedForInWhatSecondHarmonicsTell) {
  const SimulatedCampaign made = lopsided_dwells(11);
  const double largest = largest_of(made);
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
