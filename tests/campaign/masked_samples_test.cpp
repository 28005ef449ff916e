// Rows that a file does not hold, and samples that it holds wrongly, on their way into a record.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "input/input_error.hpp"
#include "measure/data/campaign.hpp"
#include "measure/data/inspection.hpp"
#include "measure/data/lost_rows.hpp"
#include "measure/data/recorded_span.hpp"
#include "measure/data/watched_reader.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "measure/disturbances/held_samples.hpp"
#include "measure/disturbances/treatment.hpp"
#include "tests/process_folder.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

constexpr double masked_rate = 500;
constexpr std::size_t masked_count = 4000;

std::vector<double> signal(double noise) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> x(masked_count);
  for (std::size_t i = 0; i < masked_count; ++i)
    x[i] =
        2 * std::cos(2 * std::numbers::pi * 11.3 * static_cast<double>(i) / masked_rate) + noise * normal(random);
  return x;
}

// A campaign of one dwell of a base and a response with the given rows left out.
Campaign written(const fs::path& folder, const std::vector<double>& response,
                 const std::vector<std::size_t>& lost) {
  fs::create_directories(folder / "records");
  std::ofstream(folder / "campaign.toml")
      << "schema = 1\nname = \"masked\"\nsample_rate_hz = 500.0\n"
         "[[channel]]\nname = \"base\"\nrole = \"excitation\"\nquantity = \"acceleration\"\nunit = \"m/s^2\"\n"
         "[[channel]]\nname = \"tip\"\nrole = \"response\"\nquantity = \"acceleration\"\nunit = \"m/s^2\"\n"
         "[[record]]\nfile = \"records/0001.csv\"\nkind = \"dwell\"\nexcitation_frequency_hz = 11.3\n"
         "excitation_amplitude = 2.0\n";
  std::ofstream file(folder / "records/0001.csv");
  file.precision(12);
  file << "t,base,tip\n";
  const std::vector<double> base = signal(1e-3);
  for (std::size_t i = 0; i < masked_count; ++i)
    if (std::find(lost.begin(), lost.end(), i) == lost.end())
      file << static_cast<double>(i) / masked_rate << ',' << base[i] << ',' << response[i] << '\n';
  file.close();
  return read_campaign(folder);
}

Record read_masked(const Campaign& campaign) {
  WatchedReader reader(campaign, {}, [&](std::size_t r, const Record& record, const auto& values) {
    return treatment_of(campaign, r, record, values);
  });
  const Record first = reader.read(0), again = reader.read(0);
  EXPECT_EQ(first.channels, again.channels);
  return first;
}

class MaskedSamples : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder); }
  fs::path folder = testing_support::process_folder() /
                    ("masked_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(MaskedSamples, RowsThatAreNotInTheFileAreFilled) {
  const std::vector<double> x = signal(1e-3);
  const std::vector<std::size_t> lost = {100, 1500, 1501, 1502, 3000};
  const Campaign campaign = written(folder, x, lost);
  const Record record = read_record(campaign, campaign.records[0]);
  EXPECT_EQ(record.lost, lost);
  EXPECT_EQ(record.sample_rate_hz, masked_rate);
  ASSERT_EQ(record.samples(), masked_count);
  for (std::size_t i = 0; i < masked_count; ++i) EXPECT_NEAR(record.channels[1][i], x[i], 0.01) << i;
  const std::vector<Disturbance> found = find_disturbances(campaign, 0, record);
  const auto listed =
      std::find_if(found.begin(), found.end(), [](const Disturbance& d) { return d.kind == "lost_samples"; });
  ASSERT_NE(listed, found.end());
  EXPECT_EQ(listed->size, 5);
  EXPECT_EQ(listed->treated, "masked");
}

// Puts other text into cells of the response, by line of the file.
void put(const fs::path& file, const std::map<std::size_t, std::string>& cells) {
  std::ifstream from(file);
  std::string text, line;
  for (std::size_t number = 1; std::getline(from, line); ++number) {
    if (const auto cell = cells.find(number); cell != cells.end())
      line = line.substr(0, line.rfind(',') + 1) + cell->second;
    text += line + '\n';
  }
  from.close();
  std::ofstream(file) << text;
}

