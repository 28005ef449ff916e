#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "measure/data/inspection.hpp"
#include "measure/data/watched_reader.hpp"
#include "measure/formats/unit.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/mat_writer.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

class Import : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    options_.files = {write("run.csv", "t,base,tip\n0,1,2\n0.01,3,4\n0.02,5,6\n")};
    options_.kind = "sweep";
    options_.channels = {"base:excitation:acceleration:m/s^2", "tip:response:acceleration:m/s^2"};
  }
  std::string complaint() const {
    return refusal([&] { import_files(options_); });
  }
  ImportOptions options_;
};

TEST_F(Import, MakesACampaignThatReadsBack) {
  options_.files.push_back(write("b/run.csv", "t;tip;base\n1;-2,5;7\n1,01;4;5\n"));
  options_.files.push_back(write("run 2.5.csv", "t,base,tip\n0,1,2\n0.01,3,4\n"));
  options_.frequencies_hz = {20, 21, 22};
  options_.amplitudes = {0.5};
  options_.group = "up";
  options_.ensemble_s = 0.02;
  const ImportedFiles imported = import_files(options_);
  write_campaign(imported.campaign, imported.samples, folder_ / "c");
  const Campaign campaign = read_campaign(folder_ / "c");
  EXPECT_EQ(campaign.name, "run");
  EXPECT_EQ(campaign.sample_rate_hz, 100);
  ASSERT_EQ(campaign.records.size(), 3u);
  EXPECT_EQ(campaign.records[0].file, "records/run.csv");
  EXPECT_EQ(campaign.records[1].file, "records/run-2.csv");
  EXPECT_EQ(campaign.records[2].file, "records/run_2.5.csv");
  EXPECT_EQ(campaign.records[1].excitation_frequency_hz, 21);
  EXPECT_EQ(campaign.records[2].excitation_amplitude, 0.5);
  EXPECT_EQ(campaign.records[2].group, "up");
  const Record second = read_record(campaign, campaign.records[1]);
  EXPECT_EQ(second.start_s, 1);
  EXPECT_EQ(second.channels, (std::vector<std::vector<double>>{{7, 5}, {-2.5, 4}}));
}

TEST_F(Import, FilesWithoutTimeTakeTheSampleRate) {
  options_.files = {write("a.csv", "\"V1\",\"V2\",\n0.5,0.25,\n1,2,\n")};
  options_.channels = {"V1:excitation:voltage:V", "V2:response:voltage:V"};
  EXPECT_TRUE(contains(complaint(), "--time"));
  EXPECT_TRUE(contains(complaint(), "--sample-rate"));
  EXPECT_TRUE(contains(complaint(), "V1, V2"));
  options_.sample_rate_hz = 610.35;
  const ImportedFiles imported = import_files(options_);
  EXPECT_EQ(imported.campaign.sample_rate_hz, 610.35);
  EXPECT_EQ(imported.samples[0].channels, (std::vector<std::vector<double>>{{0.5, 1}, {0.25, 2}}));
}

// A rate in place of the file's own time is what was asked for, and said.
TEST_F(Import, ATimeThatTheSampleRateStandsForIsSaidToBeUnused) {
  const std::size_t before = import_files(options_).campaign.records.size();
  options_.sample_rate_hz = 200;
  const ImportedFiles imported = import_files(options_);
  EXPECT_EQ(imported.campaign.sample_rate_hz, 200);
  EXPECT_EQ(imported.campaign.records.size(), before);
  ASSERT_EQ(imported.warnings.size(), 1U);
  EXPECT_TRUE(contains(imported.warnings[0], "t is called a time and is not used, since --sample-rate"));
}

TEST_F(Import, AFrameIsKeptAndBelongsToAChannel) {
  options_.absolute = {"tip"};
  for (const Channel& channel : import_files(options_).campaign.channels)
    EXPECT_EQ(channel.frame == Frame::absolute, channel.name == "tip");
  options_.absolute = {"top"};
  EXPECT_TRUE(contains(complaint(), "top, frame: belongs to no channel"));
}

TEST_F(Import, ADelayIsKeptAndBelongsToAChannel) {
  options_.delays = {"tip=0.002"};
  for (const Channel& channel : import_files(options_).campaign.channels)
    EXPECT_EQ(channel.delay_s, channel.name == "tip" ? 0.002 : 0.0);
  options_.delays = {"top=0.002"};
  EXPECT_TRUE(contains(complaint(), "--delay top=0.002: names no channel that is imported"));
  for (const char* wrong : {"tip=2ms", "tip=", "tip=inf"}) {
    options_.delays = {wrong};
    EXPECT_TRUE(contains(complaint(), "has no number of seconds")) << wrong;
  }
}

