// What `secular spectrum` says of a record that it cannot analyse: what is the matter with it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular::app {
namespace {

namespace fs = std::filesystem;
using testing_support::Outcome;
using testing_support::run_program;

class SpectrumCommand : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome spectrum(int rows, const std::function<double(int)>& sample, const std::string& options = "") {
    std::ofstream file(folder_ / "a.csv");
    file << "t [s],a [m/s^2]\n";
    for (int i = 0; i < rows; ++i) file << i / 256.0 << "," << sample(i) << "\n";
    file.close();
    return run_program(folder_, "spectrum a.csv " + options + " -o out --force");
  }

  const fs::path folder_ = testing_support::process_folder() / "secular_spectrum_command";
};

TEST_F(SpectrumCommand, AChannelOfZerosIsAChannelOfZeros) {
  const Outcome outcome = spectrum(256, [](int) { return 0; });
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.errors.find("every sample is zero"), std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.errors.find("--delays"), std::string::npos) << outcome.errors;
}

TEST_F(SpectrumCommand, SaysHowMuchAnEnsembleAllows) {
  const auto tone = [](int i) { return std::sin(0.7 * i); };
  const Outcome order = spectrum(20, tone, "--order 30");
  EXPECT_EQ(order.status, 2);
  EXPECT_NE(order.errors.find("20 samples determine 6 terms at most"), std::string::npos) << order.errors;
  EXPECT_EQ(spectrum(20, tone, "--order 6").status, 0);
  const Outcome ensemble = spectrum(256, tone, "--ensemble 1e300");
  EXPECT_EQ(ensemble.status, 2);
  EXPECT_NE(ensemble.errors.find("does not fit into 1 s"), std::string::npos) << ensemble.errors;
}

// A count of tones is one where they are what the record is made of, or what they leave is white noise.
TEST_F(SpectrumCommand, TonesAreCountedWhereTheyAreTones) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  const Outcome tone = spectrum(4096, [&](int i) { return 0.4 * std::sin(0.7 * i) + noise(random); });
  EXPECT_NE(tone.output.find("- 1 steady tone stands above white noise by a test"), std::string::npos)
      << tone.output;
  EXPECT_NE(tone.output.find("28.5"), std::string::npos) << tone.output;  // 0.7 rad a sample, in the table
  double x = 0, v = 0;
  const Outcome broadband = spectrum(4096, [&](int) {
    v = 0.95 * v - 0.2 * x + noise(random);
    return x += v;
  });
  EXPECT_NE(broadband.output.find("Steady tones are not counted"), std::string::npos) << broadband.output;
  EXPECT_NE(broadband.output.find("its terms are no tones of this record"), std::string::npos);
  EXPECT_EQ(broadband.output.find("above white noise"), std::string::npos) << broadband.output;
}

}  // namespace
}  // namespace secular::app