TEST_F(MaskedSamples, CellsThatAreNoNumbersAreFilledBesideLostRows) {
  const std::vector<double> x = signal(1e-3);
  const std::vector<std::size_t> lost = {100, 101};
  const Campaign campaign = written(folder, x, lost);
  put(folder / "records/0001.csv", {{52, "nan"}, {53, ""}, {2000, "NaN"}, {3500, "-inf"}});
  const Record record = read_masked(campaign);
  EXPECT_EQ(record.lost, lost);
  // Line 2 is sample 0; from sample 102 on two lines are missing.
  EXPECT_EQ(record.no_numbers.at(1), (std::vector<std::size_t>{50, 51, 2000, 3500}));
  EXPECT_TRUE(record.no_numbers.at(0).empty());
  for (std::size_t i = 0; i < masked_count; ++i) EXPECT_NEAR(record.channels[1][i], x[i], 0.01) << i;
  const std::vector<Disturbance> found = find_disturbances(campaign, 0, record);
  for (const std::size_t channel : {0U, 1U}) {
    const auto listed = std::find_if(found.begin(), found.end(), [&](const Disturbance& d) {
      return d.kind == "lost_samples" && d.channel == channel;
    });
    ASSERT_NE(listed, found.end());
    EXPECT_EQ(listed->size, channel == 0 ? 2 : 6);
    EXPECT_EQ(listed->treated, "masked");
  }
  const RecordInspection inspected = inspect_records(campaign).front();
  EXPECT_EQ(inspected.channels[1].missing, 4u);
  EXPECT_EQ(inspected.channels[1].faults.front().kind, "missing");
  EXPECT_TRUE(inspected.faults.empty());
}

