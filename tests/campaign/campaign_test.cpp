#include "measure/data/campaign.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>

#include "measure/data/campaign_writer.hpp"
#include "measure/formats/data_file.hpp"
#include "tests/campaign/mat_writer.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/write_campaign.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

class CampaignFolder : public TemporaryFolder {
 protected:
  // The campaign that tests vary: two channels, one record.
  std::string toml(const std::string& from = {}, const std::string& to = {}) const {
    std::string text = R"(schema = 1
name = "beam"
sample_rate_hz = 10.0
[[channel]]
name = "base"
role = "excitation"
quantity = "acceleration"
unit = "m/s^2"
[[channel]]
name = "tip"
role = "response"
quantity = "displacement"
unit = "m"
[modal_basis]
channels = ["tip"]
modes = ["v"]
mass_normalised_shapes = [[1.5]]
[[record]]
file = "records/0001.csv"
kind = "dwell"
excitation_frequency_hz = 2.5
excitation_amplitude = 22.5
ensemble_s = 4.0
started_s = 0.0
group = "up"
)";
    if (!from.empty()) {
      const std::size_t at = text.find(from);
      EXPECT_NE(at, std::string::npos) << from;
      text.replace(at, from.size(), to);
    }
    return text;
  }
  void store(const std::string& campaign,
             const std::string& record = "t,base,tip\n0,1,2\n0.1,3,4\n0.2,5,6\n") const {
    write("c/records/0001.csv", record);
    write("c/campaign.toml", campaign);
  }
  std::string complaint(const std::string& from, const std::string& to) const {
    store(toml(from, to));
    return refusal([&] { read_campaign(folder_ / "c"); });
  }
  std::string record_complaint(const std::string& record) const {
    store(toml(), record);
    const Campaign campaign = read_campaign(folder_ / "c");
    return refusal([&] { read_record(campaign, campaign.records.front()); });
  }
};

TEST_F(CampaignFolder, ReadsEveryKey) {
  store(toml());
  const Campaign campaign = read_campaign(folder_ / "c");
  EXPECT_EQ(campaign.name, "beam");
  EXPECT_EQ(campaign.sample_rate_hz, 10);
  ASSERT_EQ(campaign.channels.size(), 2u);
  EXPECT_EQ(campaign.channels[0].role, ChannelRole::excitation);
  EXPECT_EQ(campaign.channels[1].quantity, Quantity::displacement);
  ASSERT_TRUE(campaign.modal_basis);
  EXPECT_EQ(campaign.modal_basis->mass_normalised_shapes, (std::vector<std::vector<double>>{{1.5}}));
  ASSERT_EQ(campaign.records.size(), 1u);
  const RecordEntry& entry = campaign.records.front();
  EXPECT_EQ(entry.kind, RecordKind::dwell);
  EXPECT_EQ(entry.excitation_frequency_hz, 2.5);
  EXPECT_EQ(entry.excitation_amplitude, 22.5);
  EXPECT_EQ(entry.ensemble_s, 4.0);
  EXPECT_EQ(entry.started_s, 0.0);
  EXPECT_EQ(entry.group, "up");
  EXPECT_EQ(entry.line, 18u);
  const Record record = read_record(campaign, entry);
  EXPECT_EQ(record.channels, (std::vector<std::vector<double>>{{1, 3, 5}, {2, 4, 6}}));
  EXPECT_EQ(record.sample_rate_hz, 10);
}

