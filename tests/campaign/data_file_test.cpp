#include "measure/formats/data_file.hpp"

#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "measure/data/time_axis.hpp"
#include "measure/formats/channel_name.hpp"
#include "measure/formats/clock_stamp.hpp"
#include "measure/formats/csv_dialect.hpp"
#include "measure/formats/number_table.hpp"
#include "tests/campaign/append_numbers.hpp"
#include "tests/campaign/mat_writer.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/variable_names.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

class Csv : public TemporaryFolder {
 protected:
  NumberTable table(const std::string& text) const { return read_csv(write("a.csv", text)); }
  std::string complaint(const std::string& text) const {
    return refusal([&] { table(text); });
  }
};

using Columns = std::vector<std::vector<double>>;

TEST_F(Csv, AcceptsWhatProgramsWrite) {
  const Columns expected = {{0, 0.5}, {-1.5, 2e-3}};
  for (const char* const text :
       {"t,a\n0,-1.5\n0.5,2e-3\n", "t,a\r\n0,-1.5\r\n0.5,2e-3\r\n", "\xEF\xBB\xBFt,a\n0,-1.5\n0.5,2e-3",
        " t , a \n 0 ,\t-1.5\n +0.5 , 2E-03 \n", "t,a\n0,-1.5\n0.5,2e-3\n\n \r\n\n",
        "\n\nt,a\n\n0,-1.5\n0.5,2e-3\n", "t;a\n0;-1,5\n0,5;2e-3\n", "t;a\n0;-1.5\n0.5;2e-3\n",
        "t\ta\n0\t-1.5\n0.5\t2e-3\n", "\"t\",\"a\",\n0,-1.5,\n0.5,2e-3,\n",
        "t,a\n\"0\",\"-1.5\"\n\"0.5\",\"0.002\"\n"}) {
    const NumberTable read = table(text);
    EXPECT_EQ(read.names, (std::vector<std::string>{"t", "a"})) << text;
    EXPECT_EQ(read.columns, expected) << text;
  }
  EXPECT_EQ(table("\"a, b\",\"c;d\"\n1,2\n").names, (std::vector<std::string>{"a, b", "c;d"}));
}

// A row of csv_dialects is all that a dialect takes.
TEST_F(Csv, IsReadInEveryDialect) {
  for (const CsvDialect& dialect : csv_dialects) {
    const std::string gap(1, dialect.separator);
    const NumberTable read = table("t" + gap + "a\n[ms]" + gap + "[m/s^2]\n0" + gap + "0.5\n");
    EXPECT_EQ(read.names, (std::vector<std::string>{"t", "a"})) << dialect.name;
    EXPECT_EQ(read.units, (std::vector<std::string>{"ms", "m/s^2"})) << dialect.name;
    EXPECT_EQ(read.columns, (Columns{{0}, {0.5}})) << dialect.name;
    const std::string number = dialect.decimal_comma ? "0,5" : "0.5";
    EXPECT_EQ(table("t" + gap + "a\n0" + gap + number + "\n").columns, read.columns) << dialect.name;
    if (!dialect.in_names) {
      EXPECT_TRUE(contains(channel_name_fault("a" + gap + "b"), std::string(dialect.name)));
    }
  }
}

// Columns that blanks part, as MATLAB and NumPy write them; numbers of Fortran; remarks among the rows.
TEST_F(Csv, IsReadAsOtherProgramsWriteNumbers) {
  const Columns expected = {{0, 0.5}, {-1.5, 2e-3}};
  for (const char* const text :
       {"t a\n0 -1.5\n0.5 2e-3\n", "   t      a\n  0.0  -1.5\n 0.5   2e-3  \n", "# t a\n0.0 -1.5\n0.5 2e-3\n",
        "t a\ns m\n0 -1,5\n0,5 2e-3\n", "t,a\n0.0D+00,-1.5D0\n5.0d-01,2.0D-03\n",
        "t,a\n# begin\n0,-1.5\n0.5,2e-3\n# end of file\n", "t|a\n0|-1.5\n0.5|2e-3\n"}) {
    const NumberTable read = table(text);
    EXPECT_EQ(read.names, (std::vector<std::string>{"t", "a"})) << text;
    EXPECT_EQ(read.columns, expected) << text;
  }
  EXPECT_EQ(table("Time (s)   Tip (m)\n 0.5   1\n 1     2\n").names,
            (std::vector<std::string>{"Time (s)", "Tip (m)"}));
  EXPECT_EQ(table("tip 1\n0.5\n1\n").names, std::vector<std::string>{"tip 1"});
  EXPECT_TRUE(contains(complaint("t a\n0 1\n1 2 3\n"), "line 3: has 3 fields, the header names 2"));
  EXPECT_TRUE(contains(complaint("t,a\n0,1D\n"), "line 2, column a: '1D' is not a number"));
}