TEST_F(MaskedSamples, CellsThatNothingTellsAreRefusedAtTheirPlace) {
  const Campaign campaign = written(folder, signal(1e-3), {});
  const auto refusal = [&](const std::map<std::size_t, std::string>& cells) {
    put(folder / "records/0001.csv", cells);
    try {
      read_record(campaign, campaign.records[0]);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  std::map<std::size_t, std::string> run;
  for (std::size_t line = 700; line < 720; ++line) run[line] = "nan";
  EXPECT_NE(refusal(run).find("line 700, column tip: 20 in a row are no finite number"), std::string::npos);
  EXPECT_NE(refusal({{900, "ok"}}).find("line 900, column tip: 'ok' is not a number"), std::string::npos);
}

TEST_F(MaskedSamples, ALongGapIsRefusedAtItsPlace) {
  std::vector<std::size_t> lost;
  for (std::size_t i = 1000; i < 1040; ++i) lost.push_back(i);
  const Campaign campaign = written(folder, signal(1e-3), lost);
  try {
    read_record(campaign, campaign.records[0]);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("line 1002"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("a gap of"), std::string::npos) << error.what();
  }
}

// A window may hold filled samples alone.
TEST(FilledSamples, AStretchOfThemAloneHasValues) {
  const Record record{0, masked_rate, {{1, 2, 4, 3, 5}}, 0, {1, 2}};
  EXPECT_EQ(values_of(record, 0, std::span(record.channels[0]).subspan(1, 2)).sorted, (std::vector<double>{2, 4}));
  EXPECT_EQ(values_of(record, 0, record.channels[0]).sorted, (std::vector<double>{1, 3, 5}));
}

// Stamps in whole milliseconds of samples 1.5 ms apart step by one and by two of them: nothing is lost.
TEST(LostRows, StampsRoundedToTicksLackNothing) {
  std::vector<double> stamps;
  for (int i = 0; i < 1000; ++i) stamps.push_back(std::floor(1.5 * i) / 1000);
  EXPECT_TRUE(lost_rows(stamps).empty());
  // A step that is no whole number of the others is no lost row.
  std::vector<double> odd;
  for (int i = 0; i < 1000; ++i) odd.push_back(0.01 * (i < 500 ? i : i + 1.5));
  EXPECT_TRUE(lost_rows(odd).empty());
  for (double& t : odd)
    if (t >= 5) t += 0.005;
  EXPECT_EQ(lost_rows(odd), (std::vector<std::size_t>{500, 501}));
}

TEST_F(MaskedSamples, HeldSamplesAndSpikesAreReplaced) {
  const std::vector<double> x = signal(1e-3);
  std::vector<double> faulty = x;
  for (std::size_t i = 60; i + 60 < masked_count; i += 131) faulty[i] = faulty[i - 1];
  faulty[777] += 9;
  faulty[2222] -= 11;
  const Record record = read_masked(written(folder, faulty, {}));
  double worst = 0;
  for (std::size_t i = 0; i < masked_count; ++i)
    if (std::abs(faulty[i] - x[i]) > 0.02) worst = std::max(worst, std::abs(record.channels[1][i] - x[i]));
  EXPECT_LT(worst, 0.01);
}

// A converter repeats values by itself, twelve samples in a turn bend between two of them, and there is noise and
// hum.
TEST(HeldSamples, AreFoundOnACoarseConverter) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto at = [](double hz, std::size_t i) {
    return std::cos(2 * std::numbers::pi * hz * static_cast<double>(i) / 256);
  };
  for (const double held_share : {0.0, 0.0075}) {
    int found = 0;
    for (int record = 0; record < 20; ++record) {
      std::vector<double> x(6144);
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = 0.04 * std::round((19 * at(21.1, i) + 0.1 * at(50, i) + 0.05 * normal(random)) / 0.04);
      std::vector<std::size_t> held;
      for (std::size_t i = 1; i < x.size(); ++i)
        if (std::generate_canonical<double, 53>(random) < held_share && x[i] != x[i - 1]) {
          x[i] = x[i - 1];
          held.push_back(i);
        }
      const HeldSamples told = find_held(x, values_of(x), 1e-4);
      found += !told.runs.empty();
      if (held.empty() || told.runs.empty()) continue;
      // One that is not among them was hardly a wrong value.
      const auto hit = std::count_if(held.begin(), held.end(), [&](std::size_t i) {
        return std::any_of(told.runs.begin(), told.runs.end(),
                           [i](const HeldSamples::Run& run) { return run.begin <= i && i < run.end; });
      });
      EXPECT_GT(static_cast<double>(hit), 0.8 * static_cast<double>(held.size())) << record;
    }
    EXPECT_EQ(found, held_share > 0 ? 20 : 0);
  }
}

// Few runs in a record are a small share of it, smaller than what chance makes of one repeat on this converter;
// none of them is made by chance all the same.
TEST(HeldSamples, OfLongRunsNoneIsMissed) {
  std::vector<double> measured = signal(1e-3);
  for (double& value : measured) value = 1.2e-5 * std::round(value / 1.2e-5);
  for (std::size_t shift = 0; shift < 40; ++shift) {
    std::vector<double> x = measured;
    for (std::size_t begin = 300 + shift; begin < 3400; begin += 640)
      std::fill_n(x.begin() + static_cast<std::ptrdiff_t>(begin), 30, x[begin - 1]);
    const HeldSamples told = find_held(x, values_of(x), 1e-4);
    for (std::size_t begin = 300 + shift; begin < 3400; begin += 640)
      EXPECT_EQ(
          std::count_if(told.runs.begin(), told.runs.end(),
                        [&](const HeldSamples::Run& run) { return run.begin <= begin && run.end >= begin + 30; }),
          1)
          << shift << " " << begin;
  }
  EXPECT_TRUE(find_held(measured, values_of(measured), 1e-4).runs.empty());
}

// Furthest that a sample of the record read is off the one that was measured.
double furthest_off(const Record& record, const std::vector<double>& measured) {
  double worst = 0;
  for (std::size_t i = 0; i < measured.size(); ++i)
    worst = std::max(worst, std::abs(record.channels[1][i] - measured[i]));
  return worst;
}

// So many that they hide one another, of all sizes; and those of a number that stands for lost samples, of which
// some hardly differ from what was measured.
TEST_F(MaskedSamples, ManyWrongSamplesAreReplaced) {
  const std::vector<double> x = signal(1e-2);
  std::mt19937 random(3);
  for (const bool marked : {true, false}) {
    std::vector<double> faulty = x;
    for (std::size_t i = 60; i + 60 < masked_count; i += 40 + random() % 60)
      faulty[i] =
          marked ? 0.2 : x[i] + (random() % 2 == 0 ? -1 : 1) * (1 + static_cast<double>(random() % 100) / 50);
    EXPECT_LT(furthest_off(read_masked(written(folder, faulty, {})), x), 0.1) << marked;
  }
}

// Noise of a tenth of the signal hides what single samples are off; that so many are one and the same tells it.
TEST_F(MaskedSamples, LostSamplesThatNoiseHidesAreReplaced) {
  const std::vector<double> x = signal(0.2);
  std::vector<double> faulty = x;
  for (std::size_t i = 60; i + 60 < masked_count; i += 131) faulty[i] = 0;
  const Record record = read_masked(written(folder, faulty, {}));
  for (std::size_t i = 60; i + 60 < masked_count; i += 131) EXPECT_NE(record.channels[1][i], 0) << i;
}

TEST_F(MaskedSamples, TheFirstOfAHeldRunIsReplacedWhereItIsForeign) {
  const std::vector<double> x = signal(1e-3);
  std::vector<double> faulty = x;
  for (const int begin : {500, 1250, 2999}) std::fill_n(faulty.begin() + begin, 8, begin == 1250 ? 0.7 : -1.1);
  EXPECT_LT(furthest_off(read_masked(written(folder, faulty, {})), x), 0.05);
  // Here it was measured, and stays.
  faulty = x;
  std::fill_n(faulty.begin() + 1250, 8, x[1250]);
  EXPECT_NEAR(read_masked(written(folder, faulty, {})).channels[1][1250], x[1250], 1e-9);
}

TEST_F(MaskedSamples, SpikesThatAreHeldAreReplaced) {
  const std::vector<double> x = signal(1e-3);
  std::vector<double> faulty = x;
  for (const int at : {777, 2222}) std::fill_n(faulty.begin() + at, 3, at == 777 ? 9.0 : -4.5);
  EXPECT_LT(furthest_off(read_masked(written(folder, faulty, {})), x), 0.05);
}

// At an end of the range, above and below, and in runs as long as what tells the local step.
TEST_F(MaskedSamples, NumbersOutOfReachAreLostSamples) {
  const std::vector<double> x = signal(1e-3);
  for (const double mark : {-999.0, 20.0}) {
    std::vector<double> faulty = x;
    for (int begin = 60; begin + 60 < static_cast<int>(masked_count); begin += 160)
      std::fill_n(faulty.begin() + begin, 4, mark);
    EXPECT_LT(furthest_off(read_masked(written(folder, faulty, {})), x), 0.05) << mark;
  }
}

// Many samples and few turns: spikes that are many a turn are not the motion's own.
TEST_F(MaskedSamples, SpikesOfAFewTurnsAreReplaced) {
  std::vector<double> x = signal(1e-3);
  for (std::size_t i = 0; i < masked_count; ++i)
    x[i] += 2 * std::sin(2 * std::numbers::pi * 0.6 * static_cast<double>(i) / masked_rate) -
            2 * std::cos(2 * std::numbers::pi * 11.3 * static_cast<double>(i) / masked_rate);
  for (const std::size_t every : {131U, 800U}) {
    std::vector<double> faulty = x;
    for (std::size_t i = 60; i + 60 < masked_count; i += every) faulty[i] += i % 2 == 0 ? 1.7 : -1.1;
    EXPECT_LT(furthest_off(read_masked(written(folder, faulty, {})), x), 0.02) << every;
  }
}

// A row that is put in lies on no converter's lattice: steps beside it are no spikes.
TEST_F(MaskedSamples, CoarseStepsBesideALostRowAreNoSpikes) {
  std::vector<double> stepped = signal(5e-3);
  for (double& x : stepped) x = 0.4 * std::round(x / 0.4);
  const Campaign campaign = written(folder, stepped, {1500});
  for (const Disturbance& d : find_disturbances(campaign, 0, read_record(campaign, campaign.records[0])))
    EXPECT_TRUE(d.kind == "converter_step" || d.kind == "lost_samples" || d.kind == "clipping") << d.text;
}

// What a relative change of 1e-9 moves would hang on rounding. An offset makes equal samples differ most.
TEST_F(MaskedSamples, HeldSamplesAndStepsAreTheSameThroughRounding) {
  std::vector<double> held = signal(1e-3), stepped = signal(5e-3);
  for (double& x : held) x += 8;
  for (std::size_t i = 60; i + 60 < masked_count; i += 131) held[i] = held[i - 1];
  for (double& x : stepped) x = 0.05 * std::round((x + 8) / 0.05);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto jittered = [&](std::vector<double> x) {
    for (double& value : x) value *= 1 + 1e-9 * uniform(random);
    return x;
  };
  for (const std::vector<double>& x : {held, stepped}) {
    const Record plain = read_masked(written(folder, x, {}));
    const Record moved = read_masked(written(folder, jittered(x), {}));
    EXPECT_NE(plain.channels[1], x);
    for (std::size_t i = 0; i < masked_count; ++i)
      EXPECT_NEAR(moved.channels[1][i], plain.channels[1][i], 1e-6) << i;
  }
}

// One channel stops before the other, which goes on as cells without numbers: the record ends with the first.
TEST_F(MaskedSamples, EndsWhereNothingWasRecordedAreCutOff) {
  std::vector<double> x = signal(1e-3);
  std::fill(x.begin(), x.begin() + 40, -999);
  std::fill(x.begin() + 3500, x.end(), -999);
  const Campaign campaign = written(folder, x, {700});
  std::map<std::size_t, std::string> cells = {{2000, "nan"}};
  for (std::size_t line = 3900; line <= masked_count; ++line) cells[line] = "";
  put(folder / "records/0001.csv", cells);
  const Record record = read_masked(campaign);
  ASSERT_EQ(record.samples(), 3460u);
  EXPECT_EQ(record.cut_off, 540u);
  EXPECT_DOUBLE_EQ(record.start_s, 40 / masked_rate);
  EXPECT_EQ(record.lost, std::vector<std::size_t>{660});
  EXPECT_EQ(record.no_numbers.at(1), std::vector<std::size_t>{1959});
  for (std::size_t i = 0; i < record.samples(); ++i) EXPECT_NEAR(record.channels[1][i], x[40 + i], 0.01) << i;
  const std::vector<Disturbance> found = find_disturbances(campaign, 0, record);
  const auto listed = std::find_if(found.begin(), found.end(),
                                   [](const Disturbance& d) { return d.kind == "lost_samples" && d.channel == 1; });
  ASSERT_NE(listed, found.end());
  EXPECT_EQ(listed->size, 2 + 40 + 500);
  EXPECT_NE(listed->text.find("the first 40 of 4000 samples hold -999, where nothing was recorded: cut off"),
            std::string::npos)
      << listed->text;
  const RecordInspection inspected = inspect_records(campaign).front();
  EXPECT_TRUE(inspected.faults.empty());
  EXPECT_EQ(inspected.samples, 3460u);
  EXPECT_EQ(inspected.judged, 3460u);
}

// Those of a channel that ends with the cut are not counted twice.
TEST_F(MaskedSamples, AFewBesideACutAreCutOff) {
  std::vector<double> x = signal(1e-3);
  std::fill(x.end() - 5, x.end(), -999);
  const Campaign campaign = written(folder, x, {});
  std::vector<double> stamps(masked_count), base = signal(1e-3);
  std::fill(base.end() - 50, base.end(), -999);
  std::vector<std::vector<double>> channels = {base, x};
  const CutEnds cut = cut_unrecorded(campaign, stamps, channels);
  EXPECT_EQ(cut.rows, 50u);
  ASSERT_EQ(cut.unrecorded.size(), 2u);
  for (const Unrecorded& part : cut.unrecorded) EXPECT_FALSE(part.replaced);
  EXPECT_TRUE(std::isfinite(channels[1].back()));
}

TEST_F(MaskedSamples, AFewAtAnEndAreReplaced) {
  const std::vector<double> x = signal(1e-3);
  std::vector<double> faulty = x;
  std::fill(faulty.end() - 5, faulty.end(), -999);
  std::fill(faulty.begin(), faulty.begin() + 3, 1e5);
  const Campaign campaign = written(folder, faulty, {});
  const Record record = read_masked(campaign);
  EXPECT_LT(furthest_off(record, x), 0.02);
  EXPECT_EQ(record.cut_off, 0u);
  const std::vector<Disturbance> found = find_disturbances(campaign, 0, record);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().kind, "lost_samples");
  EXPECT_EQ(found.front().size, 8);
  EXPECT_NE(found.front().text.find("the last 5 of 4000 samples hold -999, where nothing was recorded: replaced"),
            std::string::npos)
      << found.front().text;
}

TEST_F(MaskedSamples, ACleanRecordIsReadAsItIs) {
  const std::vector<double> x = signal(1e-3);
  const Campaign campaign = written(folder, x, {});
  EXPECT_EQ(read_masked(campaign).channels, read_record(campaign, campaign.records[0]).channels);
}

}  // namespace
}  // namespace secular
