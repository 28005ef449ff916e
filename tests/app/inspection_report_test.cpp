// `secular inspect`: the answer in one sentence, a report with pictures, and an import command that can be run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

class InspectionReport : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_ / "c" / "records"); }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  std::string read(const std::string& name) const {
    std::ifstream stream(folder_ / name);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  // 2 s at 512 Hz.
  void record(const std::string& name, const std::string& names, const std::function<double(int)>& tip,
              const std::function<double(int)>& time) const {
    std::string text = names + "\n";
    for (int i = 0; i < 1024; ++i)
      text += std::to_string(time(i)) + "," + std::to_string(i % 7) + "," + std::to_string(tip(i)) + "\n";
    write(name, text);
  }

  testing_support::Outcome run(const std::string& arguments) const {
    return testing_support::run_program(folder_, arguments);
  }

  const fs::path folder_ = testing_support::process_folder() / "secular_inspection_report";
};

double even(int i) {
  return i / 512.0;
}

double decaying(int i) {
  return std::exp(-0.004 * i) * std::sin(0.5 * i) + 0.01 * std::sin(1.9 * i * i);
}

TEST_F(InspectionReport, SaysFirstHowManyRecordsCanBeUsed) {
  std::string campaign = "schema = 1\nname = \"three\"\nsample_rate_hz = 512.0\n";
  for (const std::string name : {"force", "tip"})
    campaign += "[[channel]]\nname = \"" + name + "\"\nrole = \"" + (name == "tip" ? "response" : "excitation") +
                "\"\nquantity = \"" + (name == "tip" ? "acceleration" : "force") + "\"\nunit = \"" +
                (name == "tip" ? "m/s^2" : "N") + "\"\n";
  for (const std::string name : {"good", "dead", "uneven"})
    campaign += "[[record]]\nfile = \"records/" + name + ".csv\"\nkind = \"impact\"\n";
  write("c/campaign.toml", campaign);
  record("c/records/good.csv", "t,force,tip", decaying, even);
  record(
      "c/records/dead.csv", "t,force,tip", [](int) { return 3.0; }, even);
  record("c/records/uneven.csv", "t,force,tip", decaying, [](int i) { return even(i) + (i > 500 ? 0.3 : 0); });
  const testing_support::Outcome outcome = run("inspect c -o out");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const std::string said =
      "usable for identify: 1 of 3 records; records/dead.csv: tip: every sample is 3: a dead "
      "channel; records/uneven.csv: ";
  EXPECT_NE(outcome.output.find(said), std::string::npos) << outcome.output;
  EXPECT_NE(read("out/inspection.json").find("\"usable\": false"), std::string::npos);
  const std::string page = read("out/report.html");
  EXPECT_NE(page.find(said.substr(1)), std::string::npos);
  EXPECT_NE(page.find("strongest, 40."), std::string::npos);  // 0.5 rad a sample
  EXPECT_EQ(run("inspect c -o out").status, 2);
  EXPECT_EQ(run("inspect c -o c").status, 2);
}

TEST_F(InspectionReport, TheProposedImportCanBeRun) {
  record("a.csv", "Zeit (s),Kraft [N],Tip 1 [g]", decaying, even);
  const std::string output = run("inspect a.csv").output;
  const std::size_t begin = output.find("To use it: secular import");
  ASSERT_NE(begin, std::string::npos) << output;
  std::string command = output.substr(begin + 19, output.find('\n', begin) - begin - 19);
  for (const auto& [word, meant] : {std::pair("CAMPAIGN", "made"), std::pair("KIND", "impact")})
    command.replace(command.find(word), std::string(word).size(), meant);
  const testing_support::Outcome outcome = run(command);
  ASSERT_EQ(outcome.status, 0) << command << outcome.errors;
  EXPECT_EQ(read("made/records/a.csv").substr(0, 14), "t,Kraft,Tip 1\n");
  EXPECT_NE(run("inspect made").output.find("usable for identify: 1 of 1 record\n"), std::string::npos);
}

// A thermometer that stands still has no tone, and is not among the channels that are proposed.
TEST_F(InspectionReport, AChannelThatStandsStillIsNotProposedAndHasNoTone) {
  std::string text = "Zeit;Weg Spitze;Temperatur\n[s];[mm];[°C]\n";
  for (int i = 0; i < 7000; ++i) {
    std::string row =
        std::to_string(0.002 * i) + ';' + std::to_string(20 * std::exp(-7e-4 * i) * std::cos(0.09 * i)) + ";21.5\n";
    std::replace(row.begin(), row.end(), '.', ',');
    text += row;
  }
  write("warm.csv", text);
  const std::string output = run("inspect warm.csv").output;
  EXPECT_NE(output.find("Temperatur: constant"), std::string::npos) << output;
  EXPECT_EQ(output.find("foreign_tone"), std::string::npos) << output;
  EXPECT_EQ(output.find("nan"), std::string::npos) << output;
  EXPECT_NE(output.find("--kind KIND --channel 'Weg Spitze:response' --time Zeit\n"), std::string::npos) << output;
}

}  // namespace
}  // namespace secular
