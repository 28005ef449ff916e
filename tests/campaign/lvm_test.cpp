// Text files of LabVIEW.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "measure/formats/lvm_file.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

const fs::path lvm_files = testing_support::source_folder() / "tests/campaign/corpus/lvm";

class Lvm : public TemporaryFolder {};

TEST_F(Lvm, HasTimesAndChannelsWithUnits) {
  const std::vector<MatVariable> read = read_lvm(lvm_files / "valid/one.lvm");
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].path, "t");
  EXPECT_EQ(read[0].unit, "s");
  EXPECT_EQ(read[0].values, (std::vector<double>{0, 0.01, 0.02}));
  EXPECT_EQ(read[1].path, "force");
  EXPECT_EQ(read[1].unit, "Newton");
  EXPECT_EQ(read[1].values, (std::vector<double>{1.5, 2.5, 3.5}));
  EXPECT_EQ(read[2].values, (std::vector<double>{-2, -3, -4}));
  EXPECT_TRUE(read_lvm(lvm_files / "valid/one.lvm", {"tip"})[1].values.empty());
  EXPECT_EQ(read_lvm(lvm_files / "valid/one.lvm", {}, 2)[2].values, (std::vector<double>{-2, -3}));
}

TEST_F(Lvm, MakesTimesFromTheirStep) {
  const std::vector<MatVariable> read = read_lvm(lvm_files / "valid/no_times.lvm");
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].values, (std::vector<double>{0, 0.01, 0.02}));
  EXPECT_EQ(read[1].values, (std::vector<double>{1.5, 2.5, 3.5}));
  EXPECT_EQ(read[2].values, (std::vector<double>{-2, -3, -4}));
  // An empty field is a missing number.
  const fs::path file = write("gap.lvm", "LabVIEW Measurement\t\n***End_of_Header***\nX_Value\ttip\n0\t1\n1\t\n");
  EXPECT_TRUE(std::isnan(read_lvm(file)[1].values[1]));
}

TEST_F(Lvm, BecomesARecordByNamesAndRolesAlone) {
  ImportOptions options;
  options.files = {lvm_files / "valid/one.lvm"};
  options.kind = "free_decay";
  options.channels = {"force:excitation", "tip:response"};
  const ImportedFiles imported = import_files(options);
  EXPECT_DOUBLE_EQ(imported.campaign.sample_rate_hz, 100);
  EXPECT_EQ(imported.campaign.channels[0].quantity, Quantity::force);
  EXPECT_EQ(imported.campaign.channels[1].unit, "m/s^2");
  EXPECT_EQ(imported.samples[0].channels[1], (std::vector<double>{-2, -3, -4}));
}

// As LabVIEW's Write To Measurement File writes it: a header of the file, then for every segment a header and rows.
std::string lvm_text(const std::string& x_columns, char decimal, const std::vector<std::string>& segments) {
  std::string text =
      "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t" +
      std::string(1, decimal) + "\nMulti_Headings\tYes\nX_Columns\t" + x_columns +
      "\nTime_Pref\tRelative\nOperator\tA. Nyone\nDate\t2026/03/05\nTime\t11:12:13" + decimal +
      "5\n***End_of_Header***\t\n\t\n";
  for (const std::string& segment : segments) text += segment + "\n";
  return text;
}

// Two channels at 100 Hz from `begin` on: rows of numbers i + 1 and -(i + 1), in units of `factor`.
std::string lvm_segment(const std::string& x_columns, char decimal, double begin, std::size_t rows, int factor) {
  const auto with_mark = [decimal](double x) {
    std::string text = std::to_string(x);
    std::replace(text.begin(), text.end(), '.', decimal);
    return text;
  };
  const bool multi = x_columns == "Multi";
  const std::string gap = multi ? "\t\t" : "\t", x0 = with_mark(begin), step = with_mark(0.01);
  const std::string samples = std::to_string(rows);
  std::string text = "Channels\t2" + gap + "\t\nSamples\t" + samples + gap + samples + "\t\nDate\t2026/03/05" +
                     gap + "2026/03/05\t\nTime\t11:12:13" + gap + "11:12:13\t\nY_Unit_Label\tNewton" + gap +
                     "m/s^2\t\nX_Dimension\tTime" + gap + "Time\t\nX0\t" + x0 + gap + x0 + "\t\nDelta_X\t" + step +
                     gap + step + "\t\n***End_of_Header***\t\t\t\nX_Value\tforce" + (multi ? "\tX_Value" : "") +
                     "\ttip\tComment\n";
  for (std::size_t i = 0; i < rows; ++i) {
    const std::string time = x_columns == "No" ? "" : with_mark(begin + 0.01 * static_cast<double>(i));
    const double value = factor * static_cast<double>(i + 1);
    text += time + "\t" + with_mark(value) + (multi ? "\t" + time : "") + "\t" + with_mark(-value) +
            (i == 0 ? "\tthe first row" : "") + "\n";
  }
  return text;
}

