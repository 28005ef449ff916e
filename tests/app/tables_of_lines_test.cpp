// A stepped-sine test that is a table of lines says what the samples of the same dwells say.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "measure/data/campaign.hpp"
#include "tests/app/program_run.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using Complex = std::complex<double>;

// mu, e and a3 in SI units; `effect`: of the structure, which the model lacks.
std::string experiment(const std::string& effect = "") {
  return "schema = 1\nname = \"duff\"\nmodel = \"duffing\"\nsample_rate_hz = 256.0\n[parameters]\n"
         "omega0 = 125.66370614359172\nmu = 1.0\na2 = 0.0\na3 = 2.5e8\ne = 1.0\n"
         "[excitation]\nname = \"base\"\nquantity = \"acceleration\"\nunit = \"m/s^2\"\nnoise_sd = 0.01\n"
         "[[response]]\nname = \"tip\"\nquantity = \"acceleration\"\nunit = \"m/s^2\"\nnoise_sd = 0.02\n"
         "[[dwell]]\nfrequencies_hz = [19.7, 19.85, 20.0, 20.1, 20.2, 20.35]\namplitudes = [0.1, 0.2, 0.4]\n"
         "ensembles = 4\nensemble_s = 2.0\nsettle_s = 12.0\n" +
         effect;
}

// A line of a table: half a turn of sums over samples would do; the least squares says its noise, too.
struct Row {
  double frequency = 0;
  std::array<Complex, 2> base;  // at Omega and at 2 Omega
  std::array<Complex, 2> tip;
  double base_sd = 0, tip_sd = 0;
};

std::vector<Row> rows_of(const fs::path& folder) {
  std::vector<Row> rows;
  const Campaign campaign = read_campaign(folder);
  for (const RecordEntry& entry : campaign.records) {
    const Record record = read_record(campaign, entry);
    const auto n = static_cast<Eigen::Index>(record.samples());
    const double w = 2 * std::numbers::pi * *entry.excitation_frequency_hz;
    Eigen::MatrixXd columns(n, 7);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double t = (static_cast<double>(i) - 0.5 * static_cast<double>(n - 1)) / record.sample_rate_hz;
      columns(i, 0) = 1;
      for (int h = 1; h <= 3; ++h) {
        columns(i, 2 * h - 1) = std::cos(h * w * t);
        columns(i, 2 * h) = -std::sin(h * w * t);
      }
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
    Row row{*entry.excitation_frequency_hz, {}, {}, 0, 0};
    for (const std::size_t c : {0u, 1u}) {
      const Eigen::Map<const Eigen::VectorXd> y(record.channels[c].data(), n);
      const Eigen::VectorXd fit = qr.solve(y);
      const double left = (y - columns * fit).squaredNorm() / static_cast<double>(n - 7);
      auto& lines = c == 0 ? row.base : row.tip;
      for (const int h : {1, 2}) lines[static_cast<std::size_t>(h - 1)] = {fit(2 * h - 1), fit(2 * h)};
      (c == 0 ? row.base_sd : row.tip_sd) = std::sqrt(2 * left / static_cast<double>(n));
    }
    rows.push_back(row);
  }
  return rows;
}

std::string number(double value) {
  return nlohmann::json(value).dump();
}

// Phases against the excitation, in degrees.
std::string table_of(const std::vector<Row>& rows, bool with_sd) {
  std::string text = "f,base,tip,tip.phase (deg),tip@2,tip@2.phase (deg)";
  text += with_sd ? ",base.sd,tip.sd\n" : "\n";
  for (const Row& row : rows) {
    const Complex turn = std::abs(row.base[0]) / row.base[0];
    const Complex first = row.tip[0] * turn, second = row.tip[1] * turn * turn;
    const double degrees = 180 / std::numbers::pi;
    text += number(row.frequency) + "," + number(std::abs(row.base[0])) + "," + number(std::abs(first)) + "," +
            number(degrees * std::arg(first)) + "," + number(std::abs(second)) + "," +
            number(degrees * std::arg(second));
    text += with_sd ? "," + number(row.base_sd) + "," + number(row.tip_sd) + "\n" : "\n";
  }
  return text;
}

