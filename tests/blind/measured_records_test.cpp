// Measured sets that take seconds, diagnosed by the program: what it says rightly of them stays right.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "blind/measured_run.hpp"
#include "blind/measured_score.hpp"
#include "blind/measured_sets.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular::blind {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class SlowMeasuredRecords : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(data)) GTEST_SKIP() << "../shared/data is not there: no measured set is diagnosed";
    list = read_measured_list(testing_support::source_folder() / "models/measured/sets.toml");
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::vector<MeasuredResult> run(const fs::path& files) const {
    const MeasuredRun run = run_measured(list, {files, folder / "work"},
                                         {.program = testing_support::program(), .threads = 1}, false, {});
    EXPECT_EQ(run.results.front().reason, "");
    return run.results;
  }

  /// A file of times and one channel, with `offset` subtracted from the channel.
  static void shift(double offset, const fs::path& from, const fs::path& to) {
    std::ifstream in(from);
    std::ofstream out(to);
    std::string line;
    std::getline(in, line);
    out << line << '\n' << std::setprecision(12);
    while (std::getline(in, line)) {
      const std::size_t value = line.find(',') + 1;
      out << line.substr(0, value) << std::stod(line.substr(value)) - offset << '\n';
    }
  }

  const fs::path data = testing_support::source_folder() / "../shared/data";
  const fs::path folder = testing_support::process_folder() / "secular_measured_records";
  MeasuredList list;
};

// As it was measured, test_app diagnoses it (SlowMeasuredDiagnosis). An encoder's zero is known to a step or so
// (0.436 mrad): with another one, friction is still among what acts, and no verdict says that something else does.
TEST_F(SlowMeasuredRecords, ThePendulumHasDryFrictionWhateverItsZero) {
  list = only_sets(list, {"pendulum_80"});
  const std::string import = testing_support::program() + " import " +
                             (data / list.sets.front().files.front()).string() +
                             " --kind free_decay --time t --channel theta:response:angle:rad -o " +
                             (folder / "campaign").string() + " >/dev/null";
  ASSERT_EQ(std::system(import.c_str()), 0) << import;
  shift(0.5e-3, folder / "campaign/records/cdip_pend_data.csv", folder / "shifted.csv");
  list.sets.front().files = {"shifted.csv"};
  list.sets.front().import = {"--kind", "free_decay", "--channel", "theta:response:angle:rad"};
  const nlohmann::json shifted = run(folder).front().diagnosis;
  Names acting = shifted.at("set");
  for (const std::string effect : shifted.value("together", nlohmann::json::array())) acting.push_back(effect);
  EXPECT_NE(std::find(acting.begin(), acting.end(), "coulomb_friction"), acting.end()) << shifted["together"];
  const Names possible = {"coulomb_friction", "hysteresis",    "stribeck_friction", "quadratic_damping",
                          "cubic_damping",    "power_damping", "sensor_offset"};
  for (const std::string& effect : named_effects(shifted))
    EXPECT_NE(std::find(possible.begin(), possible.end(), effect), possible.end()) << effect;
}

// The zero of its gyro is found, as a cause that goes with friction; no law of the spring is.
TEST_F(SlowMeasuredRecords, TheWheelOnATorsionBarHasNoStiffnessLaw) {
  list = only_sets(list, {"wheel_torsion"});
  for (const std::string& phrase : missed(0, list, run(data))) EXPECT_FALSE(phrase.ends_with(" named")) << phrase;
}

}  // namespace
}  // namespace secular::blind