TEST_F(Lvm, EverySegmentIsARecord) {
  for (const std::string columns : {"One", "Multi", "No"})
    for (const char decimal : {'.', ','}) {
      SCOPED_TRACE(columns + decimal);
      const std::string special = "***Start_Special***\nChannels\tof something else\n***End_Special***\n";
      const fs::path file = write("segments.lvm", lvm_text(columns, decimal,
                                                           {lvm_segment(columns, decimal, 0, 4, 1), special,
                                                            lvm_segment(columns, decimal, 2, 3, 10),
                                                            lvm_segment(columns, decimal, 5, 5, 100)}));
      EXPECT_EQ(count_lvm_segments(file), 3U);
      ImportOptions options;
      options.files = {file, lvm_files / "valid/one.lvm"};
      options.kind = "dwell";
      options.frequencies_hz = {1, 2, 3, 4};
      options.channels = {"force:excitation", "tip:response"};
      const ImportedFiles imported = import_files(options);
      ASSERT_EQ(imported.samples.size(), 4U);
      const double begins[] = {0, 2, 5}, factors[] = {1, 10, 100};
      const std::size_t rows[] = {4, 3, 5};
      for (std::size_t r = 0; r < 3; ++r) {
        const Record& record = imported.samples[r];
        EXPECT_NEAR(record.start_s, begins[r], 1e-9);
        EXPECT_NEAR(record.sample_rate_hz, 100, 1e-6);
        ASSERT_EQ(record.samples(), rows[r]);
        for (std::size_t i = 0; i < rows[r]; ++i) {
          EXPECT_EQ(record.channels[0][i], factors[r] * static_cast<double>(i + 1));
          EXPECT_EQ(record.channels[1][i], -record.channels[0][i]);
        }
        EXPECT_EQ(imported.campaign.records[r].excitation_frequency_hz, static_cast<double>(r + 1));
      }
      EXPECT_EQ(imported.campaign.records[1].file, "records/segments-2.csv");
    }
}

TEST_F(Lvm, UnitsOfChannelsWithTimesOfTheirOwnMayStandInTheirOrder) {
  std::string segment = lvm_segment("Multi", '.', 0, 2, 1);
  segment.replace(segment.find("Newton\t\tm/s^2"), 13, "Newton\tm/s^2");
  for (const std::string& text : {segment, lvm_segment("Multi", '.', 0, 2, 1)}) {
    const std::vector<MatVariable> read = read_lvm(write("multi.lvm", lvm_text("Multi", '.', {text})));
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(read[1].unit, "Newton");
    EXPECT_EQ(read[2].unit, "m/s^2");
  }
}

// One header in all, as with "one header only": one record.
TEST_F(Lvm, OneHeaderIsOneSegment) {
  EXPECT_EQ(count_lvm_segments(lvm_files / "valid/one.lvm"), 1U);
  EXPECT_EQ(
      count_lvm_segments(write("gap.lvm", "LabVIEW Measurement\t\n***End_of_Header***\nX_Value\ttip\n0\t1\n")), 1U);
}

TEST_F(Lvm, ComplaintsOfALaterSegmentNameTheLine) {
  // What the second header does not state is not the first one's.
  const std::string first = lvm_segment("No", '.', 0, 2, 1);
  std::string second = lvm_segment("No", '.', 0, 2, 1);
  second.erase(second.find("X0"), second.find("Delta_X") - second.find("X0"));
  const fs::path file = write("no_step.lvm", lvm_text("No", '.', {first, second}));
  EXPECT_EQ(read_lvm(file)[0].values.size(), 2U);
  EXPECT_TRUE(contains(refusal([&] { read_lvm(file, {}, all_values, 1); }), "states no number for X0"));
  const fs::path empty = write("empty.lvm", lvm_text("One", '.', {first, lvm_segment("One", '.', 0, 0, 1)}));
  EXPECT_TRUE(contains(refusal([&] { read_lvm(empty, {}, all_values, 1); }), "holds no rows"));
  const fs::path open = write("open.lvm", lvm_text("One", '.', {first}) + "***Start_Special***\nx\n");
  EXPECT_TRUE(contains(refusal([&] { read_lvm(open); }), "ends within what begins with"));
}

TEST_F(Lvm, ComplaintsNameTheLine) {
  EXPECT_TRUE(contains(refusal([] { read_lvm(lvm_files / "damaged/few_fields.lvm"); }),
                       "line 19: has 2 fields, the names are 3"));
  EXPECT_TRUE(contains(refusal([] { read_lvm(lvm_files / "damaged/no_names.lvm"); }), "without a line of names"));
  EXPECT_TRUE(contains(refusal([] { read_lvm(lvm_files / "damaged/no_step.lvm"); }), "states no number for X0"));
}

}  // namespace
}  // namespace secular