class SlowTablesOfLines : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  testing_support::Outcome run(const std::string& arguments) const {
    return testing_support::run_with_shared_cache(folder_, arguments);
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::vector<Row> simulated(const std::string& effect = "") const {
    write("test.toml", experiment(effect));
    EXPECT_EQ(run("simulate test.toml -o samples --seed 3").status, 0);
    return rows_of(folder_ / "samples");
  }
  void import_table(const std::string& name, const std::string& text,
                    const std::string& channels =
                        " --channel base:excitation:acceleration:m/s^2 --channel "
                        "tip:response:acceleration:m/s^2") const {
    write(name + ".csv", text);
    const auto imported = run("import " + name + ".csv -o " + name + " --kind lines" + channels);
    ASSERT_EQ(imported.status, 0) << imported.errors;
  }
  nlohmann::json identified(const std::string& campaign) const {
    const auto outcome = run("identify " + campaign + " --model duffing --case primary -o of_" + campaign);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return nlohmann::json::parse(testing_support::text_of(folder_ / ("of_" + campaign) / "estimate.json"));
  }
  static std::map<std::string, std::pair<double, double>> numbers(const nlohmann::json& estimate) {
    std::map<std::string, std::pair<double, double>> all;
    for (const auto& e : estimate.at("estimates"))
      if (e.at("value").is_number()) all[e.at("name")] = {e.at("value"), e.at("sd")};
    return all;
  }

  fs::path folder_ = testing_support::process_folder() / "tables_of_lines";
};

TEST_F(SlowTablesOfLines, SayWhatTheirSamplesSay) {
  const std::vector<Row> rows = simulated();
  import_table("with_sd", table_of(rows, true));
  import_table("without_sd", table_of(rows, false));
  const auto samples = numbers(identified("samples"));
  for (const std::string name : {"with_sd", "without_sd"}) {
    const auto table = numbers(identified(name));
    for (const std::string symbol : {"omega0", "mu", "a3", "e"})
      EXPECT_LT(std::abs(table.at(symbol).first - samples.at(symbol).first),
                3 * std::hypot(table.at(symbol).second, samples.at(symbol).second))
          << name << " " << symbol;
  }
}

TEST_F(SlowTablesOfLines, SayTheSameInAnotherOrderUnitAndName) {
  std::vector<Row> rows = simulated();
  import_table("table", table_of(rows, false));
  std::rotate(rows.begin(), rows.begin() + 7, rows.end());
  std::swap(rows[2], rows[11]);
  for (Row& row : rows)
    for (Complex& line : row.tip) line *= 1e3;
  import_table(
      "other", table_of(rows, false),
      " --channel drive=base:excitation:acceleration:m/s^2 --channel end=tip:response:acceleration:mm/s^2");
  const auto first = numbers(identified("table")), second = numbers(identified("other"));
  for (const auto& [name, value] : first) {
    EXPECT_NEAR(second.at(name).first, value.first, 0.02 * value.second) << name;
    EXPECT_NEAR(second.at(name).second, value.second, 0.02 * value.second) << name;
  }
}

TEST_F(SlowTablesOfLines, SayWhereTheirNoiseComesFrom) {
  import_table("table", table_of(simulated(), false));
  const nlohmann::json estimate = identified("table");
  const nlohmann::json& noise = estimate.at("unstated_noise");
  ASSERT_EQ(noise.size(), 1u);
  EXPECT_EQ(noise[0].at("mode"), "x");
  EXPECT_EQ(noise[0].at("rows"), 18);
  EXPECT_GT(noise[0].at("degrees_of_freedom"), 20);
  // What it cannot be compared with is said.
  const auto diagnosed = run("diagnose table --model duffing -o d");
  EXPECT_EQ(diagnosed.status, 2);
  EXPECT_NE(diagnosed.errors.find("no standard deviations"), std::string::npos) << diagnosed.errors;
  EXPECT_EQ(run("spectrum table -o s").status, 2);
  EXPECT_EQ(run("modal table -o m").status, 2);
  EXPECT_EQ(run("inspect table").status, 0);
}

