// What stands around the rows of a CSV, and how their numbers are written.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "measure/data/inspection.hpp"
#include "measure/formats/csv_dialect.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/formats/number_table.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using Columns = std::vector<std::vector<double>>;

class CsvAround : public TemporaryFolder {
 protected:
  NumberTable table(const std::string& text) const { return read_csv(write("a.csv", text)); }
  std::string complaint(const std::string& text) const {
    return refusal([&] { table(text); });
  }
  NumberTable with_gaps(const std::string& text) const {
    return read_csv(write("a.csv", text), {}, MissingNumbers::keep_as_nan);
  }
};

// In every dialect a field that is empty is missing, wherever it stands.
TEST_F(CsvAround, EmptyFieldsAtTheEndsOfARowAreFields) {
  for (const char gap : {',', ';', '\t'}) {
    const auto row = [&](const std::string& a, const std::string& b, const std::string& c) {
      return a + gap + b + gap + c + "\n";
    };
    const std::string names = row("t", "a", "b");
    for (const std::string end : {"", "\r"}) {
      const NumberTable last = with_gaps(names + row("0", "1", "2") + row("1", "3", end) + row("2", "4", "5"));
      ASSERT_EQ(last.rows(), 3U) << gap;
      EXPECT_TRUE(std::isnan(last.columns[2][1])) << gap;
      EXPECT_EQ(last.columns[1], (std::vector<double>{1, 3, 4})) << gap;
    }
    const NumberTable first = with_gaps(names + row("", "1", "2") + row("1", "", "5") + row("", "", "6"));
    ASSERT_EQ(first.rows(), 3U) << gap;
    EXPECT_TRUE(std::isnan(first.columns[0][0]) && std::isnan(first.columns[1][1]) &&
                std::isnan(first.columns[1][2]))
        << gap;
    EXPECT_EQ(first.columns[2], (std::vector<double>{2, 5, 6})) << gap;
    EXPECT_TRUE(contains(complaint(names + row("0", "1", "")), "line 2, column b: is empty")) << gap;
    EXPECT_EQ(table(row("t", "a", "b") + row("", "m/s^2", "N") + row("0", "1", "2")).units,
              (std::vector<std::string>{"", "m/s^2", "N"}))
        << gap;
    // The end of a file that is read in part.
    std::string many = names;
    for (int i = 0; i < 100; ++i) many += row(std::to_string(i), "1", i + 1 < 100 ? "2" : "");
    const NumberTable part = read_csv(write("a.csv", many), {}, MissingNumbers::keep_as_nan, 10);
    ASSERT_EQ(part.last_row.size(), 3U) << gap;
    EXPECT_EQ(part.last_row[0], 99) << gap;
  }
}

TEST_F(CsvAround, DecimalCommasStandBesideTabulatorsAndSemicolons) {
  for (const std::string gap : {"\t", ";"}) {
    EXPECT_EQ(table("t" + gap + "a\n0" + gap + "-4,5\n0,25" + gap + "1,5e-3\n").columns,
              (Columns{{0, 0.25}, {-4.5, 1.5e-3}}));
    EXPECT_EQ(table("t" + gap + "a\n0" + gap + "-4.5\n0.25" + gap + "7\n").columns,
              (Columns{{0, 0.25}, {-4.5, 7}}));
    // Both marks: one of them parts thousands, or who knows.
    EXPECT_TRUE(contains(complaint("t" + gap + "a\n0" + gap + "4,777\n0.25" + gap + "1\n"),
                         "line 3: numbers have decimal points (line 3) and commas (line 2)"));
    EXPECT_TRUE(contains(complaint("t" + gap + "a\n0" + gap + "1,234,567\n"), "is not a number"));
    EXPECT_TRUE(contains(complaint("t" + gap + "a\n0" + gap + "1.234,5\n"), "is not a number"));
  }
}

// Which mark parts thousands is said, not guessed.
TEST_F(CsvAround, ADecimalMarkThatIsKnownMakesTheOtherOnePartThousands) {
  const auto columns = [&](const std::string& text, DecimalMark mark) {
    return read_csv(write("a.csv", text), {}, MissingNumbers::refuse, all_values, mark).columns;
  };
  const Columns right = {{0, 0.5, 1}, {4777, -1234567.25, 12}};
  const DecimalMark point = DecimalMark::point, comma = DecimalMark::comma;
  EXPECT_EQ(columns("t;a\n0;4,777\n0.5;-1,234,567.25\n1;12\n", point), right);
  EXPECT_EQ(columns("t;a\n0;4.777\n0,5;-1.234.567,25\n1;12\n", comma), right);
  EXPECT_EQ(columns("t\ta\n0\t4'777\n0.5\t-1'234'567.25\n1\t12\n", point), right);
  EXPECT_EQ(columns("t;a\n0;4 777\n0,5;-1 234 567,25\n1;12\n", comma), right);
  EXPECT_EQ(columns("t,a\n0,\"4,777\"\n0.5,\"-1,234,567.25\"\n1,12\n", point), right);
  EXPECT_EQ(columns("t,a\n0,4777\n0.5,-1234567.25\n1,1.2e1\n", point), right);
  for (const char* const field :
       {"4,77", "4,7777", ",777", "4,,777", "1234,567", "4.5,777", "4,777,", "4,777,12.5"}) {
    const std::string text = std::string("t;a\n0.5;1\n1;") + field + "\n";
    EXPECT_TRUE(contains(refusal([&] { columns(text, point); }), "line 3, column a")) << field;
  }
  ImportOptions options;
  options.files = {write("a.csv", "t;a\n0;4,777\n0.5;-1,234,567.25\n1;12\n")};
  options.kind = "free_decay";
  options.channels = {"a:response:angle:rad"};
  EXPECT_TRUE(contains(refusal([&] { import_files(options); }), "--decimal-mark ."));
  options.decimal_mark = ".";
  EXPECT_EQ(import_files(options).samples[0].channels[0], right[1]);
  options.decimal_mark = "point";
  EXPECT_TRUE(contains(refusal([&] { import_files(options); }), ". or , was expected"));
}