TEST_F(Import, AsksForWhatFilesCannotSayByTheOptionsName) {
  const ImportOptions good = options_;
  options_.kind = "";
  EXPECT_TRUE(contains(complaint(), "--kind"));
  EXPECT_TRUE(contains(complaint(), "free_decay"));
  options_.kind = "swept";
  EXPECT_TRUE(contains(complaint(), "--kind swept"));
  options_ = good;
  options_.channels.clear();
  EXPECT_TRUE(contains(complaint(), "t, base, tip"));
  EXPECT_TRUE(contains(complaint(), "--channel NAME:ROLE:QUANTITY:UNIT"));
  options_ = good;
  options_.time = "clock";
  EXPECT_TRUE(contains(complaint(), "--time clock"));
  options_ = good;
  options_.sample_rate_hz = 0;
  EXPECT_TRUE(contains(complaint(), "--sample-rate"));
  options_ = good;
  options_.time = "t";
  options_.sample_rate_hz = 200;
  EXPECT_TRUE(contains(complaint(), "sampled at 100 Hz; --sample-rate says 200"));
  options_ = good;
  options_.frequencies_hz = {1, 2};
  EXPECT_TRUE(contains(complaint(), "--frequency: has 2 values for 1 records"));
  options_.frequencies_hz = {50};
  EXPECT_TRUE(contains(complaint(), "half the sample rate"));
  options_ = good;
  options_.amplitudes = {-1};
  EXPECT_TRUE(contains(complaint(), "--amplitude"));
  options_ = good;
  options_.files.push_back(write("fast.csv", "t,base,tip\n0,1,2\n0.001,3,4\n"));
  EXPECT_TRUE(contains(complaint(), "fast.csv"));
}

TEST_F(Import, TheOneVariableThatIsCalledTimeNeedsNoOption) {
  ImportOptions options;
  options.kind = "free_decay";
  options.channels = {"tip=b:response:angle:rad"};
  options.files = {write("one.csv", "Time (ms),b\n0,1\n2,2\n4,3\n")};
  EXPECT_EQ(import_files(options).campaign.sample_rate_hz, 500);
  options.files = {write("two.csv", "Time (ms),Time (s),b\n0,0,1\n2,0.002,2\n4,0.004,3\n")};
  EXPECT_TRUE(contains(refusal([&] { import_files(options); }), "--time"));
}

TEST_F(Import, ChannelDescriptionsAreChecked) {
  const struct {
    const char *text, *part;
  } cases[] = {
      {"tip:response:m", "--channel tip:response:m: has 3 of four fields"},
      {"top:response:acceleration:m/s^2", "has no variable 'top'; its variables are t, base, tip"},
      {"tip:output:acceleration:m/s^2", "role: is 'output'; excitation or response"},
      {"tip:response:accel:m/s^2", "quantity: is 'accel'"},
      {"tip:response:acceleration:mm", "unit 'mm' measures displacement"},
      {"tip:response:acceleration:parsec", "--channel NAME:ROLE:QUANTITY:UNIT:FACTOR"},
      {"tip:response:acceleration:g:0", "factor: is '0'; a number other than zero"},
      {"tip:response:acceleration:counts", "measures a converter's steps"},
      {"t=tip:response:acceleration:m/s^2", "names time"},
      {"base:excitation:acceleration:m/s^2", "described twice"},
  };
  for (const auto& test : cases) {
    options_.channels = {"base:response:acceleration:m/s^2", test.text};
    EXPECT_TRUE(contains(complaint(), test.part));
  }
  options_.channels = {"base:excitation:acceleration:m/s^2"};
  EXPECT_TRUE(contains(complaint(), "no channel is a response"));
}