TEST_F(Csv, TimesOfDayAreSeconds) {
  for (const auto& [stamp, seconds] : {std::pair{"00:01:02", 62.0},
                                       {"12:00:00.250", 43200.25},
                                       {"12:00:00,250", 43200.25},
                                       {"1970-01-02T00:00:00.5", 86400.5},
                                       {"2024-05-01 12:00:00", 1714564800.0},
                                       {"2024/05/01 14:00:00.001+02:00", 1714564800.001},
                                       {"01.05.2024 12:00:00Z", 1714564800.0},
                                       {"2024-05-01T12:00:00.25Z", 1714564800.25}}) {
    ASSERT_TRUE(clock_stamp(stamp)) << stamp;
    EXPECT_DOUBLE_EQ(*clock_stamp(stamp), seconds) << stamp;
  }
  for (const char* const text :
       {"", "12", "12:00", "1:2:3", "12:60:00", "05/01/2024 12:00:00", "2024-13-01T00:00:00", "12:00:00 noon",
        "12:00:00+2", "a:b:c", "2024-05-01", ":", "::", "12:00:00.5x"})
    EXPECT_FALSE(clock_stamp(text)) << text;
  const NumberTable read = table("stamp,a\n2024-05-01T12:00:00.000,1\n2024-05-01T12:00:00.500,2\n");
  EXPECT_DOUBLE_EQ(read.columns[0][1] - read.columns[0][0], 0.5);
}

// A clock without a date begins anew at midnight, the record does not.
TEST_F(Csv, TimesOfDayGoOnBehindMidnight) {
  EXPECT_EQ(table("stamp,a\n23:59:59.500,1\n00:00:00.000,2\n00:00:00.500,3\n").columns[0],
            (std::vector<double>{86399.5, 86400, 86400.5}));
  // More than once, and where a stamp is missing.
  const Columns days = table("stamp,a\n20:00:00,1\n05:00:00,2\n14:00:00,3\n23:00:00,4\n08:00:00,5\n").columns;
  for (std::size_t i = 0; i < days[0].size(); ++i)
    EXPECT_EQ(days[0][i], 3600 * (20 + 9 * static_cast<double>(i))) << i;
  const NumberTable gap =
      read_csv(write("gap.csv", "stamp,a\n23:59:58,1\n,2\n00:00:00,3\n"), {}, MissingNumbers::keep_gaps);
  EXPECT_EQ(gap.columns[0][2], 86400);
  // A clock that is set back by an hour, one with a date, and numbers.
  EXPECT_EQ(table("stamp,a\n03:00:00,1\n02:00:00,2\n").columns[0], (std::vector<double>{10800, 7200}));
  EXPECT_EQ(table("stamp,a\n2024-05-02T00:00:00,1\n2024-05-01T00:00:00,2\n").columns[0],
            (std::vector<double>{1714608000, 1714521600}));
  EXPECT_EQ(table("t,a\n86399,1\n0,2\n").columns[0], (std::vector<double>{86399, 0}));
  // Where the first rows are read the last stamp is of the day that they lead to.
  std::string text = "stamp,a\n";
  for (int i = 0; i < 100; ++i) {
    const int minute = (23 * 60 + 10 + i) % 1440;
    text += std::string(minute / 60 < 10 ? "0" : "") + std::to_string(minute / 60) + ":" +
            (minute % 60 < 10 ? "0" : "") + std::to_string(minute % 60) + ":00,1\n";
  }
  const NumberTable first = read_csv(write("long.csv", text), {}, MissingNumbers::refuse, 10);
  ASSERT_EQ(first.last_row.size(), 2u);
  EXPECT_EQ(first.last_row[0], 60 * (23 * 60 + 10 + 99));
}

