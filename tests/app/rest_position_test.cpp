// A model about its rest position, as docs/new_resonance_case.md has it: simulated with its load, identified, and
// predicted.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::text_of;

class LoadedSpring : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    const std::string page = text_of(testing_support::source_folder() / "docs" / "new_resonance_case.md");
    const std::size_t section = page.find("## A rest position that is not zero"),
                      begin = page.find('\n', page.find("```toml", section)) + 1, end = page.find("```", begin);
    write("spring.toml", page.substr(begin, end - begin));
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const char* name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  int run(const std::string& arguments) const {
    return testing_support::run_with_shared_cache(folder_, arguments).status;
  }
  nlohmann::json read(const char* name) const { return nlohmann::json::parse(text_of(folder_ / name)); }
  std::string errors() const { return text_of(folder_ / "stderr.txt"); }

  // k*x + a3*x^3 = g0 at x = 0.01, where the square of the frequency is k + 3*a3*x^2. What hardens and what the
  // asymmetry softens, a3 and 10*(a3*x)^2/omega0^2, differ by a factor of ten: where they cancel nothing parts
  // them.
  static constexpr double k = 1000, a3 = 1e5, rest = 0.01, g0 = k * rest + a3 * rest * rest * rest, mu = 0.5;
  const double frequency_ = std::sqrt(k + 3 * a3 * rest * rest);
  fs::path folder_ = testing_support::process_folder() / "loaded-spring";
};

TEST_F(LoadedSpring, IsIdentifiedFromItsDecays) {
  std::string decays;
  for (const char* at : {"0.008", "0.006", "0.004"})
    decays += std::string("[[free_decay]]\ninitial_displacement = [") + at + "]\nduration_s = 4.0\n";
  const std::string head =
      "schema = 1\nname = \"decays\"\nmodel = \"spring.toml\"\nsample_rate_hz = 256.0\n"
      "[parameters]\nmu = 0.5\neta = 1.0\na3 = 1e5\n";
  const std::string sensor =
      "[[response]]\nname = \"x\"\nquantity = \"displacement\"\nunit = \"m\"\nnoise_sd = 2e-6\n";
  write("decays.toml", head + "k = 1000.0\ng0 = 10.1\n" + sensor + decays);
  ASSERT_EQ(run("simulate decays.toml -o decays --seed 1"), 0) << errors();
  // The same by what the model has as parameters.
  write("about_rest.toml", head + "omega0 = " + std::to_string(frequency_) + "\nx_rest = 0.01\n" + sensor + decays);
  ASSERT_EQ(run("simulate about_rest.toml -o about_rest --seed 1"), 0) << errors();
  ASSERT_EQ(run("identify decays --model spring.toml -o estimate"), 0) << errors();
  const nlohmann::json estimate = read("estimate/estimate.json");
  int seen = 0;
  const auto expect = [&](const nlohmann::json& entry, const std::string& name, double truth, double share) {
    if (entry.at("name") != name) return;
    ++seen;
    ASSERT_FALSE(entry.at("value").is_null()) << name;
    const double sd = entry.at("sd").get<double>();
    EXPECT_LT(sd, share * truth) << name;
    EXPECT_NEAR(entry.at("value").get<double>(), truth, 4 * sd) << name;
  };
  for (const auto& entry : estimate.at("estimates")) {
    expect(entry, "omega0", frequency_, 1e-3);
    expect(entry, "x_rest", rest, 0.1);
    expect(entry, "a3", a3, 0.2);
    expect(entry, "mu", mu, 0.02);
  }
  for (const auto& entry : estimate.at("follows_from_rest")) {
    expect(entry, "g0", g0, 0.1);
    expect(entry, "k", k, 0.1);
  }
  EXPECT_EQ(seen, 6);
  // Zero is no start for a3 and x_rest, whose product acts: there the decays' own numbers are.
  ASSERT_EQ(run("diagnose decays --model spring.toml -o diagnosis"), 0) << errors();
  EXPECT_FALSE(read("diagnosis/diagnosis.json").at("gap").at("detected").get<bool>());
}

// Frequency against amplitude, by the load and by what the model has as parameters:
// omega0 + (3*a3/8/omega0 - 15*(a3*x_rest)^2/4/omega0^3)*a^2.
TEST_F(LoadedSpring, ItsBackboneIsThatAboutRest) {
  write("stated.json", R"({"k": 1000, "a3": 1e5, "g0": 10.1, "mu": 0.5, "eta": 1})");
  ASSERT_EQ(run("predict spring.toml --case free --parameters stated.json --largest 0.004 -o stated"), 0)
      << errors();
  const nlohmann::json found = read("stated/prediction.json");
  const double w = frequency_, bend = 3 * a3 / 8 / w - 15 * std::pow(a3 * rest, 2) / 4 / std::pow(w, 3);
  std::size_t points = 0;
  for (const auto& point : found.at("backbones").at(0).at("points")) {
    const double a = point.at("amplitude").get<double>();
    EXPECT_NEAR(point.at("frequency").get<double>(), w + bend * a * a, 1e-9 * w) << point;
    ++points;
  }
  EXPECT_GT(points, 5U);
  write("both.json", R"({"k": 1000, "a3": 1e5, "g0": 10.1, "mu": 0.5, "eta": 1, "omega0": 32})");
  EXPECT_EQ(run("predict spring.toml --case free --parameters both.json --largest 0.004 -o both"), 2);
  EXPECT_NE(errors().find("omega0 follows from them"), std::string::npos) << errors();
}

}  // namespace
}  // namespace secular