TEST_F(Import, ASecondTimeIsNotPassedOver) {
  const auto warnings_of = [&](double later, double step) {
    std::string text = "t_f,f,t_tip,tip,frame\n";
    for (int i = 0; i < 40; ++i)
      text += std::to_string(0.01 * i) + "," + std::to_string(i % 7) + "," + std::to_string(later + step * i) +
              "," + std::to_string(i % 5) + "," + std::to_string(i) + "\n";
    options_.files = {write("two.csv", text)};
    options_.channels = {"f:excitation:force:N", "tip:response:acceleration:m/s^2"};
    options_.time = "t_f";
    std::string all;
    for (const std::string& warning : import_files(options_).warnings) all += warning + "\n";
    return all;
  };
  EXPECT_TRUE(contains(warnings_of(0.005, 0.01), "t_tip is a time, too, from 0.005 s on at 100 Hz"));
  EXPECT_TRUE(contains(warnings_of(0, 0.02), "t_tip is a time, too, from 0 s on at 50 Hz"));
  EXPECT_EQ(warnings_of(0, 0.01), "");
}

TEST_F(Import, StructFieldsOfMatFilesCanBeRenamed) {
  {
    MatWriter writer(folder_ / "a.mat");
    writer.add(MatWriter::structure("run", 1, {"time", "x", "y"},
                                    {MatWriter::column("", {0, 0.5, 1}),
                                     MatWriter::array<std::int16_t>("", MAT_C_INT16, MAT_T_INT16, 1, 3, {1, 2, 3}),
                                     MatWriter::row("", {4, 5, 6})}));
  }
  options_.files = {folder_ / "a.mat"};
  options_.channels = {"tip=run.x:response:angle:rad"};
  options_.time = "run.time";
  const ImportedFiles imported = import_files(options_);
  EXPECT_EQ(imported.campaign.channels.front().name, "tip");
  EXPECT_EQ(imported.campaign.sample_rate_hz, 2);
  EXPECT_EQ(imported.samples.front().channels, (std::vector<std::vector<double>>{{1, 2, 3}}));
  EXPECT_EQ(imported.left_out, std::vector<std::string>{"run.y"});
}

TEST_F(Import, ThePendulumKeepsEverySample) {
  const fs::path path = testing_support::source_folder() / "../shared/data/pendulum/cdip_pend_data.mat";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not there";
  ImportOptions options;
  options.files = {path};
  options.kind = "free_decay";
  options.channels = {"theta:response:angle:rad"};
  options.time = "t";
  const ImportedFiles imported = import_files(options);
  write_campaign(imported.campaign, imported.samples, folder_ / "c");
  const Campaign campaign = read_campaign(folder_ / "c");
  EXPECT_EQ(campaign.sample_rate_hz, 1000);
  EXPECT_EQ(read_record(campaign, campaign.records.front()).channels, imported.samples.front().channels);
  const std::vector<RecordInspection> inspected = inspect_records(campaign);
  EXPECT_TRUE(inspected.front().faults.empty());
  EXPECT_TRUE(inspected.front().channels.front().faults.empty());
}

class Inspection : public TemporaryFolder {};

TEST_F(Inspection, BrokenRecordsAreFaultsNotFailures) {
  write("c/campaign.toml",
        "schema = 1\nname = \"x\"\nsample_rate_hz = 10.0\n[[channel]]\nname = \"a\"\nrole = \"response\"\n"
        "quantity = \"angle\"\nunit = \"rad\"\n[[record]]\nfile = \"1.csv\"\nkind = \"impact\"\n[[record]]\n"
        "file = \"2.csv\"\nkind = \"impact\"\n[[record]]\nfile = \"3.csv\"\nkind = \"impact\"\n");
  write("c/1.csv", "t,a\n0,1\n0.1,nan\n0.2,3\n0.3,4\n");
  write("c/2.csv", "t,a\n0,1\n0.1,2\n0.2,3\n0.5,4\n");
  write("c/3.csv", "t,b\n0,1\n");
  const std::vector<RecordInspection> records = inspect_records(read_campaign(folder_ / "c"));
  ASSERT_EQ(records.size(), 3u);
  EXPECT_TRUE(records[0].faults.empty());
  EXPECT_EQ(records[0].channels.at(0).faults.at(0).kind, "missing");
  EXPECT_EQ(records[1].faults.at(0).kind, "time");
  EXPECT_TRUE(contains(records[1].faults.at(0).text, "line 5"));
  EXPECT_EQ(records[1].channels.size(), 1u);
  EXPECT_EQ(records[2].faults.at(0).kind, "unreadable");
  EXPECT_TRUE(contains(records[2].faults.at(0).text, "'a'"));
}

