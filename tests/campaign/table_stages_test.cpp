// Stages in which a table of lines is read, each alone and without a file.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "input/input_error.hpp"
#include "measure/data/converted_row.hpp"
#include "measure/data/found_columns.hpp"
#include "measure/data/frequency_names.hpp"
#include "measure/data/line_names.hpp"
#include "measure/data/loaded_table.hpp"
#include "measure/data/table_repeats.hpp"

namespace secular {
namespace {

using Strings = std::vector<std::string>;

DataVariable column_of(const std::string& name, std::vector<double> values = {}) {
  DataVariable variable;
  variable.name = name;
  variable.shape = {values.size()};
  variable.type = "double";
  variable.values = std::move(values);
  return variable;
}

TableRequest two_channels() {
  TableRequest request;
  request.channels = {{"force", ChannelRole::excitation, "force", Quantity::force},
                      {"tip", ChannelRole::response, "x", Quantity::displacement}};
  request.convention.degrees = true;
  request.words = {"ask phases", "ask {}", "ask level", "ask unit"};
  return request;
}

std::string refused(const auto& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TableStages, FindColumnsByNameOrAsTheyAreGiven) {
  std::vector<DataVariable> variables;
  for (const char* name : {"Frequency [Hz]", "force", "x_re", "x_im", "tip.sd", "x@1/3", "x@1/3 phase", "other"})
    variables.push_back(column_of(name));
  const FoundColumns columns = find_columns("file", variables, two_channels());
  EXPECT_EQ(columns.frequency, "Frequency [Hz]");
  EXPECT_EQ(columns.condition, "");
  EXPECT_EQ(columns.excitation, 0u);
  EXPECT_EQ(columns.unused, Strings{"other"});
  ASSERT_EQ(columns.lines.size(), 3u);
  EXPECT_EQ(columns.lines[0].amplitude, "force");
  EXPECT_EQ(columns.lines[1].imaginary, "x_im");
  EXPECT_EQ(columns.lines[1].sd, "tip.sd");
  EXPECT_EQ(columns.lines[2].number, (LineNumber{1, 3}));
  EXPECT_EQ(columns.lines[2].phase, "x@1/3 phase");
  EXPECT_EQ(columns.all(), (Strings{"Frequency [Hz]", "force", "x_re", "x_im", "tip.sd", "x@1/3", "x@1/3 phase"}));
  TableRequest given = two_channels();
  given.columns = {{"f", "other"}, {"condition", "x@1/3"}};
  EXPECT_EQ(find_columns("file", variables, given).frequency, "other");
  EXPECT_EQ(find_columns("file", variables, given).condition, "x@1/3");
  given.columns = {{"toe", "other"}};
  EXPECT_NE(refused([&] { find_columns("file", variables, given); }).find("belongs to no channel"),
            std::string::npos);
}

TEST(TableStages, EveryNameOfFrequenciesIsFound) {
  for (const std::string_view name : frequency_names) {
    const std::vector<DataVariable> variables = {column_of(std::string(name)), column_of("force"),
                                                 column_of("x.re"), column_of("x.im")};
    EXPECT_EQ(find_columns("file", variables, two_channels()).frequency, name);
  }
  EXPECT_FALSE(is_frequency_name("omega"));
  EXPECT_TRUE(is_circular_frequency_name("omega"));
}

// A table of one row, of a force at 10 Hz.
struct OneRow {
  DataFile data;
  TableRequest request = two_channels();
  FoundColumns columns;
  OneRow() {
    data.file = "file";
    data.variables = {column_of("f", {10}), column_of("force", {2}), column_of("x", {0.5}),
                      column_of("x.phase", {90})};
    columns.frequency = "f";
    columns.lines = {{0, {}, "force"}, {1, {}, "x", "x.phase"}};
  }
  ConvertedRow converted() const {
    return converted_row(loaded_table(data, columns, request), 0, columns, request);
  }
  std::complex<double> tip() const { return converted().row.find(1, {})->amplitude; }
};

TEST(TableStages, LoadedColumnsAreOfOneLengthAndOfTheirQuantity) {
  OneRow table;
  EXPECT_EQ(loaded_table(table.data, table.columns, table.request).hertz, 1);
  table.request.convention.frequency_unit = "rad/s";
  EXPECT_DOUBLE_EQ(loaded_table(table.data, table.columns, table.request).hertz, 0.5 / std::numbers::pi);
  const auto complaint = [](const OneRow& of) {
    return refused([&] { loaded_table(of.data, of.columns, of.request); });
  };
  OneRow longer = table;
  longer.data.variables[2] = column_of("x", {0.5, 0.6});
  EXPECT_NE(complaint(longer).find("variable x: has 2 numbers, f has 1"), std::string::npos);
  OneRow decibels = table;
  decibels.data.variables[2].values = {-20};
  EXPECT_NE(complaint(decibels).find("is a negative amplitude"), std::string::npos);
  OneRow force = table;
  force.data.variables[2].quantity = Quantity::force;
  force.data.variables[2].unit = "N";
  EXPECT_NE(complaint(force).find("channel tip is one of displacement"), std::string::npos);
}

TEST(TableStages, ARowIsConvertedByItsConvention) {
  OneRow table;
  const std::complex<double> i(0, 1);
  EXPECT_LT(std::abs(table.tip() - 0.5 * i), 1e-15);
  table.request.convention.lags = true;
  EXPECT_LT(std::abs(table.tip() + 0.5 * i), 1e-15);
  table.request.convention.phase_offset_rad = std::numbers::pi / 2;
  EXPECT_LT(std::abs(table.tip() - 0.5), 1e-15);
  table.request.convention.amplitude = TableConvention::Amplitude::rms;
  EXPECT_LT(std::abs(table.tip() - 0.5 * std::numbers::sqrt2), 1e-15);
  table.columns.per_excitation = true;  // a quotient of peaks as of root mean squares
  EXPECT_LT(std::abs(table.tip() - 0.5 * 2 * std::numbers::sqrt2), 1e-15);
}

TEST(TableStages, ARowThatCannotBeUsedSaysWhy) {
  OneRow table;
  EXPECT_EQ(table.converted().damage, "");
  table.data.variables[2].values = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(table.converted().damage, "tip is no number");
  table.data.variables[0].values = {-1};
  EXPECT_EQ(table.converted().damage, "the frequency is -1");
  OneRow unsaid;
  unsaid.request.convention.degrees.reset();
  EXPECT_NE(refused([&] { unsaid.converted(); }).find("ask phases"), std::string::npos);
}

TEST(TableStages, RepeatsAreOfOneSetting) {
  const auto row = [](double frequency_hz, double level) {
    LineRow made;
    made.frequency_hz = frequency_hz;
    made.condition = 1;
    made.lines = {{0, {}, level, std::nullopt}};
    return made;
  };
  const auto complaint = [&](const LineRow& second) {
    return refused([&] { require_repeats({row(10, 2), second}, 0, "file"); });
  };
  EXPECT_EQ(complaint(row(10.001, 2.1)), "");
  EXPECT_NE(complaint(row(10.1, 2)), "");
  EXPECT_NE(complaint(row(10, 3)), "");
  LineRow other = row(10, 3);
  other.condition = 2;
  EXPECT_EQ(complaint(other), "");
}

TEST(TableStages, NumbersOfLinesAreInLowestTerms) {
  EXPECT_EQ(parsed_line_number("2/4"), (LineNumber{1, 2}));
  EXPECT_EQ(parsed_line_number("0/7"), (LineNumber{0, 1}));
  EXPECT_EQ(line_suffix({3, 1}), "@3");
  for (const char* text : {"", "1/0", "-1", "1000", "1/", "x"}) EXPECT_FALSE(parsed_line_number(text)) << text;
}

}  // namespace
}  // namespace secular
