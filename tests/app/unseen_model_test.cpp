// A model that the program has never seen, from experiment to estimates: compiled at its first use, and
// interpreted.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr const char* unseen_model_text = R"toml(schema = 1
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

constexpr const char* unseen_experiment_text = R"toml(schema = 1
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
    std::ofstream(folder_ / "model.toml") << unseen_model_text;
    std::string text = unseen_experiment_text;
    text.replace(text.find("MODEL"), 5, (folder_ / "model.toml").string());
    std::ofstream(folder_ / "experiment.toml") << text;
  }
  void TearDown() override { fs::remove_all(folder_); }

  // Standard error of a command that ends well.
  std::string run(const std::string& arguments, const std::string& program = testing_support::program()) const {
    return run_in("XDG_CACHE_HOME=" + (folder_ / "cache").string(), arguments, program);
  }
  std::string run_in(const std::string& environment, const std::string& arguments,
                     const std::string& program = testing_support::program()) const {
    const testing_support::Outcome outcome =
        testing_support::run_program(folder_, arguments, {.environment = environment, .program = program});
    EXPECT_EQ(outcome.status, 0) << arguments << ": " << outcome.errors;
    return outcome.errors;
  }
  // The program with its headers as it is installed.
  fs::path installed() const {
    const fs::path prefix = folder_ / "prefix", headers = prefix / "include" / "secular" / "estimator" / "model";
    fs::create_directories(prefix / "bin");
    fs::create_directories(headers);
    fs::copy_file(testing_support::program(), prefix / "bin" / "secular");
    for (const auto& entry : fs::directory_iterator(testing_support::source_folder() / "estimator" / "model"))
      if (entry.path().extension() == ".hpp") fs::copy_file(entry.path(), headers / entry.path().filename());
    return prefix;
  }
  static std::size_t entries(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
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

// No home to keep anything in, as for a service account; /dev/null is no folder for root either.
TEST_F(SlowUnseenModel, NeedsNoFolderThatLasts) {
  run("simulate experiment.toml -o campaign");
  run("identify campaign --model model.toml -o compiled");
  const fs::path temporary = folder_ / "tmp";
  fs::create_directory(temporary);
  const std::string homeless = "-u XDG_CACHE_HOME HOME=/dev/null TMPDIR=";
  EXPECT_EQ(run_in(homeless + temporary.string(), "identify campaign --model model.toml -o homeless"), "");
  EXPECT_EQ(estimates("homeless"), estimates("compiled"));
  EXPECT_EQ(entries(temporary), 0u) << "something was left behind";
  const std::size_t before = entries(folder_);
  const std::string note = run_in(homeless + "/dev/null", "identify campaign --model model.toml -o nowhere");
  EXPECT_NE(note.find("is interpreted, which is slower: no folder for compiled code can be written"),
            std::string::npos)
      << note;
  EXPECT_EQ(entries(folder_), before + 1);
  for (const auto& [name, value] : estimates("compiled"))
    EXPECT_NEAR(estimates("nowhere").at(name).first, value.first, 1e-3 * value.second) << name;
}

TEST_F(SlowUnseenModel, AnInstalledProgramUsesItsOwnHeaders) {
  run("simulate experiment.toml -o campaign");
  const fs::path prefix = installed();
  const std::string program = (prefix / "bin" / "secular").string();
  EXPECT_EQ(run("identify campaign --model model.toml -o first", program), "");
  EXPECT_EQ(cached(".so"), 2u);  // of `simulate`, equations of motion alone, and of `identify`
  // Two at once, of a model that neither has seen.
  std::ofstream(folder_ / "model.toml", std::ios::app) << "c1 = 0.3\n";
  const std::string again = program + " identify campaign --model model.toml -o ";
  const std::string quiet = " > /dev/null 2>&1 < /dev/null";
  EXPECT_EQ(run("-c '" + again + "one" + quiet + " & " + again + "two" + quiet + "; wait $!'", "sh"), "");
  EXPECT_EQ(estimates("one"), estimates("two"));
  EXPECT_EQ(cached(".so"), 3u);
  // Headers are part of what an object is made from.
  std::ofstream(prefix / "include/secular/estimator/model/compiled_model.hpp", std::ios::app) << "#error marked\n";
  const std::string note = run("identify campaign --model model.toml -o marked", program);
  EXPECT_NE(note.find("#error marked"), std::string::npos) << note;
}

// In a folder of any name, with no other files of the project than those that are installed.
TEST_F(SlowUnseenModel, AnInstalledProgramSaysHowItsCodeIsCompiled) {
  const std::string program = (installed() / "bin" / "secular").string();
  EXPECT_EQ(run("-c \"" + program + " generate model.toml -o 'any name' > said\"", "sh"), "");
  EXPECT_EQ(run("-c \"cd 'any name' && sed -n 's/^compile them there: //p' ../said > line && sh line\"", "sh"), "");
  for (const char* name : {"beam_with_stop.o", "registry.o"}) EXPECT_TRUE(fs::exists(folder_ / "any name" / name));
  std::ifstream stream(folder_ / "any name" / "line");
  const std::string line{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_NE(line.find((folder_ / "prefix").string()), std::string::npos) << line;
  EXPECT_EQ(line.find(testing_support::source_folder().string()), std::string::npos) << line;
}

}  // namespace
}  // namespace secular