TEST_F(Csv, NamesMayStateUnits) {
  for (const auto& [name, bare, unit] : {std::tuple{"Kraft/N", "Kraft", "N"},
                                         {"a/(m/s^2)", "a", "m/s^2"},
                                         {"Weg/mm", "Weg", "mm"},
                                         {"Time {ms}", "Time", "ms"},
                                         {"Time <ms>", "Time", "ms"},
                                         {"Zeit/ms", "Zeit", "ms"},
                                         {"m/s^2", "m/s^2", ""},
                                         {"in/out", "in/out", ""},
                                         {"pump/in", "pump/in", ""},
                                         {"U/V", "U", "V"},
                                         {"tip m/s", "tip m/s", ""}}) {
    EXPECT_EQ(bracketed_unit(name).name, bare);
    EXPECT_EQ(bracketed_unit(name).unit, unit) << name;
  }
}

TEST_F(Csv, RowsWithoutNamesAreColumnsByNumber) {
  const Columns expected{{0, 0.5, 1}, {1.5, -2, 3}};
  for (const char* text :
       {"0.0,1.5\n0.5,-2\n1.0,3\n", "0;1,5\n0,5;-2\n1;3\n", "0.0\t1.5\n0.5\t-2\n1.0\t3\n",
        "  0.0e+00  1.5e+00\n  5.0e-01 -2.0e+00\n  1.0e+00  3.0e+00\n", "0,0\t1,5\n0,5\t-2\n1\t3",
        "0,0  1,5\n0,5  -2\n1  3\n", "# of the second test\n0.0|1.5\n0.5|-2\n1.0|3\n"}) {
    const NumberTable read = read_csv(write("a.csv", text));
    EXPECT_EQ(read.names, (std::vector<std::string>{"column1", "column2"})) << text;
    EXPECT_EQ(read.columns, expected) << text;
  }
  EXPECT_EQ(read_csv(write("one.txt", "0.25\n-1e-3\n7\n")).columns, (Columns{{0.25, -0.001, 7}}));
  // The last line of an interrupted recording is no reason to take the first one for names.
  EXPECT_TRUE(contains(complaint("0.0,1.5\n0.5,-2\n1.0"), "line 3: has 1 fields"));
}

TEST_F(Csv, ReadsUtf16) {
  const std::string text = "Zeit/s;\xC3\x9C\xF0\x9D\x84\x9E/V\r\n0,5;1\r\n1,5;2\r\n";
  const std::u16string units = u"Zeit/s;\u00DC\U0001D11E/V\r\n0,5;1\r\n1,5;2\r\n";
  for (const bool little : {true, false})
    for (const bool mark : {true, false}) {
      std::string bytes;
      const auto put = [&](char16_t unit) {
        const char low = static_cast<char>(unit & 0xFF), high = static_cast<char>(unit >> 8);
        bytes += little ? low : high;
        bytes += little ? high : low;
      };
      if (mark) put(0xFEFF);
      // Without a mark ASCII alone tells the order.
      if (!mark)
        for (const char16_t unit : std::u16string(u"# by a logger   \r\n")) put(unit);
      for (const char16_t unit : units) put(unit);
      const NumberTable read = read_csv(write("a.csv", bytes)), plain = read_csv(write("b.csv", text));
      EXPECT_EQ(read.names, plain.names) << little << mark;
      EXPECT_EQ(read.columns, (Columns{{0.5, 1.5}, {1, 2}}));
    }
}

TEST_F(Csv, ReadsOnlyWantedColumns) {
  const fs::path path = write("a.csv", "t,note,a\n0,first,1\n1,,2\n");
  const NumberTable read = read_csv(path, {"a", "t"});
  EXPECT_EQ(read.columns, (Columns{{1, 2}, {0, 1}}));
  EXPECT_TRUE(contains(refusal([&] { read_csv(path); }), "line 2, column note: 'first' is not a number"));
  EXPECT_TRUE(contains(refusal([&] { read_csv(path, {"b"}); }), "its columns are t, note, a"));
}

TEST_F(Csv, KeepsMissingNumbersOnRequest) {
  const NumberTable read =
      read_csv(write("a.csv", "t,a\n0,\n1,nan\n2,7\n3,-inf\n4,bad\n"), {}, MissingNumbers::keep_as_nan);
  EXPECT_EQ(read.columns[0], (std::vector<double>{0, 1, 2, 3, 4}));
  for (const std::size_t i : {0u, 1u, 3u, 4u}) EXPECT_TRUE(std::isnan(read.columns[1][i]));
  EXPECT_EQ(read.columns[1][2], 7);
}