TEST_F(Inspection, AFileShowsItsVariables) {
  const FileInspection file = inspect_file(write("a.csv", "Time,a,note\n5,1,x\n5.5,2,y\n6,4,z\n"));
  EXPECT_EQ(file.format, "CSV");
  EXPECT_EQ(file.time, "Time");
  ASSERT_TRUE(file.axis);
  EXPECT_EQ(file.axis->sample_rate_hz, 2);
  ASSERT_EQ(file.variables.size(), 3u);
  EXPECT_EQ(file.variables[1].quality->maximum, 4);
  EXPECT_EQ(file.variables[2].type, "text");
  EXPECT_FALSE(file.variables[2].quality);
}

TEST_F(Import, TimeIsReadInTheUnitThatTheFileStates) {
  const struct {
    const char *name, *row, *time, *unit;
    double seconds;
  } cases[] = {{"Time (ms)", "", "Time (ms)", "ms", 1e-3},
               {"Time [us]", "", "Time [us]", "us", 1e-6},
               {"t_ms", "", "t_ms", "ms", 1e-3},
               {"time_min", "", "time_min", "min", 60},
               {"Time", "ms,V,V\n", "Time", "ms", 1e-3},
               {"Time", "[s],[V],\n", "Time", "s", 1},
               {"stamp", "", "stamp:h", "h", 3600},
               {"t", "", "t:us", "us", 1e-6},
               {"Time (ms)", "", "Time (ms):s", "s", 1},
               {"t_ref", "", "t_ref", "", 1},
               {"Zeit/ms", "", "Zeit/ms", "ms", 1e-3},
               {"TimeMs", "", "TimeMs", "Ms", 1e-3},
               {"time:us", "", "time:us", "us", 1e-6},
               {"Minutes", "", "Minutes", "Minutes", 60},
               {"time.ms", "", "time.ms", "ms", 1e-3},
               {"Time {ms}", "", "Time {ms}", "ms", 1e-3},
               {"Millis", "", "Millis", "Millis", 1e-3},
               {"TIME (MIN)", "", "TIME (MIN)", "MIN", 60},
               {"t", "", "t:d", "d", 86400},
               {"Trigger", "", "Trigger", "", 1}};
  for (const auto& test : cases) {
    options_.files = {
        write("run.csv", std::string(test.name) + ",base,tip\n" + test.row + "0,1,2\n2.5,3,4\n5,5,6\n")};
    options_.time = test.time;
    options_.channels = {"base:excitation:voltage:V", "tip:response:voltage:V"};
    const ImportedFiles imported = import_files(options_);
    EXPECT_DOUBLE_EQ(imported.campaign.sample_rate_hz, 0.4 / test.seconds) << test.name << " " << test.row;
    EXPECT_EQ(imported.samples[0].channels[1], (std::vector<double>{2, 4, 6}));
    if (test.seconds == 1) continue;
    ASSERT_EQ(imported.converted.size(), 1u);
    EXPECT_EQ(imported.converted[0].from_unit, test.unit);
  }
  options_.files = {write("run.csv", "Time (fortnights),base,tip\n0,1,2\n2.5,3,4\n5,5,6\n")};
  options_.time = "Time (fortnights)";
  EXPECT_TRUE(contains(complaint(), "--time NAME:UNIT"));
}

// Numbers without a unit that cannot be seconds.
TEST_F(Import, ATimeThatIsNoneIsAskedFor) {
  const auto take = [&](const std::string& name, const std::vector<std::string>& stamps) {
    std::string text = name + ",base,tip\n";
    for (const std::string& stamp : stamps) text += stamp + ",1,2\n";
    options_.files = {write("run.csv", text)};
    options_.time = name;
  };
  for (const char* const name : {"sample", "Index", "Sample"}) {
    take(name, {"0", "1", "2", "3"});
    EXPECT_TRUE(contains(complaint(), "counts samples, by its name")) << name;
  }
  take("t", {"1700000000000", "1700000000001", "1700000000002"});
  EXPECT_TRUE(contains(complaint(), "cannot be seconds"));
  take("t", {"739000.5", "739000.50000001", "739000.50000002"});
  EXPECT_TRUE(contains(complaint(), "as days do"));
  take("t", {"45413.5", "45413.50000001", "45413.50000002"});
  EXPECT_TRUE(contains(complaint(), "as days do"));
  take("t", {"1700000000.0", "1700000000.1", "1700000000.2"});
  EXPECT_NEAR(import_files(options_).campaign.sample_rate_hz, 10, 1e-4);
}