// What is changed, into what, and what the message must contain: where, what is wrong, what would be right.
TEST_F(CampaignFolder, ComplaintsNameLineKeyAndWhatWouldBeRight) {
  const struct {
    const char *from, *to;
    std::vector<const char*> parts;
  } cases[] = {
      {"schema = 1", "schema = 2", {"line 1", "schema", "is not 1"}},
      {"sample_rate_hz = 10.0", "sample_rate_hz = 0", {"line 3", "not positive"}},
      {"sample_rate_hz = 10.0", "sample_rate_hz = \"10\"", {"line 3", "a string", "a number"}},
      {"sample_rate_hz = 10.0", "rate = 10", {"line 3", "rate", "not a known key", "sample_rate_hz"}},
      {"role = \"excitation\"", "role = \"drive\"", {"line 6", "'drive'", "excitation or response"}},
      {"role = \"response\"", "role = \"excitation\"", {"no channel is a response"}},
      {"quantity = \"displacement\"", "quantity = \"length\"", {"line 12", "'length'", "displacement"}},
      {"unit = \"m\"\n", "unit = \"mm\"\n", {"line 13", "0.001", "'m'"}},
      {"unit = \"m\"\n", "unit = \"m/s^2\"\n", {"line 13", "acceleration", "displacement", "'m'"}},
      {"name = \"tip\"", "name = \"base\"", {"line 10", "used twice"}},
      {"name = \"tip\"", "name = \"t\"", {"line 10", "names time"}},
      {"name = \"tip\"", "name = \"a,b\"", {"line 10", "comma"}},
      {"channels = [\"tip\"]", "channels = [\"top\"]", {"line 15", "'top'", "no channel"}},
      {"channels = [\"tip\"]", "channels = [\"base\"]", {"line 15", "excitation"}},
      {"modes = [\"v\"]", "modes = [\"v\", \"w\"]", {"line 16", "more modes"}},
      {"[[1.5]]", "[[1.5, 2]]", {"line 17", "row of 2", "1 modes"}},
      {"[[1.5]]", "[[1.5], [2]]", {"line 17", "2 rows", "1 channels"}},
      {"kind = \"dwell\"", "kind = \"dwel\"", {"line 20", "'dwel'", "free_decay"}},
      {"records/0001.csv", "records/0002.csv", {"line 19", "does not exist"}},
      {"records/0001.csv", "../c/records/0001.csv", {"line 19", "leaves the campaign folder"}},
      {"records/0001.csv", "/records/0001.csv", {"line 19", "leaves the campaign folder"}},
      {"excitation_frequency_hz = 2.5", "excitation_frequency_hz = 5", {"line 21", "half the sample rate"}},
      {"ensemble_s = 4.0", "ensemble_s = -4", {"line 23", "not positive"}},
      {"group = \"up\"", "variables = { top = \"a\" }", {"line 25", "top", "no channel"}},
      {"schema = 1", "schema = ", {"line 1", "TOML"}},
  };
  for (const auto& test : cases) {
    const std::string message = complaint(test.from, test.to);
    EXPECT_TRUE(contains(message, "campaign.toml"));
    for (const char* const part : test.parts) EXPECT_TRUE(contains(message, part)) << test.to;
  }
}

TEST_F(CampaignFolder, FoldersThatAreNoCampaignPointToImport) {
  EXPECT_TRUE(contains(refusal([&] { read_campaign(folder_ / "none"); }), "does not exist"));
  EXPECT_TRUE(contains(refusal([&] { read_campaign(folder_); }), "empty folder"));
  const fs::path file = write("data.csv", "t,a\n");
  EXPECT_TRUE(contains(refusal([&] { read_campaign(folder_); }), "secular import"));
  EXPECT_TRUE(contains(refusal([&] { read_campaign(file); }), "secular import"));
}

TEST_F(CampaignFolder, RecordComplaintsNameFileAndPlace) {
  const struct {
    const char* record;
    std::vector<const char*> parts;
  } cases[] = {
      {"t,base\n0,1\n0.1,2\n", {"line 1", "'tip'", "t, base"}},
      {"t,base,tip\n0,1,2\n0.1,x,4\n0.2,5,6\n", {"line 3", "base", "'x'", "a number"}},
      {"t,base,tip\n0,1,2\n0.1,nan,4\n0.2,5,6\n", {"line 3", "base", "no finite number"}},
      {"t,base,tip\n0,1,2\n0.1,1e999,4\n0.2,5,6\n", {"line 3", "base", "no finite number"}},
      {"t,base,tip\n0,1,2\n0.1,,4\n0.2,5,6\n", {"line 3", "base", "no finite number"}},
      {"t,base,tip\n0,1,2\n0.1,3\n0.2,5,6\n", {"line 3", "2 fields", "3"}},
      {"t,base,tip\n0,1,2\n0.1,3,4\n0.1,5,6\n", {"line 4", "repeats"}},
      {"t,base,tip\n0,1,2\n0.1,3,4\n0.05,5,6\n0.15,1,1\n", {"line 4", "backwards"}},
      {"t,base,tip\n0,1,2\n0.1,3,4\n0.2,5,6\n0.5,1,1\n", {"line 5", "gap of 0.3 s"}},
      {"t,base,tip\n0,1,2\n0.2,3,4\n0.4,5,6\n", {"5 Hz", "sample_rate_hz = 10"}},
      {"t,base,tip\n0,1,2\n", {"fewer than two samples"}},
      {"", {"is empty"}},
  };
  for (const auto& test : cases) {
    const std::string message = record_complaint(test.record);
    EXPECT_TRUE(contains(message, "0001.csv"));
    for (const char* const part : test.parts) EXPECT_TRUE(contains(message, part)) << test.record;
  }
}