TEST_F(Csv, ComplaintsNameTheLine) {
  EXPECT_TRUE(contains(complaint("t,a\n0,1\n\n2,3\n"), "line 3: an empty line or a remark between rows"));
  EXPECT_TRUE(contains(complaint("t,a\n0,1\n# b\n2,3\n"), "line 3: an empty line or a remark between rows"));
  EXPECT_TRUE(contains(complaint("0,1\n2,3\n"), "line 1: numbers that may be the columns' names or a row"));
  EXPECT_TRUE(contains(complaint("1,2,3\n0.5,2.5,1\n"), "line 1: numbers that may be the columns' names or a row"));
  EXPECT_TRUE(contains(complaint("0,001,1,250\n0,002,1,260\n"), "commas that may part columns or be decimal"));
  EXPECT_TRUE(contains(complaint("3,25\n3,27\n"), "commas that may part columns or be decimal"));
  EXPECT_TRUE(contains(complaint("0.1,7\n0.2,8,9\n0.3,9\n"), "numbers where the column names should be"));
  EXPECT_TRUE(contains(complaint("t,a,a\n0,1,2\n"), "line 1: names two columns 'a'"));
  EXPECT_TRUE(contains(complaint("t,,a\n0,1,2\n"), "line 1, column 2: has no name"));
  EXPECT_TRUE(contains(complaint("t,a\n0,1,2\n"), "line 2: has 3 fields, the header names 2"));
  EXPECT_TRUE(contains(complaint("t,a\n0,1.2.3\n"), "line 2, column a: '1.2.3' is not a number"));
  EXPECT_TRUE(contains(complaint("t,a\n0,0x10\n"), "line 2, column a"));
  EXPECT_TRUE(contains(complaint("t,a\n0,+-1\n"), "line 2, column a"));
  EXPECT_TRUE(contains(complaint("\n\nt,a\n\n0,x\n"), "line 5, column a"));
  EXPECT_TRUE(contains(complaint("t,a\n"), "no rows"));
  EXPECT_TRUE(contains(complaint("\n \n"), "is empty"));
  EXPECT_TRUE(contains(complaint(std::string("P\0\0K,\n1,2\n", 10)), "is not text"));
  EXPECT_TRUE(contains(refusal([&] { read_csv(folder_); }), "is a folder"));
  EXPECT_TRUE(contains(refusal([&] { read_csv(folder_ / "none.csv"); }), "cannot be opened"));
}

TEST_F(Csv, RestoresALargeTable) {
  NumberTable made{{"t", "a", "b"}, Columns(3, std::vector<double>(131072))};
  for (std::size_t i = 0; i < 131072; ++i)
    for (std::size_t c = 0; c < 3; ++c) made.columns[c][i] = std::sin(static_cast<double>(3 * i + c)) / 3;
  const fs::path path = write("big.csv", csv_header(made.names) + csv_rows(made.columns));
  EXPECT_EQ(read_csv(path).columns, made.columns);
}

class Mat : public TemporaryFolder {};

