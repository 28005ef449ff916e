// --band, --from, --to and --records mean the same in every command that reads records.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "tests/app/program_run.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr double rate = 128, omega0 = 2 * std::numbers::pi * 10, damping = 0.8;

constexpr const char* selected_model_text = R"toml(schema = 1
name = "one_mode"
[[mode]]
coordinate = "v"
frequency = "omega0"
equation = "D2(v) + omega0^2*v = -2*mu*D(v) - a3*v^3 + e*F*cos(Omega*t)"
[[case]]
name = "primary"
relations = ["Omega = omega0 + eps*sigma"]
order = { mu = 1, a3 = 1, e = 1 }
expand_to = 1
[[case]]
name = "free"
order = { mu = 1, a3 = 1, e = 1 }
expand_to = 1
excitation = false
[nominal]
omega0 = 62.8
)toml";

// A command, how it is called (CAMPAIGN and OUT are filled in), and which of the options it has.
struct Command {
  std::string name, arguments;
  bool band = true, span = true;
  std::string needs = {};  ///< an option without which there are no records to choose from
};

std::ostream& operator<<(std::ostream& out, const Command& command) {
  return out << command.name;
}

const std::vector<Command> commands = {
    {"identify", "CAMPAIGN --model model.toml --interpret -o OUT"},
    {"diagnose", "CAMPAIGN --model model.toml --interpret -o OUT"},
    {"procedure", "CAMPAIGN --model model.toml --case primary --method anova --interpret -o OUT"},
    {"spectrum", "CAMPAIGN -o OUT"},
    {"modal", "CAMPAIGN -o OUT"},
    {"inspect", "CAMPAIGN", false},
    {"predict",
     "model.toml --case primary --parameters numbers.json --vary Omega 60 66 --at F=1 --measured CAMPAIGN -o OUT",
     true, true, "--measured"},
    {"plan",
     "model.toml --case primary --parameters numbers.json --for mu,e --range-frequency 9.5:10.5 --range-amplitude "
     "0.5:2 "
     "--against CAMPAIGN -o OUT",
     false, false, "--against"}};

RecordEntry entry_of(const std::string& file, RecordKind kind) {
  RecordEntry entry;
  entry.file = file;
  entry.kind = kind;
  return entry;
}

// The linear oscillator's acceleration: a steady dwell, or a decay after it was held still for a second.
Record steady(double hz, double level, double seconds) {
  Record record;
  record.sample_rate_hz = rate;
  record.channels.assign(2, {});
  const double w = 2 * std::numbers::pi * hz;
  const std::complex<double> amplitude =
      -w * w * level / (omega0 * omega0 - w * w + std::complex<double>(0, 2 * damping * w));
  for (int i = 0; i < static_cast<int>(seconds * rate); ++i) {
    const double t = i / rate;
    record.channels[0].push_back(level * std::cos(w * t));
    record.channels[1].push_back((amplitude * std::polar(1.0, w * t)).real() + 1e-3 * std::cos(37.0 * i * i));
  }
  return record;
}

Record decay(double size) {
  Record record;
  record.sample_rate_hz = rate;
  record.channels.assign(2, {});
  const std::complex<double> pole(-damping, std::sqrt(omega0 * omega0 - damping * damping));
  for (int i = 0; i < static_cast<int>(9 * rate); ++i) {
    const double t = i / rate - 1;
    record.channels[0].push_back(0);
    record.channels[1].push_back((t < 0 ? size : size * std::exp(pole * t).real()) + 1e-3 * std::cos(37.0 * i * i));
  }
  return record;
}

struct MadeCampaign {
  Campaign campaign;
  std::vector<Record> samples;

  void add(const std::string& file, RecordKind kind, Record record, double hz = 0) {
    campaign.records.push_back(entry_of(file, kind));
    if (kind == RecordKind::dwell) {
      campaign.records.back().excitation_frequency_hz = hz;
      campaign.records.back().excitation_amplitude = 1.0;
      campaign.records.back().ensemble_s = 2.0;
    }
    samples.push_back(std::move(record));
  }
};

MadeCampaign test_of_one_mode(int dwells) {
  MadeCampaign test;
  test.campaign.name = "one mode";
  test.campaign.sample_rate_hz = rate;
  test.campaign.channels = {{"base", ChannelRole::excitation, Quantity::acceleration, "m/s^2"},
                            {"tip", ChannelRole::response, Quantity::acceleration, "m/s^2"}};
  for (int n = 0; n < dwells; ++n) {
    const double hz = 9.7 + 0.64 * n / dwells;
    test.add("records/dwell_" + std::to_string(n) + ".csv", RecordKind::dwell, steady(hz, 1, 16), hz);
  }
  for (const int n : {0, 1})
    test.add("records/decay_" + std::to_string(n) + ".csv", RecordKind::free_decay, decay(5 + n));
  return test;
}