TEST_F(CampaignFolder, MatRecordsMapChannelsToVariables) {
  store(toml("file = \"records/0001.csv\"",
             "file = \"a.mat\"\nvariables = { t = \"run.time\", tip = \"run.x(2).y\", base = \"drive\" }"));
  {
    MatWriter writer(folder_ / "c" / "a.mat");
    matvar_t* const points =
        MatWriter::structure("x", 2, {"y"}, {MatWriter::row("", {9, 9, 9}), MatWriter::row("", {4, 5, 6})});
    writer.add(MatWriter::structure("run", 1, {"time", "x"}, {MatWriter::column("", {0, 0.1, 0.2}), points}), true);
    writer.add(MatWriter::array<std::int16_t>("drive", MAT_C_INT16, MAT_T_INT16, 3, 1, {-1, 0, 300}));
  }
  const Campaign campaign = read_campaign(folder_ / "c");
  const Record record = read_record(campaign, campaign.records.front());
  EXPECT_EQ(record.channels, (std::vector<std::vector<double>>{{-1, 0, 300}, {4, 5, 6}}));
}

TEST_F(CampaignFolder, FormatsAreToldByContentAndByName) {
  for (const auto& [name, text, complaint] : std::vector<std::array<std::string, 3>>{
           {"a.uff", "x", "is no delimiter"},
           {"a.UNV", "x", "is no delimiter"},
           {"a.wav", "x", "not the begin of a WAV file"},
           {"a.h5", "x", "is not an HDF5 file"},
           {"a.csv", "    -1\r\n   151\r\n    -1\r\n", "is a universal file without a data set 58"}}) {
    write("c/" + name, text);
    store(toml("records/0001.csv", name));
    const Campaign campaign = read_campaign(folder_ / "c");
    EXPECT_TRUE(contains(refusal([&] { read_record(campaign, campaign.records.front()); }), complaint));
  }
  write("c/b.mat", "MATLAB 7.3 MAT-file" + std::string(600, ' '));
  store(toml("records/0001.csv", "b.mat"));
  const Campaign campaign = read_campaign(folder_ / "c");
  EXPECT_TRUE(contains(refusal([&] { read_record(campaign, campaign.records.front()); }),
                       "the signature of HDF5 is missing"));
}

// Random bit patterns of finite doubles: every exponent, denormal numbers and signed zeros among them.
// As large as a record may hold (number_range_fault) and as small as numbers are.
std::vector<double> any_numbers(std::mt19937_64& random, std::size_t count) {
  std::vector<double> numbers = {0.0, -0.0, 5e-324, 1e30, 0.1, 1.0 / 3};
  while (numbers.size() < count)
    if (const double x = std::bit_cast<double>(random()); std::abs(x) <= 1e30) numbers.push_back(x);
  return numbers;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  return true;
}

Campaign full_campaign(double rate) {
  Campaign campaign;
  campaign.name = "say \"hello\"\\\n\ttab \x01 µ";
  campaign.sample_rate_hz = rate;
  campaign.channels = {{"base", ChannelRole::excitation, Quantity::voltage, "V"},
                       {"uprx+", ChannelRole::response, Quantity::strain, "m/m"},
                       {"top left", ChannelRole::response, Quantity::strain, "1"}};
  campaign.modal_basis = ModalBasis{{"uprx+", "top left"}, {"v1"}, {{1.0 / 3}, {-1e-300}}};
  RecordEntry entry;
  entry.file = "records/a.mat";
  entry.kind = RecordKind::sweep;
  entry.excitation_frequency_hz = 0.1;
  entry.excitation_amplitude = 1.0 / 7;
  entry.ensemble_s = 3;
  entry.started_s = -1e-9;
  entry.group = "x = \"y\"";
  campaign.records = {entry, RecordEntry{}};
  campaign.records[1].file = "second.csv";
  campaign.records[1].kind = RecordKind::impact;
  return campaign;
}