// A CSV of a controller, with remarks, decimal commas and units in the names: the command that `inspect` prints is
// typed as it stands, but for the campaign's name.
TEST(TablesOfLines, AreImportedByTheCommandThatInspectPrints) {
  const fs::path folder = testing_support::process_folder() / "table_as_proposed";
  fs::create_directories(folder);
  std::ofstream(folder / "stepped.csv") << "Stepped sine, 14.3.2024\n"
                                           "Frequency [Hz];Base acc [g];Tip disp [mm];Phase [deg]\n"
                                           "17,5;0,02;0,31;-12,5\n18;0,02;0,9;-40\n18,5;0,02;0,42;-150\n";
  const testing_support::Outcome seen = testing_support::run_program(folder, "inspect stepped.csv");
  const std::size_t begin = seen.output.find("secular import "), end = seen.output.find('\n', begin);
  ASSERT_NE(begin, std::string::npos) << seen.output;
  std::string command = seen.output.substr(begin + 8, end - begin - 8);
  command.replace(command.find("CAMPAIGN"), 8, "typed");
  const testing_support::Outcome made = testing_support::run_program(folder, command);
  ASSERT_EQ(made.status, 0) << command << '\n' << made.errors;
  const Campaign campaign = read_campaign(folder / "typed");
  ASSERT_EQ(campaign.records.size(), 3u);
  EXPECT_EQ(campaign.channels[0].role, ChannelRole::excitation);
  ASSERT_TRUE(campaign.records[1].row);
  const TableLine& tip = campaign.records[1].row->lines.back();
  EXPECT_NEAR(std::abs(tip.amplitude), 0.9e-3, 1e-12);
  EXPECT_NEAR(std::arg(tip.amplitude), -40 * std::numbers::pi / 180, 1e-9);
  fs::remove_all(folder);
}

// Where names are of another language, the unit says which column holds the frequencies; a level that stays the
// same is no dead channel. With --dry-run nothing is written.
TEST(TablesOfLines, AreProposedByTheUnitOfTheirFrequencies) {
  const fs::path folder = testing_support::process_folder() / "table_by_unit";
  fs::create_directories(folder);
  std::ofstream(folder / "stufen.csv") << "VibControl 4.2;;;\nDatum:;14.05.2024;;\n\n"
                                          "Frequenz;Anregung;Spitze;Phase\nHz;m/s^2;mm;deg\n"
                                          "17,5;0,02;0,31;-12,5\n18;0,02;0,9;-40\n18,5;0,02;0,42;-150\n";
  const testing_support::Outcome seen = testing_support::run_program(folder, "inspect stufen.csv");
  EXPECT_NE(seen.output.find("To use it as a table of lines: secular import stufen.csv -o CAMPAIGN --kind lines "
                             "--column 'f=Frequenz' --channel Anregung:excitation --channel Spitze:response "
                             "--column Spitze.phase=Phase"),
            std::string::npos)
      << seen.output;
  EXPECT_EQ(seen.output.find("dead channel"), std::string::npos) << seen.output;
  const std::size_t begin = seen.output.find("import "), end = seen.output.find('\n', begin);
  std::string command = seen.output.substr(begin, end - begin);
  command.replace(command.find("CAMPAIGN"), 8, "typed");
  const testing_support::Outcome told = testing_support::run_program(folder, command + " --dry-run");
  EXPECT_EQ(told.status, 0) << told.errors;
  EXPECT_NE(told.output.find("would make typed: 2 channels, 1 table of lines"), std::string::npos) << told.output;
  EXPECT_NE(told.output.find("channel Spitze: response, displacement in m"), std::string::npos) << told.output;
  EXPECT_FALSE(fs::exists(folder / "typed"));
  ASSERT_EQ(testing_support::run_program(folder, command).status, 0);
  EXPECT_EQ(read_campaign(folder / "typed").records.size(), 3U);
  fs::remove_all(folder);
}

TEST_F(SlowTablesOfLines, AreDiagnosed) {
  import_table("right", table_of(simulated(), true));
  ASSERT_EQ(run("diagnose right --model duffing -o d").status, 0);
  EXPECT_EQ(nlohmann::json::parse(testing_support::text_of(folder_ / "d" / "diagnosis.json")).at("verdict"),
            "no_gap");
  fs::remove_all(folder_ / "samples");
  import_table("dragging",
               table_of(simulated("[[effect]]\nname = \"quadratic_damping\"\nstrength = 200.0\n"), true));
  ASSERT_EQ(run("diagnose dragging --model duffing -o dragged").status, 0);
  const auto json = nlohmann::json::parse(testing_support::text_of(folder_ / "dragged" / "diagnosis.json"));
  EXPECT_TRUE(json.at("gap").at("detected"));
  EXPECT_EQ(json.at("causes").at(0).at("effect"), "quadratic_damping");
}

}  // namespace
}  // namespace secular
