// What is typed wrong, and what is read by programs.
#include "app/shared/unknown_word.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "input/nearest_word.hpp"
#include "tests/app/duffing_decay.hpp"
#include "tests/app/program_run.hpp"
#include "tests/places.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using testing_support::Outcome;

TEST(NearestWord, IsASlipAway) {
  const std::vector<std::string> known = {"identify", "inspect", "import", "diagnose"};
  EXPECT_EQ(nearest_word("diagnoze", known), "diagnose");
  EXPECT_EQ(nearest_word("improt", known), "import");  // a swap is one slip
  EXPECT_EQ(nearest_word("identfy", known), "identify");
  EXPECT_EQ(nearest_word("inspectt", known), "inspect");
  EXPECT_EQ(nearest_word("frobnicate", known), std::nullopt);
  EXPECT_EQ(nearest_word("", known), std::nullopt);
  EXPECT_EQ(remedy_for_word("one of them", "improt", known), "one of them; did you mean import?");
  EXPECT_EQ(remedy_for_word("one of them", "import", known), "one of them") << "it is spelled right";
}

class TypedWords : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  Outcome run(const std::string& arguments) const { return testing_support::run_program(folder_, arguments); }

  fs::path folder_ = testing_support::process_folder() / "typed_words";
};

TEST_F(TypedWords, UnknownOnesAreNamedWithWhatMayBeMeant) {
  const std::pair<std::string, std::string> cases[] = {
      {"diagnoze c", "diagnoze is no command of `secular`; did you mean diagnose?"},
      {"frobnicate", "frobnicate is no command of `secular`; `secular --help` lists them"},
      {"identify c --modl duffing", "--modl is no option of `secular identify`; did you mean --model?"},
      {"identify c --model duffing -o out --treads=3",
       "--treads is no option of `secular identify`; did you mean "
       "--threads?"},
      {"blind scor set", "scor is no command of `secular blind`; did you mean score?"}};
  for (const auto& [arguments, message] : cases) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.errors, "secular: " + message + "\n");
  }
  // Of a value that is one of several words.
  const Outcome curve =
      run("predict duffing --parameters p --vary F 1 2 --against e 1 2 --curve saddle-node -o out");
  EXPECT_EQ(curve.status, 2);
  EXPECT_NE(curve.errors.find("--curve: 'saddle-node' is none of saddle_node, threshold, hopf, peak; did you mean "
                              "saddle_node?"),
            std::string::npos)
      << curve.errors;
  // Kinds, roles, quantities, units, variables, cases, symbols, shipped files.
  std::ofstream(folder_ / "a.csv") << "time,x\n0,1\n0.1,2\n0.2,3\n0.3,1\n";
  const std::pair<std::string, std::string> values[] = {
      {"import a.csv -o c --kind Dwell --channel x:response:displacement:m", "did you mean dwell?"},
      {"import a.csv -o c --kind freedecay --channel x:response:displacement:m", "did you mean free_decay?"},
      {"import a.csv -o c --kind dwell --channel x:Response", "did you mean response?"},
      {"import a.csv -o c --kind dwell --channel x:respnse:displacement:m", "did you mean response?"},
      {"import a.csv -o c --kind dwell --channel x:response:Displacment:m", "did you mean displacement?"},
      {"import a.csv -o c --kind dwell --channel x:response:displacement:Mm", "did you mean mm?"},
      {"import a.csv -o c --kind dwell --channel X:response:displacement:m", "did you mean x?"},
      {"import a.csv -o c --kind dwell --time Time --channel x:response:displacement:m", "did you mean time?"},
      {"import a.csv -o c --kind lines --amplitudes RMS --channel x:response:displacement:m", "did you mean rms?"},
      {"predict duffing --case primry --parameters p --vary Omega 1 2 -o out", "did you mean primary?"},
      {"derive duffng", "did you mean duffing?"},
      {"simulate experiments/principal_parametrc -o c", "did you mean experiments/principal_parametric?"}};
  for (const auto& [arguments, message] : values) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.errors.find(message), std::string::npos) << arguments << '\n' << outcome.errors;
  }
  // What is missing is still said where every word is known.
  EXPECT_NE(run("identify c --model duffing").errors.find("--output is required"), std::string::npos);
}