// What --records and --from, --to choose, by hand.
MadeCampaign cut_by_hand(const MadeCampaign& whole, const std::string& part, double from, double to) {
  MadeCampaign test;
  test.campaign = whole.campaign;
  test.campaign.records.clear();
  for (std::size_t r = 0; r < whole.samples.size(); ++r) {
    if (whole.campaign.records[r].file.find(part) == std::string::npos) continue;
    Record record = whole.samples[r];
    const auto first = static_cast<std::ptrdiff_t>(std::lround((from - record.start_s) * rate)),
               last = static_cast<std::ptrdiff_t>(std::lround((to - record.start_s) * rate)) + 1;
    for (std::vector<double>& channel : record.channels)
      channel.assign(channel.begin() + first, channel.begin() + last);
    record.start_s = from;
    test.campaign.records.push_back(whole.campaign.records[r]);
    test.samples.push_back(std::move(record));
  }
  return test;
}

class RecordSelection : public TemporaryFolder, public testing::WithParamInterface<Command> {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    write("model.toml", selected_model_text);
    write("numbers.json", R"({"omega0": 62.83, "mu": 0.8, "a3": 0, "e": 1})");
    write_campaign(test_.campaign, test_.samples, folder_ / "whole");
  }

  // The command on a campaign; its status.
  int run(const std::string& campaign, const std::string& options) {
    std::string arguments = GetParam().arguments;
    arguments = std::regex_replace(arguments, std::regex("CAMPAIGN"), campaign);
    arguments = std::regex_replace(arguments, std::regex("OUT"), "out");
    fs::remove_all(folder_ / "out");
    outcome_ = testing_support::run_program(folder_, GetParam().name + " " + arguments + " " + options);
    return outcome_.status;
  }

  void refuses(const std::string& options, const std::vector<std::string>& parts) {
    EXPECT_EQ(run("whole", options), 2) << options << outcome_.output;
    for (const std::string& part : parts)
      EXPECT_NE(outcome_.errors.find(part), std::string::npos) << options << "\n" << outcome_.errors;
    EXPECT_EQ(std::count(outcome_.errors.begin(), outcome_.errors.end(), '\n'), 1) << outcome_.errors;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }

  // A diagnosis takes as long as its records: half as many choose as well.
  MadeCampaign test_ = test_of_one_mode(GetParam().name == "diagnose" ? 4 : 8);
  testing_support::Outcome outcome_;
};

TEST_P(RecordSelection, RefusesWhatChoosesNothing) {
  refuses("--records 'records/none*'",
          {"campaign.toml", "no record matches --records records/none*", "its records are records/dwell_0.csv"});
  if (GetParam().span) {
    refuses("--from 3 --to 1", {"--from, --to", "the window is empty", "--from must be before --to"});
    refuses("--from 3 --to 3", {"the window is empty"});
    refuses("--from nan", {"the window is empty"});
    if (GetParam().name != "modal" && GetParam().name != "inspect")
      refuses("--from 100", {"no record has a sample", "records/dwell_0.csv goes from 0 s to 15.9922 s"});
    else
      refuses("--from 100", {"between --from and --to"});
  }
  if (!GetParam().band) return;
  refuses("--band 5", {"--band 5", "is not LOW:HIGH"});
  refuses("--band 12:8", {"--band 12:8", "the band is empty"});
  refuses("--band 8:8", {"the band is empty"});
  refuses("--band 8:twelve", {"is not LOW:HIGH"});
  refuses("--band 8:64", {"--band 8:64", "ends above half the sample rate", "below 64 Hz"});
}

TEST_P(RecordSelection, IsDescribedInTheSameWords) {
  const std::string help = testing_support::run_program(folder_, GetParam().name + " --help").output;
  const std::string words = std::regex_replace(help, std::regex("\\s+"), " ");
  const auto says = [&](const std::string& text) { return words.find(text) != std::string::npos; };
  EXPECT_TRUE(says("use the records whose file matches this shell pattern, with * and ?")) << help;
  EXPECT_EQ(says("use every record from this time of its own on, s"), GetParam().span) << help;
  EXPECT_EQ(says("use every record up to this time of its own, s"), GetParam().span) << help;
  EXPECT_EQ(says("LOW:HIGH in Hz: nothing of a record counts that lies outside of it"), GetParam().band) << help;
}