TEST_F(Import, KnownUnitsConvertInEveryFormat) {
  const struct {
    const char *header, *channel;
    Quantity quantity;
    double factor;
  } cases[] = {{"t,base,tip", "tip:response:acceleration:g", Quantity::acceleration, 9.80665},
               {"t,base,tip", "tip:response:displacement:in", Quantity::displacement, 0.0254},
               {"t,base,tip", "tip:response:strain:1", Quantity::strain, 1},
               {"t,base,tip", "tip:response:strain:1:1e-6", Quantity::strain, 1e-6},
               {"t,base,tip", "tip:response:displacement:mm:0.5", Quantity::displacement, 0.0005},
               {"t,base,tip (g)", "tip=tip (g):response", Quantity::acceleration, 9.80665},
               {"t,base,tip [mm]", "tip=tip [mm]:response:displacement:mm", Quantity::displacement, 0.001},
               {"t,base,tip (counts)", "tip=tip (counts):response:voltage:mV:0.25", Quantity::voltage, 0.00025},
               {"t,base,Weg/mm", "tip=Weg/mm:response", Quantity::displacement, 0.001},
               {"t,base,tip (V)", "tip=tip (V):response:acceleration:g:2", Quantity::acceleration, 2 * 9.80665},
               {"t,base,tip (mV)", "tip=tip (mV):response:force:N:0.5", Quantity::force, 0.5},
               {"t,base,tip\ns,m/s2,deg", "tip:response", Quantity::angle, std::numbers::pi / 180}};
  options_.channels = {"tip:response"};
  for (const auto& test : cases) {
    options_.files = {write("run.csv", std::string(test.header) + "\n0,1,2\n2.5,3,4\n5,5,6\n")};
    options_.channels = {test.channel};
    const ImportedFiles imported = import_files(options_);
    EXPECT_EQ(imported.campaign.channels[0].quantity, test.quantity) << test.channel;
    EXPECT_EQ(imported.campaign.channels[0].unit, si_unit(test.quantity));
    EXPECT_DOUBLE_EQ(imported.samples[0].channels[0][1], 4 * test.factor) << test.channel;
    EXPECT_EQ(imported.converted.size(), test.factor == 1 ? 0u : 1u) << test.channel;
  }
  options_.files = {write("run.csv", "t,base,tip (counts)\n0,1,2\n2.5,3,4\n5,5,6\n")};
  options_.channels = {"tip=tip (counts):response:voltage:mV"};
  EXPECT_TRUE(contains(complaint(), "QUANTITY:UNIT:FACTOR"));
  options_.files = {write("run.csv", "t,base,tip (V)\n0,1,2\n2.5,3,4\n5,5,6\n")};
  options_.channels = {"tip=tip (V):response:acceleration:g"};
  EXPECT_TRUE(contains(complaint(), "states the unit 'V' itself"));
  const fs::path mat = folder_ / "a.mat";
  {
    MatWriter writer(mat);
    writer.add(MatWriter::column("t_ms", {0, 2, 4}));
    writer.add(MatWriter::column("x", {1, 2, 3}));
  }
  options_.files = {mat};
  options_.time = "t_ms";
  options_.channels = {"x:response:displacement:um"};
  const ImportedFiles imported = import_files(options_);
  EXPECT_EQ(imported.campaign.sample_rate_hz, 500);
  EXPECT_DOUBLE_EQ(imported.samples[0].channels[0][2], 3e-6);
}

TEST_F(Import, FilesOfTheFaultsStateUnitAndScale) {
  const fs::path faults = testing_support::source_folder() / "../shared/faults";
  if (!fs::exists(faults)) GTEST_SKIP() << "../shared/faults is not there";
  options_.files = {faults / "time_in_ms/d14_time_ms.csv"};
  options_.time = "Time (ms)";
  options_.channels = {"tip:response:acceleration:m/s^2"};
  EXPECT_EQ(import_files(options_).campaign.sample_rate_hz, 512);
  EXPECT_TRUE(import_files(options_).warnings.empty());
  options_.files = {faults / "scale_factor_ignored/d22c_int16_scale.h5"};
  options_.time = "t";
  options_.channels = {"tip:response"};
  EXPECT_NEAR(import_files(options_).samples[0].channels[0][0], 4.7774, 1e-3);
  options_.files = {faults / "units_g_counts_wav/d20b_g.csv"};
  options_.channels = {"tip:response:acceleration:g"};
  EXPECT_NEAR(import_files(options_).samples[0].channels[0][0], 4.7774, 1e-3);
}