TEST_F(TypedWords, NumbersForProgramsArePlain) {
  std::ofstream(folder_ / "experiment.toml") << testing_support::duffing_decay("-10");
  ASSERT_EQ(run("simulate experiment.toml -o campaign").status, 0);
  for (const std::string command :
       {"identify campaign --model duffing -o out", "modal campaign --modes 1 -o modal", "inspect campaign"}) {
    const Outcome outcome = run(command);
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_TRUE(std::all_of(outcome.output.begin(), outcome.output.end(), [](char c) {
      return static_cast<unsigned char>(c) < 128;
    })) << outcome.output;
  }
  // The page is for people, whoever reads what is printed.
  EXPECT_NE(testing_support::text_of(folder_ / "out/report.html").find("\u2212"), std::string::npos);
}

TEST_F(TypedWords, ControlCharactersAreShownAndNotObeyed) {
  std::ofstream(folder_ / "r.csv") << "t,a\x1b[2Jb\n0,1\n1,2\n2,1\n3,2\n";
  for (const std::string arguments : {"inspect r.csv", "import r.csv --kind free_decay --channel z:response -o c",
                                      "inspect $(printf 'no\\033such')"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ((outcome.output + outcome.errors).find('\x1b'), std::string::npos) << arguments;
    EXPECT_NE((outcome.output + outcome.errors).find("\\x1b"), std::string::npos)
        << outcome.output << outcome.errors;
  }
}

TEST_F(TypedWords, LinksOutOfACampaignAreNotFollowed) {
  fs::create_directories(folder_ / "c/records");
  std::ofstream(folder_ / "outside.csv") << "t,x\n0,1\n1,2\n2,1\n3,2\n";
  std::ofstream(folder_ / "c/campaign.toml")
      << "schema = 1\nname = \"n\"\nsample_rate_hz = 1.0\n[[channel]]\nname = "
         "\"x\"\nrole = \"response\"\nquantity = \"displacement\"\nunit = "
         "\"m\"\n[[record]]\nfile = \"records/r.csv\"\nkind = \"free_decay\"\n";
  fs::create_symlink("../../outside.csv", folder_ / "c/records/r.csv");
  const Outcome refused = run("inspect c");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("is a link that leaves the campaign folder"), std::string::npos) << refused.errors;
  // One that stays inside, and a link to the campaign, are followed.
  fs::copy_file(folder_ / "outside.csv", folder_ / "c/records/own.csv");
  fs::remove(folder_ / "c/records/r.csv");
  fs::create_symlink("own.csv", folder_ / "c/records/r.csv");
  fs::create_directory_symlink("c", folder_ / "link");
  EXPECT_EQ(run("inspect link").status, 0) << run("inspect link").errors;
}

TEST_F(TypedWords, NumbersThatAreNoneAreRefused) {
  std::ofstream(folder_ / "p.json") << R"({"omega0": 1, "mu": 1e999, "a2": 0, "a3": 0.1, "e": 1, "F": 0.01})";
  const Outcome beyond = run("predict duffing --parameters p.json --case free --largest 0.5 -o out");
  EXPECT_EQ(beyond.status, 2) << beyond.errors;
  EXPECT_NE(beyond.errors.find("p.json"), std::string::npos) << beyond.errors;
  for (const std::string value : {"nan", "inf", "1e999", "", "1x"}) {
    const Outcome outcome = run("identify campaign --model duffing --fix mu=" + value + " -o out");
    EXPECT_EQ(outcome.status, 2) << value << outcome.errors;
    EXPECT_NE(outcome.errors.find("--fix mu=" + value), std::string::npos) << outcome.errors;
  }
  for (const std::string campaigns : {"0", "10000", "-1", "1e9"})
    EXPECT_EQ(run("blind generate --campaigns " + campaigns + " -o out").status, 2) << campaigns;
}

}  // namespace
}  // namespace secular