TEST_F(Mat, ListsAndReadsEveryNumericClass) {
  const fs::path path = folder_ / "a.mat";
  {
    MatWriter writer(path);
    writer.add(MatWriter::array<double>("d", MAT_C_DOUBLE, MAT_T_DOUBLE, 3, 1, {0.1, -2, 3e300}));
    writer.add(MatWriter::array<float>("s", MAT_C_SINGLE, MAT_T_SINGLE, 1, 3, {0.5f, -2, 3}), true);
    writer.add(MatWriter::array<std::int8_t>("i8", MAT_C_INT8, MAT_T_INT8, 1, 3, {-128, 0, 127}));
    writer.add(MatWriter::array<std::uint8_t>("u8", MAT_C_UINT8, MAT_T_UINT8, 3, 1, {0, 1, 255}), true);
    writer.add(MatWriter::array<std::int16_t>("i16", MAT_C_INT16, MAT_T_INT16, 1, 2, {-32768, 32767}));
    writer.add(MatWriter::array<std::uint16_t>("u16", MAT_C_UINT16, MAT_T_UINT16, 1, 2, {0, 65535}));
    writer.add(MatWriter::array<std::int32_t>("i32", MAT_C_INT32, MAT_T_INT32, 1, 2, {-2147483647, 5}));
    writer.add(MatWriter::array<std::uint32_t>("u32", MAT_C_UINT32, MAT_T_UINT32, 1, 2, {0, 4294967295u}), true);
    writer.add(MatWriter::array<std::int64_t>("i64", MAT_C_INT64, MAT_T_INT64, 1, 2, {-5, 1LL << 40}));
    writer.add(MatWriter::array<std::uint64_t>("u64", MAT_C_UINT64, MAT_T_UINT64, 1, 2, {5, 1ULL << 40}));
    writer.add(MatWriter::array<double>("m", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, 2, {1, 2, 3, 4}));
    writer.add(MatWriter::array<double>("none", MAT_C_DOUBLE, MAT_T_DOUBLE, 0, 0, {}));
  }
  const DataFile data = read_data_file(path);
  EXPECT_EQ(data.format, "MAT v5");
  EXPECT_EQ(data.vector("d").values, (std::vector<double>{0.1, -2, 3e300}));
  EXPECT_EQ(data.vector("s").values, (std::vector<double>{0.5, -2, 3}));
  EXPECT_EQ(data.vector("s").shape, (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(data.vector("s").type, "single");
  EXPECT_EQ(data.vector("i8").values, (std::vector<double>{-128, 0, 127}));
  EXPECT_EQ(data.vector("u8").values, (std::vector<double>{0, 1, 255}));
  EXPECT_EQ(data.vector("i16").values, (std::vector<double>{-32768, 32767}));
  EXPECT_EQ(data.vector("u16").values, (std::vector<double>{0, 65535}));
  EXPECT_EQ(data.vector("i32").values, (std::vector<double>{-2147483647, 5}));
  EXPECT_EQ(data.vector("u32").values, (std::vector<double>{0, 4294967295.0}));
  EXPECT_EQ(data.vector("i64").values, (std::vector<double>{-5, 1099511627776.0}));
  EXPECT_EQ(data.vector("u64").values, (std::vector<double>{5, 1099511627776.0}));
  EXPECT_TRUE(contains(refusal([&] { data.vector("m"); }), "variable m: is a matrix"));
  EXPECT_TRUE(contains(refusal([&] { data.vector("none"); }), "is empty"));
  EXPECT_TRUE(contains(refusal([&] { data.vector("x"); }), "its variables are d, s, i8"));
}

TEST_F(Mat, NonFiniteNumbersAreRefusedWithTheirPlace) {
  const fs::path path = folder_ / "a.mat";
  { MatWriter(path).add(MatWriter::column("a", {1, 2, std::nan("")})); }
  EXPECT_TRUE(contains(refusal([&] { read_data_file(path); }), "variable a, element 3: is not a finite number"));
  EXPECT_TRUE(std::isnan(read_data_file(path, {}, MissingNumbers::keep_as_nan).vector("a").values[2]));
}

TEST_F(Mat, NestedStructsAndCellsHavePaths) {
  const fs::path path = folder_ / "a.mat";
  {
    MatWriter writer(path);
    std::size_t shape[2] = {1, 2};
    matvar_t* cells[2] = {MatWriter::row("", {1, 2}), MatWriter::row("", {3, 4, 5})};
    matvar_t* const cell = Mat_VarCreate("c", MAT_C_CELL, MAT_T_CELL, 2, shape, cells, 0);
    matvar_t* const inner =
        MatWriter::structure("in", 2, {"x"}, {MatWriter::row("", {6, 7}), MatWriter::column("", {8, 9})});
    writer.add(MatWriter::structure("s", 1, {"in", "c"}, {inner, cell}), true);
  }
  EXPECT_EQ(data_variable_names(path), (std::vector<std::string>{"s.in(1).x", "s.in(2).x", "s.c{1}", "s.c{2}"}));
  const DataFile data = read_data_file(path, {"s.in(2).x", "s.c{2}"});
  EXPECT_EQ(data.vector("s.in(2).x").values, (std::vector<double>{8, 9}));
  EXPECT_EQ(data.vector("s.c{2}").values, (std::vector<double>{3, 4, 5}));
}

TEST_F(Mat, TextAndSparseMatricesAreLeftOut) {
  const fs::path path = folder_ / "a.mat";
  {
    MatWriter writer(path);
    writer.add(MatWriter::text("note", "second run"));
    writer.add_sparse_identity("selection", 4, true);
    writer.add(MatWriter::row("a", {1, 2}), true);
  }
  EXPECT_EQ(data_variable_names(path), std::vector<std::string>{"a"});
}

// A few bytes can inflate to any size: only what the variable's tag announces is.
TEST_F(Mat, ACompressedElementThatIsLongerThanItsVariableIsRefused) {
  const fs::path path = folder_ / "a.mat";
  { MatWriter(path).add(MatWriter::row("a", std::vector<double>(1000, 0)), true); }
  std::string bytes = read("a.mat");
  constexpr std::size_t content = 128 + 8;  // behind the header and the element's tag
  std::string variable(1 << 14, '\0');
  auto size = static_cast<uLongf>(variable.size());
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(variable.data()), &size,
                       reinterpret_cast<const Bytef*>(bytes.data()) + content, bytes.size() - content),
            Z_OK);
  variable.resize(size);
  const auto packed = [&](const std::string& text) {
    std::string stream(compressBound(text.size()), '\0');
    auto length = static_cast<uLongf>(stream.size());
    compress(reinterpret_cast<Bytef*>(stream.data()), &length, reinterpret_cast<const Bytef*>(text.data()),
             text.size());
    stream.resize(length);
    std::string file = bytes.substr(0, content);
    for (std::size_t i = 0; i < 4; ++i) file[content - 4 + i] = static_cast<char>(length >> (8 * i));
    return file + stream;
  };
  write("a.mat", packed(variable));
  EXPECT_EQ(read_data_file(path).vector("a").values.size(), 1000u);
  write("a.mat", packed(variable + std::string(1 << 20, '\0')));
  EXPECT_TRUE(contains(refusal([&] { read_data_file(path); }), "longer than its variable"));
}