// A window is what a campaign of those samples alone would be, both ends included: what is outside has no say, in a
// filter neither.
TEST_P(RecordSelection, ChoosesWhatACutByHandLeaves) {
  const std::string part = GetParam().name == "modal" ? "decay_" : "dwell_";
  const bool span = GetParam().span;
  const double to = part == "decay_" ? 8.5 : 14.5;
  const MadeCampaign cut = span ? cut_by_hand(test_, part, 0.5, to) : cut_by_hand(test_, part, 0, 2047 / rate);
  write_campaign(cut.campaign, cut.samples, folder_ / "byhand");
  const auto comparable = [](const std::string& text) {
    return std::regex_replace(text, std::regex("byhand"), "whole");
  };
  for (const std::string band : {"", " --band 4:16"}) {
    if (!band.empty() && !GetParam().band) continue;
    ASSERT_EQ(run("byhand", "--json" + band), 0) << outcome_.errors;
    const std::string expected = outcome_.output;
    ASSERT_EQ(run("whole", "--records 'records/" + part + "*' --json" +
                               (span ? " --from 0.5 --to " + std::to_string(to) : "") + band),
              0)
        << outcome_.errors;
    EXPECT_EQ(comparable(outcome_.output), comparable(expected)) << band;
  }
}

TEST_P(RecordSelection, NeedsACampaignToChooseFrom) {
  if (GetParam().needs.empty()) return;
  const std::string arguments =
      std::regex_replace(std::regex_replace(GetParam().arguments, std::regex("OUT"), "out"),
                         std::regex(GetParam().needs + " CAMPAIGN"), "");
  const auto outcome =
      testing_support::run_program(folder_, GetParam().name + " " + arguments + " --records 'records/*'");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.errors.find(GetParam().needs), std::string::npos) << outcome.errors;
}

INSTANTIATE_TEST_SUITE_P(Commands, RecordSelection, testing::ValuesIn(commands),
                         [](const auto& command) { return command.param.name; });

// A file is one record.
TEST(RecordsOfAFile, CannotBeChosen) {
  const fs::path folder = testing_support::process_folder() / "records_of_a_file";
  fs::create_directories(folder);
  std::ofstream csv(folder / "a.csv");
  csv << "t,a\n";
  for (int i = 0; i < 200; ++i) csv << i / 100.0 << ',' << std::cos(0.3 * i) << '\n';
  csv.close();
  for (const std::string command : {"inspect a.csv", "spectrum a.csv -o out"}) {
    const auto refused = testing_support::run_program(folder, command + " --records 'a*'");
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.errors.find("a.csv is a single record"), std::string::npos) << refused.errors;
    EXPECT_EQ(testing_support::run_program(folder, command + " --from 0.5 --to 1.5").status, 0);
    EXPECT_EQ(testing_support::run_program(folder, command + " --from 5").status, 2);
  }
  fs::remove_all(folder);
}

// A tone beside the band is taken away and one in it stays as it is, in dwells and in decays.
class BandOfIdentify : public RecordSelection {};

TEST_P(BandOfIdentify, TakesAwayWhatIsOutside) {
  MadeCampaign foreign = test_;
  for (Record& record : foreign.samples)
    for (std::size_t i = 0; i < record.samples(); ++i)
      record.channels[1][i] += 3 * std::cos(2 * std::numbers::pi * 31 * static_cast<double>(i) / rate + 0.4);
  write_campaign(foreign.campaign, foreign.samples, folder_ / "foreign");
  const auto value = [&](const char* name) {
    const nlohmann::json json = nlohmann::json::parse(outcome_.output);
    for (const nlohmann::json& estimate : json["estimates"])
      if (estimate["name"] == name) return estimate;
    return nlohmann::json();
  };
  for (const char* const records : {"'*dwell*'", "'*decay*'"}) {
    ASSERT_EQ(run("foreign", "--fix a3=0 --band 4:16 --json --records " + std::string(records)), 0)
        << outcome_.errors;
    const nlohmann::json mu = value("mu"), frequency = value("omega0");
    EXPECT_NEAR(mu["value"].get<double>(), damping, 5e-3) << records << mu;
    EXPECT_NEAR(frequency["value"].get<double>(), omega0, 5e-3) << records << frequency;
  }
  // The excitation is a dwell's measure: without it there is none.
  EXPECT_NE(run("foreign", "--band 12:20 --records '*dwell*'"), 0);
  EXPECT_NE(outcome_.errors.find("outside of the band"), std::string::npos) << outcome_.errors;
}

INSTANTIATE_TEST_SUITE_P(Identify, BandOfIdentify, testing::Values(commands.front()));

}  // namespace
}  // namespace secular
