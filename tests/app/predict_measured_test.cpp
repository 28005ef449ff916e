// Measured dwells on the predicted response.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr const char* model_text = R"toml(schema = 1
name = "forced_duffing"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -2*c*D(x) - k3*x^3 + e*F*cos(Omega*t)"
[[case]]
name = "primary"
relations = ["Omega = w + eps*sigma"]
order = { c = 1, k3 = 1, e = 1 }
expand_to = 1
)toml";

// Four dwells at the prediction's excitation and one at twice of it.
constexpr const char* experiment_text = R"toml(schema = 1
name = "forced"
model = "FOLDER/model.toml"
sample_rate_hz = 64.0
[parameters]
w = 40.0
c = 1.0
k3 = 1000.0
e = 1.0
[excitation]
name = "base"
quantity = "acceleration"
unit = "m/s^2"
[[response]]
name = "x"
quantity = "displacement"
unit = "m"
[[dwell]]
frequencies_hz = [6.2, 6.3, 6.36, 6.5]
amplitudes = [1.0]
ensembles = 3
ensemble_s = 2.0
settle_s = 12.0
[[dwell]]
frequencies_hz = [6.3]
amplitudes = [2.0]
ensembles = 3
ensemble_s = 2.0
settle_s = 12.0
)toml";

class SlowMeasuredDwells : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "cache");
    std::ofstream(folder_ / "model.toml") << model_text;
    std::string text = experiment_text;
    text.replace(text.find("FOLDER"), 6, folder_.string());
    std::ofstream(folder_ / "experiment.toml") << text;
    std::ofstream(folder_ / "numbers.json") << R"({"w": 40, "c": 1, "k3": 1000, "e": 1})";
  }
  void TearDown() override { fs::remove_all(folder_); }
  int run(const std::string& arguments) const {
    const int raw = std::system(("cd " + folder_.string() + " && XDG_CACHE_HOME=" + (folder_ / "cache").string() +
                                 " " + SECULAR_PROGRAM + " " + arguments + " > /dev/null 2> stderr.txt < /dev/null")
                                    .c_str());
    return WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
  }
  std::string errors() const {
    std::ifstream stream(folder_ / "stderr.txt");
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_ = fs::temp_directory_path() / ("secular-measured-" + std::to_string(::getpid()));
};

TEST_F(SlowMeasuredDwells, LieOnTheResponseOfTheirExcitation) {
  ASSERT_EQ(run("simulate experiment.toml -o campaign"), 0) << errors();
  const std::string predict = "predict model.toml --parameters numbers.json --hz ";
  ASSERT_EQ(run(predict + "--vary Omega 6 6.7 --at F=1 --measured campaign -o over"), 0) << errors();
  EXPECT_NE(errors().find("1 of 5 responding dwells"), std::string::npos) << errors();
  std::ifstream stream(folder_ / "over" / "prediction.json");
  const auto measured = nlohmann::json::parse(stream).at("measured");
  ASSERT_EQ(measured.size(), 4u);
  double previous = 0;
  for (const auto& point : measured) {
    const double omega = point.at("Omega").get<double>(), a = point.at("amplitude")[0].get<double>();
    EXPECT_GT(omega, previous);
    previous = omega;
    // |response| of the oscillator linearised at its own amplitude: F = a |w^2 + 3/4 k3 a^2 - W^2 + 2 i c W|.
    const double stiff = 1600 + 750 * a * a - omega * omega;
    EXPECT_NEAR(a * std::hypot(stiff, 2 * omega), 1, 0.01) << omega;
    EXPECT_LT(point.at("sd_between_ensembles")[0].get<double>(), 0.01 * a);
  }
  std::ifstream page(folder_ / "over" / "report.html");
  const std::string html{std::istreambuf_iterator<char>(page), {}};
  EXPECT_NE(html.find("measured dwells"), std::string::npos);
  // Over the amplitude: the dwells at that frequency.
  ASSERT_EQ(run(predict + "--vary F 0.5 3 --at Omega=6.3 --measured campaign -o levels"), 0) << errors();
  std::ifstream levels(folder_ / "levels" / "prediction.json");
  EXPECT_EQ(nlohmann::json::parse(levels).at("measured").size(), 2u);
  // What cannot be drawn is said.
  EXPECT_EQ(run(predict + "--vary Omega 6 6.7 --at F=7 --measured campaign -o none"), 2);
  EXPECT_NE(errors().find("none of its 5 responding dwells"), std::string::npos) << errors();
  EXPECT_FALSE(fs::exists(folder_ / "none"));
}

}  // namespace
}  // namespace secular
