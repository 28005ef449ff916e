// Records that nobody measures and anybody may try: no command ends with a signal or as a bug.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr int samples = 512;
constexpr double sample_rate_hz = 1024;

double phase(int k) {
  return 2 * std::numbers::pi * 50 * k / sample_rate_hz;
}

struct PlainRecord {
  const char* name;
  std::function<double(int)> first, second;  // of the sample's number
  int modal;                                 // exit status of `secular modal`
  const char* said;                          // a part of what it says on standard error
};

void PrintTo(const PlainRecord& record, std::ostream* out) {
  *out << record.name;
}

class PlainRecords : public testing::TestWithParam<PlainRecord> {
 protected:
  void SetUp() override {
    folder_ = testing_support::process_folder() / ("plain_" + std::string(GetParam().name));
    fs::create_directories(folder_);
    std::ofstream csv(folder_ / "a.csv");
    csv.precision(17);
    csv << "t,a,b\n";
    for (int k = 0; k < samples; ++k)
      csv << k / sample_rate_hz << ',' << GetParam().first(k) << ',' << GetParam().second(k) << '\n';
  }
  void TearDown() override { fs::remove_all(folder_); }

  testing_support::Outcome run(const std::string& arguments) const {
    return testing_support::run_program(folder_, arguments);
  }

  fs::path folder_;
};

TEST_P(PlainRecords, EndWithAResultOrAMessage) {
  const auto ends_well = [](const testing_support::Outcome& outcome) {
    EXPECT_TRUE(outcome.status == 0 || outcome.status == 2) << outcome.status << outcome.errors;
  };
  EXPECT_EQ(run("inspect a.csv -o seen").status, 0);
  ends_well(run("spectrum a.csv -o spectrum"));
  const std::string channel = ":response:displacement:m";
  const testing_support::Outcome import =
      run("import a.csv -o campaign --kind free_decay --channel a" + channel + " --channel b" + channel);
  ends_well(import);
  if (import.status != 0) {
    EXPECT_NE(import.errors.find(GetParam().said), std::string::npos) << import.errors;
    return;
  }
  EXPECT_EQ(run("inspect campaign -o inspected").status, 0);
  const testing_support::Outcome modal = run("modal campaign -o modal");
  EXPECT_EQ(modal.status, GetParam().modal) << modal.errors;
  EXPECT_NE(modal.errors.find(GetParam().said), std::string::npos) << modal.errors;
}

const PlainRecord plain_records[] = {
    {"whirl", [](int k) { return std::sin(phase(k)); }, [](int k) { return std::cos(phase(k)); }, 0,
     "the squares of the shape cancel"},
    {"constant", [](int) { return 3.0; }, [](int) { return -1.0; }, 2, "too short"},
    {"one_of_many", [](int k) { return k == 0 ? 1.0 : 0.0; }, [](int) { return 0.0; }, 1, "no mode stands"},
    {"exponential", [](int k) { return std::exp(0.1 * k); }, [](int k) { return std::exp(-0.1 * k); }, 2,
     "too short"},
    {"huge", [](int k) { return 1e160 * std::sin(phase(k)); }, [](int k) { return std::cos(phase(k)); }, 2,
     "a.csv, variable a: its largest number, 1e+160"},
    {"tiny", [](int k) { return 1e-170 * std::sin(phase(k)); }, [](int k) { return std::cos(phase(k)); }, 2,
     "a.csv, variable a: its largest number, 1e-170"},
};

INSTANTIATE_TEST_SUITE_P(Made, PlainRecords, testing::ValuesIn(plain_records),
                         [](const auto& record) { return record.param.name; });

}  // namespace
}  // namespace secular