TEST_F(Mat, Version4IsNamed) {
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    std::string bytes;
    for (const std::uint64_t number : {order == ByteOrder::big ? 1000U : 0U, 40U, 1U, 0U, 4U})
      append_unsigned(bytes, number, 4, order);
    bytes += std::string("tip\0", 4) + std::string(320, '\7');
    EXPECT_TRUE(contains(refusal([&] { read_data_file(write("a.mat", bytes)); }), "is a MAT v4 file"));
  }
  EXPECT_FALSE(contains(refusal([&] { read_data_file(write("a.mat", std::string(400, '\0'))); }), "v4"));
}

TEST_F(Mat, FilesThatOnlyLookLikeMatAreRefused) {
  EXPECT_TRUE(contains(refusal([&] { read_data_file(write("a.mat", "t,a\n0,1\n")); }), "not a MAT v5 file"));
  EXPECT_TRUE(contains(refusal([&] { read_data_file(write("a.mat", "")); }), "not a MAT v5 file"));
  EXPECT_TRUE(contains(refusal([&] { read_data_file(folder_ / "none.mat"); }), "does not exist"));
  EXPECT_TRUE(contains(refusal([&] { read_data_file(folder_); }), "not a regular file"));
}

TEST(MeasuredFiles, Pendulum) {
  const fs::path path = testing_support::source_folder() / "../shared/data/pendulum/cdip_pend_data.mat";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not there";
  const DataFile data = read_data_file(path);
  ASSERT_EQ(data.vector("t").values.size(), data.vector("theta").values.size());
  EXPECT_EQ(even_time_axis(data.vector("t").values, data.file, data.place).sample_rate_hz, 1000);
  double largest = 0;
  for (const double theta : data.vector("theta").values) largest = std::max(largest, std::abs(theta));
  EXPECT_NEAR(largest * 180 / std::numbers::pi, 57, 1);
}

TEST(MeasuredFiles, BoltedBeam) {
  const fs::path path = testing_support::source_folder() / "../shared/data/brake_reuss_beam/HammerImpact.mat";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not there";
  const DataFile data = read_data_file(path);
  ASSERT_EQ(data.variables.size(), 4u);
  EXPECT_EQ(even_time_axis(data.vector("HIdata.time").values, data.file, data.place).sample_rate_hz, 12800);
}

}  // namespace
}  // namespace secular
