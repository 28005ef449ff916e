// What records hold beside the motion, in what inspect, identify and diagnose print and write.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/report/page_structure.hpp"

namespace secular::app {
namespace {

using Json = nlohmann::json;
using testing_support::run_program;
using testing_support::text_of;

constexpr const char* noisy_model_text = R"toml(schema = 1
name = "oscillator"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -2*m*D(x)"
[[case]]
name = "free"
order = { m = 1 }
expand_to = 1
excitation = false
[nominal]
w = 12
)toml";

constexpr const char* noisy_experiment_text = R"toml(schema = 1
name = "encoder"
model = "oscillator.toml"
sample_rate_hz = 128.0
[parameters]
w = 12.0
m = 0.1
[[response]]
name = "x"
quantity = "displacement"
unit = "m"
quantisation = 0.02
noise_sd = 0.001
[[free_decay]]
initial_displacement = [1.0]
duration_s = 30.0
)toml";

using SlowDisturbanceOutput = TemporaryFolder;

// A displacement that lies on the lattice of an encoder, which is what a campaign has beside the motion here.
TEST_F(SlowDisturbanceOutput, IsTheSameListEverywhere) {
  write("oscillator.toml", noisy_model_text);
  write("experiment.toml", noisy_experiment_text);
  const auto run = [&](const std::string& arguments) {
    const auto outcome = run_program(folder_, arguments);
    EXPECT_EQ(outcome.status, 0) << arguments << "\n" << outcome.errors;
    return outcome;
  };
  run("simulate experiment.toml -o campaign --seed 1");
  const Json inspected = Json::parse(run("inspect campaign --json").output);
  EXPECT_NE(run("inspect campaign").output.find("converter_step: in 1 of 1 records"), std::string::npos);
  const auto identified = run("identify campaign --model oscillator.toml -o identified --interpret");
  const auto diagnosed = run("diagnose campaign --model oscillator.toml -o diagnosed --interpret");
  const Json list = inspected.at("disturbances");
  ASSERT_EQ(list.size(), 1u) << list.dump(1);
  EXPECT_EQ(list[0].at("kind"), "converter_step");
  EXPECT_EQ(list[0].at("channel"), "x");
  EXPECT_NEAR(list[0].at("size").get<double>(), 0.02, 1e-9);
  for (const char* key : {"record", "from_s", "to_s", "unit", "share", "text"})
    EXPECT_TRUE(list[0].contains(key)) << key;
  EXPECT_EQ(Json::parse(text_of(folder_ / "identified/estimate.json")).at("disturbances"), list);
  EXPECT_EQ(Json::parse(text_of(folder_ / "diagnosed/diagnosis.json")).at("disturbances"), list);
  for (const auto& outcome : {identified, diagnosed}) {
    EXPECT_NE(outcome.output.find("converter_step: in 1 of 1 records"), std::string::npos) << outcome.output;
    EXPECT_EQ(outcome.errors.find("converter_step"), std::string::npos) << outcome.errors;
  }
  for (const char* file : {"identified/report.html", "diagnosed/report.html"}) {
    const std::string page = text_of(folder_ / file);
    EXPECT_NE(page.find("Disturbances"), std::string::npos) << file;
    EXPECT_EQ(report::test::structure_faults(page), std::vector<std::string>()) << file;
  }
}

}  // namespace
}  // namespace secular::app
