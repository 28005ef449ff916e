// A model that the program has never seen, from experiment to estimates: compiled at its first use, and
// interpreted.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr const char* model_text = R"toml(schema = 1
name = "beam_with_stop"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -2*c1*D(x) - c3*D(x)^3 - k3*x^3"
[[case]]
name = "decay"
order = { c1 = 1, c3 = 1, k3 = 1 }
expand_to = 1
excitation = false
[nominal]
w = 40
)toml";

constexpr const char* experiment_text = R"toml(schema = 1
name = "beam"
model = "MODEL"
sample_rate_hz = 128.0
[parameters]
w = 40.0
c1 = 0.25
c3 = 0.05
k3 = 4000.0
[[response]]
name = "x"
quantity = "displacement"
unit = "m"
noise_sd = 1e-6
[[free_decay]]
initial_displacement = [0.04]
duration_s = 12.0
[[free_decay]]
initial_displacement = [0.05]
duration_s = 12.0
)toml";

class SlowUnseenModel : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "cache");
    std::ofstream(folder_ / "model.toml") << model_text;
    std::string text = experiment_text;
    text.replace(text.find("MODEL"), 5, (folder_ / "model.toml").string());
    std::ofstream(folder_ / "experiment.toml") << text;
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Standard error of a command that ends well.
  std::string run(const std::string& arguments) const {
    const fs::path errors = folder_ / "stderr.txt";
    const int raw =
        std::system(("cd " + folder_.string() + " && XDG_CACHE_HOME=" + (folder_ / "cache").string() + " " +
                     SECULAR_PROGRAM + " " + arguments + " > /dev/null 2> " + errors.string() + " < /dev/null")
                        .c_str());
    std::ifstream stream(errors);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_TRUE(WIFEXITED(raw) && WEXITSTATUS(raw) == 0) << arguments << ": " << text;
    return text;
  }
  std::map<std::string, std::pair<double, double>> estimates(const std::string& output) const {
    std::ifstream stream(folder_ / output / "estimate.json");
    std::map<std::string, std::pair<double, double>> values;
    const nlohmann::json document = nlohmann::json::parse(stream);
    for (const auto& item : document.at("estimates"))
      if (item.at("identifiable").get<bool>())
        values[item.at("name").get<std::string>()] = {item.at("value").get<double>(), item.at("sd").get<double>()};
    return values;
  }
  std::size_t cached(const std::string& extension) const {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache"))
      if (entry.path().extension() == extension) ++count;
    return count;
  }

  fs::path folder_ = testing_support::process_folder() / "unseen";
};

TEST_F(SlowUnseenModel, HasTheSameEstimatesCompiledCachedAndInterpreted) {
  EXPECT_EQ(run("simulate experiment.toml -o campaign"), "");
  EXPECT_EQ(run("identify campaign --model model.toml -o compiled"), "");
  EXPECT_GT(cached(".so"), 0u);
  EXPECT_EQ(cached(".model"), 0u);
  EXPECT_EQ(run("identify campaign --model model.toml -o again"), "");
  EXPECT_EQ(run("identify campaign --model model.toml --interpret -o interpreted"), "");
  EXPECT_EQ(cached(".model"), 1u);
  EXPECT_EQ(run("identify campaign --model model.toml --interpret -o interpreted_again"), "");
  const auto compiled = estimates("compiled");
  EXPECT_EQ(compiled, estimates("again"));
  EXPECT_EQ(estimates("interpreted"), estimates("interpreted_again"));
  const std::map<std::string, double> truth = {{"w", 40}, {"c1", 0.25}, {"c3", 0.05}, {"k3", 4000}};
  for (const auto& [name, value] : truth) {
    ASSERT_TRUE(compiled.count(name)) << name;
    const auto [estimate, sd] = compiled.at(name);
    const auto [other, other_sd] = estimates("interpreted").at(name);
    // Both replays integrate to 1e-10 and may choose other steps: 4e-9 rad/s in the frequency, of which k3 is
    // 8 w/(3 a^2) = 6e4 times as much, 1e-4 of its error bar.
    EXPECT_NEAR(estimate, other, 1e-3 * sd) << name;
    EXPECT_NEAR(estimate, value, 4 * sd) << name;
  }
}

}  // namespace
}  // namespace secular
