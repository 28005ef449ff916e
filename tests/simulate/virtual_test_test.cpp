
#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "generated/registry.hpp"
#include "input/input_error.hpp"
#include "motion/simulate/noise.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"
#include "tests/simulate/simulated_campaign.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
const fs::path root = testing_support::source_folder();

std::string short_experiment(const std::string& more = {}) {
  return R"(schema = 1
name = "short"
model = "two_mass_mode1"
sample_rate_hz = 256.0
[parameters]
omega0 = 77.85
mu1 = 0.222
mu2 = 0.0
mu3 = 36.87
alpha2 = 0.0
alpha3 = -2.832e7
delta2 = 0.0
delta3 = 0.0
eta1 = -0.018
eta2 = 7.688
[excitation]
name = "base"
quantity = "acceleration"
noise_sd = 0.05
[[response]]
name = "v"
quantity = "acceleration"
noise_sd = 0.05
[[dwell]]
frequencies_hz = [24.7, 24.75]
amplitudes = [22.5]
ensembles = 2
ensemble_s = 1.0
settle_s = 30.0
initial_displacement = [1e-3]
carry_state = true
[[free_decay]]
initial_displacement = [1e-3]
duration_s = 2.0
)" + more;
}

fs::path written(const std::string& text) {
  const fs::path path = testing_support::process_folder() / "experiment.toml";
  std::ofstream(path) << text;
  return path;
}

const CompiledModel& model() {
  return *generated::find_compiled_model("two_mass_mode1");
}

TEST(VirtualTest, SameSeedSameSamplesWhateverTheThreads) {
  const Experiment experiment = read_experiment(written(short_experiment()), model());
  const SimulatedCampaign one = run_virtual_test(experiment, model(), 3, 1);
  const SimulatedCampaign four = run_virtual_test(experiment, model(), 3, 4);
  const SimulatedCampaign other = run_virtual_test(experiment, model(), 4, 1);
  ASSERT_EQ(one.samples.size(), 3U);
  for (std::size_t r = 0; r < 3; ++r) EXPECT_EQ(one.samples[r].channels, four.samples[r].channels);
  EXPECT_NE(one.samples[0].channels, other.samples[0].channels);
}

TEST(VirtualTest, RecordsCarryWhatWasDone) {
  const Experiment experiment = read_experiment(written(short_experiment()), model());
  const Campaign campaign = run_virtual_test(experiment, model(), 1, 1).campaign;
  EXPECT_EQ(campaign.records[1].kind, RecordKind::dwell);
  EXPECT_EQ(campaign.records[1].excitation_frequency_hz, 24.75);
  EXPECT_EQ(campaign.records[1].excitation_amplitude, 22.5);
  EXPECT_EQ(campaign.records[1].ensemble_s, 1.0);
  EXPECT_EQ(campaign.records[1].started_s, 62.0);
  EXPECT_EQ(campaign.records[2].kind, RecordKind::free_decay);
}

TEST(VirtualTest, NoiseIsWhiteAndOfTheStatedLevel) {
  NoiseStream noise(1, 2, 3);
  constexpr int n = 20000;
  double square = 0, lagged = 0, before = 0;
  for (int i = 0; i < n; ++i) {
    const double x = noise.gaussian();
    square += x * x;
    lagged += x * before;
    before = x;
  }
  const boost::math::chi_squared law(n);
  EXPECT_GT(square, boost::math::quantile(law, 0.0005));
  EXPECT_LT(square, boost::math::quantile(law, 0.9995));
  EXPECT_LT(std::abs(lagged) / n, 3.5 / std::sqrt(n));
}

TEST(VirtualTest, ShippedExperimentsAreReadable) {
  for (const auto& entry : fs::directory_iterator(root / "models/experiments")) {
    const std::string name = experiment_model(entry.path());
    const CompiledModel* compiled = generated::find_compiled_model(name);
    if (!compiled) {  // compiled when it is asked for
      EXPECT_TRUE(fs::exists(root / "models" / (name + ".toml"))) << entry.path();
      continue;
    }
    EXPECT_NO_THROW(read_experiment(entry.path(), *compiled)) << entry.path();
  }
}

void expect_complaint(std::string text, const std::string& from, const std::string& to, const std::string& part) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, from.size(), to);
  try {
    read_experiment(written(text), model());
    ADD_FAILURE() << "no complaint about " << to;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("line "), std::string::npos) << error.what();
  }
}

TEST(VirtualTest, MistakesInTheFileAreNamed) {
  const std::string text = short_experiment();
  expect_complaint(text, "mu3 = 36.87", "mu4 = 36.87", "key mu4: is not a known key");
  expect_complaint(text, "mu3 = 36.87\n", "", "key mu3: is missing");
  expect_complaint(text, "noise_sd = 0.05", "noise_sd = -1", "is negative");
  expect_complaint(text, "quantity = \"acceleration\"", "quantity = \"speed\"", "'speed'");
  expect_complaint(text, "[24.7, 24.75]", "[24.7, 300.0]", "half the sample rate");
  expect_complaint(text, "initial_displacement = [1e-3]", "initial_displacement = [1e-3, 0.0]",
                   "one for every coordinate");
  expect_complaint(text, "ensembles = 2", "ensembles = 0", "out of range");
  expect_complaint(text, "schema = 1", "schema = 7", "schema");
}

}  // namespace
}  // namespace secular