TEST_F(Import, StructsWithTimesOfTheirOwnAreAligned) {
  const auto made = [&](std::vector<double> second_time) {
    const fs::path mat = folder_ / "a.mat";
    MatWriter writer(mat);
    writer.add(MatWriter::structure("a", 1, {"t", "x"},
                                    {MatWriter::row("", {0, 1, 2, 3}), MatWriter::row("", {5, 6, 7, 8})}));
    writer.add(MatWriter::structure("b", 1, {"time_ms", "x"},
                                    {MatWriter::row("", second_time), MatWriter::row("", {5, 6, 7, 8})}));
    return mat;
  };
  options_.time = "a.t";
  options_.channels = {"x=a.x:response:voltage:V", "y=b.x:response:voltage:V"};
  options_.files = {made({1000, 2000, 3000, 4000})};
  EXPECT_EQ(import_files(options_).samples[0].channels, (std::vector<std::vector<double>>{{6, 7, 8}, {5, 6, 7}}));
  options_.files = {made({0, 1000, 2000, 3000})};
  EXPECT_EQ(import_files(options_).samples[0].channels,
            (std::vector<std::vector<double>>{{5, 6, 7, 8}, {5, 6, 7, 8}}));
  options_.files = {made({500, 1500, 2500, 3500})};
  EXPECT_TRUE(contains(complaint(), "0.5 steps from the begin"));
  options_.files = {made({0, 2000, 4000, 6000})};
  EXPECT_TRUE(contains(complaint(), "is sampled at 0.5 Hz by its own time b.time_ms"));
}

// What is recorded longer is cut, whichever channel that is.
TEST_F(Import, ChannelsOfDifferentLengthsEndTogether) {
  for (const bool first_longer : {true, false}) {
    const std::vector<double> more = {0, 1, 2, 3, 4}, fewer = {0, 1, 2};
    const fs::path mat = folder_ / "a.mat";
    {
      MatWriter writer(mat);
      const auto add = [&](const char* name, const std::vector<double>& values) {
        writer.add(
            MatWriter::structure(name, 1, {"t", "x"}, {MatWriter::row("", values), MatWriter::row("", values)}));
      };
      add("a", first_longer ? more : fewer);
      add("b", first_longer ? fewer : more);
    }
    options_.files = {mat};
    options_.time = "a.t";
    options_.channels = {"x=a.x:response:voltage:V", "y=b.x:response:voltage:V"};
    EXPECT_EQ(import_files(options_).samples[0].channels, (std::vector<std::vector<double>>{{0, 1, 2}, {0, 1, 2}}));
  }
}

TEST_F(Import, AChannelThatBeginsBetweenSamplesIsRefused) {
  const fs::path file = testing_support::source_folder() / "../shared/faults/times_of_channels/x_starts.uff";
  if (!fs::exists(file)) GTEST_SKIP() << "../shared/faults is not there";
  options_.files = {file};
  options_.time = "force.t";
  options_.channels = {"force:excitation", "tip:response"};
  EXPECT_TRUE(contains(complaint(), "2.56 steps from the begin of the others at 0 s"));
}

TEST_F(Import, WhoReadsRecordsHearsOfClipping) {
  for (const double limit : {0.9, 2.0}) {
    std::string text = "t,base,tip\n";
    for (int i = 0; i < 1000; ++i)
      text +=
          fmt::format("{},{},{}\n", i / 100.0, std::cos(0.51 * i), std::clamp(std::sin(0.51 * i), -limit, limit));
    options_.files.insert(options_.files.begin(), write(fmt::format("run{}.csv", limit), text));
  }
  const ImportedFiles imported = import_files(options_);
  write_campaign(imported.campaign, imported.samples, folder_ / "c");
  const Campaign campaign = read_campaign(folder_ / "c");
  WatchedReader reader(campaign);
  EXPECT_TRUE(reader.warnings().empty());
  for (std::size_t r = campaign.records.size(); r-- > 0;) EXPECT_GE(reader.read(r).samples(), 3u);
  ASSERT_EQ(reader.warnings().size(), 1u);
  EXPECT_TRUE(contains(reader.warnings().front(), "tip: "));
  EXPECT_TRUE(contains(reader.warnings().front(), "in 1 of 3 records, first records/run0.9.csv"));
}

}  // namespace
}  // namespace secular