class RoundTrip : public CampaignFolder, public testing::WithParamInterface<double> {};

TEST_P(RoundTrip, RestoresEveryBit) {
  const Campaign campaign = full_campaign(GetParam());
  std::mt19937_64 random(7);
  std::vector<Record> samples(2);
  for (Record& record : samples) {
    record.sample_rate_hz = GetParam();
    for (int c = 0; c < 3; ++c) record.channels.push_back(any_numbers(random, 500));
  }
  samples[1].start_s = 12.3;
  write_campaign(campaign, samples, folder_ / "c");
  const Campaign again = read_campaign(folder_ / "c");
  EXPECT_EQ(again.name, campaign.name);
  EXPECT_EQ(again.sample_rate_hz, campaign.sample_rate_hz);
  ASSERT_EQ(again.channels.size(), 3u);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(again.channels[c].name, campaign.channels[c].name);
    EXPECT_EQ(again.channels[c].role, campaign.channels[c].role);
    EXPECT_EQ(again.channels[c].quantity, campaign.channels[c].quantity);
    EXPECT_EQ(again.channels[c].unit, campaign.channels[c].unit);
  }
  EXPECT_EQ(again.modal_basis->channels, campaign.modal_basis->channels);
  EXPECT_EQ(again.modal_basis->modes, campaign.modal_basis->modes);
  EXPECT_EQ(again.modal_basis->mass_normalised_shapes, campaign.modal_basis->mass_normalised_shapes);
  ASSERT_EQ(again.records.size(), 2u);
  EXPECT_EQ(again.records[0].file, "records/a.csv");
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(again.records[r].kind, campaign.records[r].kind);
    EXPECT_EQ(again.records[r].excitation_frequency_hz, campaign.records[r].excitation_frequency_hz);
    EXPECT_EQ(again.records[r].excitation_amplitude, campaign.records[r].excitation_amplitude);
    EXPECT_EQ(again.records[r].ensemble_s, campaign.records[r].ensemble_s);
    EXPECT_EQ(again.records[r].started_s, campaign.records[r].started_s);
    EXPECT_EQ(again.records[r].group, campaign.records[r].group);
    const Record record = read_record(again, again.records[r]);
    EXPECT_EQ(record.start_s, samples[r].start_s);
    EXPECT_EQ(record.sample_rate_hz, GetParam());
    for (std::size_t c = 0; c < 3; ++c) EXPECT_TRUE(same_bits(record.channels[c], samples[r].channels[c]));
  }
  // The copy of the copy has the same bytes.
  write_campaign(again, {read_record(again, again.records[0]), read_record(again, again.records[1])},
                 folder_ / "d");
  for (const char* const file : {"campaign.toml", "records/a.csv", "second.csv"})
    EXPECT_EQ(read(std::string("c/") + file), read(std::string("d/") + file)) << file;
}

INSTANTIATE_TEST_SUITE_P(Rates, RoundTrip, testing::Values(256.0, 610.35, 1 / 0.0015, 51200.0 / 3, 0.5, 1e7));

TEST_F(CampaignFolder, ATakenFolderIsRefusedAndUntouched) {
  write("c/mine.txt", "keep");
  std::vector<Record> samples(2, {0, 256, {{1, 2}, {1, 2}, {1, 2}}});
  EXPECT_TRUE(contains(refusal([&] { write_campaign(full_campaign(256), samples, folder_ / "c"); }),
                       "not an empty folder"));
  EXPECT_TRUE(contains(refusal([&] { write_campaign(full_campaign(256), samples, folder_ / "c/mine.txt"); }),
                       "not an empty"));
  EXPECT_EQ(read("c/mine.txt"), "keep");
  EXPECT_EQ(entries(), 1u);
  // An empty folder is taken over, a final slash changes nothing.
  fs::create_directory(folder_ / "e");
  write_campaign(full_campaign(256), samples, folder_ / "e" / "");
  EXPECT_EQ(read_campaign(folder_ / "e").records.size(), 2u);
  EXPECT_EQ(entries(), 2u);
}