TEST_F(CsvAround, LinesAboveTheNamesArePassedOver) {
  const Columns columns = {{0, 0.5}, {1, 2}};
  for (const std::string& above :
       {std::string("# Scope\n# Date: 2020-01-01\n\n"), std::string("#\n"),
        std::string("Scope export\nSerial: X0\n\n"), std::string("Operator,N,7 channels\n"), std::string("sep=,\n"),
        std::string("sep=,\r\n# by hand\r\n")}) {
    const NumberTable read = table(above + "t,a\n0,1\n0.5,2\n");
    EXPECT_EQ(read.names, (std::vector<std::string>{"t", "a"})) << above;
    EXPECT_EQ(read.columns, columns) << above;
    EXPECT_EQ(table(above + "t,a\ns,m/s^2\n0,1\n0.5,2\n").units, (std::vector<std::string>{"s", "m/s^2"})) << above;
    const auto line = 2 + std::count(above.begin(), above.end(), '\n');
    EXPECT_TRUE(contains(complaint(above + "t,a\n0,1\n0.5,x\n"), fmt::format("line {}, column a", line + 1)));
  }
  EXPECT_EQ(table("# t, a\n0,1\n0.5,2\n").names, (std::vector<std::string>{"t", "a"}));
  EXPECT_EQ(table("sep=;\nt;a\n0;1\n0,5;2\n").columns, columns);
  EXPECT_EQ(table("sep=\t\nt, of the clock\ta\n0\t1\n0,5\t2\n").names,
            (std::vector<std::string>{"t, of the clock", "a"}));
  std::string strange = "~^!&";  // of these one that no dialect has
  std::erase_if(strange, [](char c) {
    return std::any_of(std::begin(csv_dialects), std::end(csv_dialects),
                       [c](const CsvDialect& dialect) { return dialect.separator == c; });
  });
  ASSERT_FALSE(strange.empty());
  const std::string unknown = complaint(fmt::format("sep={0}\nt{0}a\n0{0}1\n", strange.front()));
  EXPECT_TRUE(contains(unknown, "line 1: states a separator that is not read")) << unknown;
  for (const CsvDialect& dialect : csv_dialects)
    EXPECT_TRUE(contains(unknown, std::string(dialect.name))) << unknown;
  // Two lines that could be the names: the first is, and the second no row.
  EXPECT_TRUE(contains(complaint("t,a\nx,y\n0,1\n"), "line 2, column t: 'x' is not a number"));
  EXPECT_TRUE(contains(complaint("# t, a\n"), "is empty"));
}

TEST_F(CsvAround, EndsOfLinesAndFiles) {
  const Columns columns = {{0, 0.5}, {1, 2}};
  for (const std::string end : {"\n", "\r\n", "\r"})
    for (const std::string last : {"", "\x1A", "\x1A\x1A\x1A"}) {
      std::string text = "# from a scope" + end + "t,a" + end + "s,V" + end + "0,1" + end + "0.5,2" + end + last;
      EXPECT_EQ(table(text).columns, columns);
      EXPECT_EQ(read_csv(write("a.csv", text), {}, MissingNumbers::refuse, 1).last_row,
                (std::vector<double>{0.5, 2}));
      text.erase(text.size() - last.size() - end.size(), end.size());
      EXPECT_EQ(table(text).columns, columns);
    }
  EXPECT_TRUE(contains(complaint("t,a\r0,1\r0.5,x\r"), "line 3, column a"));
}

// Files of other programs: each is read to the very numbers of its plain neighbour.
TEST_F(CsvAround, SharedFilesAreRead) {
  const fs::path faults = testing_support::source_folder() / "../shared/faults";
  if (!fs::exists(faults)) GTEST_SKIP() << "../shared/faults is not there";
  const NumberTable plain = read_csv(faults / "header_rows/d10_units_row.csv");
  EXPECT_EQ(plain.units, (std::vector<std::string>{"s", "m/s^2", "m/s^2"}));
  ASSERT_EQ(plain.columns.size(), 3U);
  for (const char* file : {"header_rows/d11_comment_header.csv", "header_rows/d11c_sep.csv",
                           "tab_decimal_comma/d13b_tab_decimal_comma.txt", "small_ones/d38_cr_only.csv"})
    EXPECT_EQ(read_csv(faults / file).columns, plain.columns) << file;
  EXPECT_TRUE(contains(refusal([&] { read_csv(faults / "small_ones/d42b_thousands_en.csv"); }),
                       "numbers have decimal points"));
  EXPECT_EQ(read_csv(faults / "small_ones/d42b_thousands_en.csv", {}, MissingNumbers::refuse, all_values,
                     DecimalMark::point)
                .columns[1][0],
            4777);
  const FileInspection rounded = inspect_file(faults / "rounded_stamps/d17_rounded_stamps.csv");
  ASSERT_TRUE(rounded.axis);
  EXPECT_EQ(rounded.axis->sample_rate_hz, 2048);
  EXPECT_EQ(rounded.axis->start_s, 0);
  EXPECT_EQ(read_data_file(faults / "small_ones/d06b_crlf_ctrlZ.uff").format, "UFF 58");
  for (const char* file : {"small_ones/d25b_streamed.wav", "small_ones/d25c_zero_size.wav"})
    EXPECT_EQ(read_data_file(faults / file).vector("channel 1").values.size(), 2048U) << file;
}

}  // namespace
}  // namespace secular