TEST_F(CampaignFolder, AFailingWriteLeavesNothing) {
  const std::vector<Record> samples(2, {0, 256, {{1, 2}, {1, 2}, {1, 2}}});
  const fs::path target = folder_ / "new" / "parent" / "c";
  const auto fails = [&](const Campaign& campaign, const std::vector<Record>& records, const char* part) {
    EXPECT_TRUE(contains(refusal([&] { write_campaign(campaign, records, target); }), part));
    EXPECT_EQ(entries(), 0u) << part;
  };
  Campaign campaign = full_campaign(256);
  campaign.records[1].file = "records/" + std::string(300, 'x') + ".csv";  // no file system takes this name
  fails(campaign, samples, "cannot be written");
  campaign = full_campaign(256);
  campaign.records[1].file = "records/a.csv/b.csv";  // inside of the first record
  fails(campaign, samples, "cannot be written");
  campaign = full_campaign(256);
  campaign.records[1].file = "records/../records/a.csv";
  fails(campaign, samples, "used twice");
  campaign.records[1].file = "../a.csv";
  fails(campaign, samples, "inside the campaign folder");
  campaign.records[1].file = "/a.csv";
  fails(campaign, samples, "inside the campaign folder");
  campaign = full_campaign(256);
  campaign.channels[1].unit = "mm";  // found when the finished campaign is read back
  fails(campaign, samples, "'mm'");
  campaign = full_campaign(256);
  campaign.channels[1].name = "a;b";
  fails(campaign, samples, "semicolon");
  std::vector<Record> diverged = samples;
  diverged[1].channels[2][1] = std::numeric_limits<double>::infinity();
  fails(full_campaign(256), diverged, "top left: sample 2 is not a finite number");
  const fs::path file = write("plain", "");
  EXPECT_TRUE(
      contains(refusal([&] { write_campaign(full_campaign(256), samples, file / "c"); }), "cannot be created"));
  EXPECT_EQ(entries(), 1u);
}

// Records longer than a block of the writer, in another order than the campaign's: the same bytes.
TEST_F(CampaignFolder, RecordByRecordIsTheSameCampaign) {
  const Campaign campaign = full_campaign(256);
  std::mt19937_64 random(11);
  std::vector<Record> samples(2);
  for (Record& record : samples) {
    record.sample_rate_hz = 256;
    for (int c = 0; c < 3; ++c) record.channels.push_back(any_numbers(random, 9001));
  }
  write_campaign(campaign, samples, folder_ / "whole");
  CampaignWriter writer(folder_ / "parts");
  for (const std::size_t r : {1u, 0u}) writer.write(campaign, campaign.records[r], samples[r]);
  EXPECT_FALSE(fs::exists(folder_ / "parts"));
  EXPECT_TRUE(contains(refusal([&] { writer.write(campaign, campaign.records[0], samples[0]); }), "used twice"));
  writer.finish(campaign);
  for (const char* const file : {"campaign.toml", "records/a.csv", "second.csv"})
    EXPECT_EQ(read(std::string("whole/") + file), read(std::string("parts/") + file)) << file;
  EXPECT_TRUE(same_bits(read_record(read_campaign(folder_ / "parts"), campaign.records[1]).channels[2],
                        samples[1].channels[2]));
  {
    CampaignWriter unfinished(folder_ / "never");
    unfinished.write(campaign, campaign.records[0], samples[0]);
  }
  EXPECT_EQ(entries(), 2u);
}

TEST_F(CampaignFolder, SamplesThatDoNotFitTheCampaignAreMisuse) {
  const Campaign campaign = full_campaign(256);
  const Record good{0, 256, {{1, 2}, {1, 2}, {1, 2}}};
  const Record other_rate{0, 300, good.channels};
  const Record two_channels{0, 256, {{1, 2}, {1, 2}}};
  const Record uneven{0, 256, {{1, 2}, {1, 2}, {1}}};
  for (const std::vector<Record>& samples :
       {std::vector<Record>{good}, {good, other_rate}, {good, two_channels}, {good, uneven}})
    EXPECT_THROW(write_campaign(campaign, samples, folder_ / "c"), std::invalid_argument);
  EXPECT_EQ(entries(), 0u);
}

}  // namespace
}  // namespace secular
