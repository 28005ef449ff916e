#include <fmt/format.h>

#include <cmath>

#include "measure/data/campaign.hpp"
#include "measure/data/inspection.hpp"
#include "measure/data/time_axis.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/formats/fortran_number.hpp"
#include "measure/formats/uff_file.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/uff_write.hpp"
#include "tests/campaign/variable_names.hpp"
#include "tests/campaign/write_campaign.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;

using Numbers = std::vector<double>;

// What every hand-made file has in common; the numbers follow.
const std::string identification =
    "    1         0    0         0 NONE               1   1 NONE               0   0\n";
const std::string seconds = "        17    0    0    0 Time                 s                   \n";
const std::string acceleration = "        12    0    0    0 Acceleration         m/s^2               \n";
const std::string no_axis = "         0    0    0    0 NONE                 NONE                \n";

std::string data_set(const std::string& name, const std::string& form, const std::string& numbers,
                     const std::string& ordinate = acceleration, const std::string& abscissa = seconds,
                     const std::string& function = identification) {
  return "    -1\n    58\n" + name + "\nNONE\n30-Apr-20 19:12:52\nNONE\nNONE\n" + function + form + abscissa +
         ordinate + no_axis + no_axis + numbers + "    -1\n";
}

const std::string three_single = "         2         3         1  0.00000E+00  1.00000E-02  0.00000E+00\n";

class Uff : public TemporaryFolder {
 protected:
  std::vector<UffFunction> functions(const std::string& text) const { return read_uff(write("a.uff", text)); }
  DataFile variables(const std::string& text) const { return read_data_file(write("a.uff", text)); }
  std::string complaint(const std::string& text) const {
    return refusal([&] { variables(text); });
  }
};

TEST_F(Uff, AMinimalFileIsRead) {
  const std::string text = data_set("tip", three_single, "  1.00000E+00 -2.50000E+00  3.00000E-03\n");
  const DataFile data = variables(text);
  EXPECT_EQ(data.format, "UFF 58");
  ASSERT_EQ(data.variables.size(), 2u);
  EXPECT_EQ(data.vector("t").values, (Numbers{0, 0.01, 0.02}));
  EXPECT_EQ(data.vector("tip").values, (Numbers{1, -2.5, 3e-3}));
  EXPECT_EQ(data.vector("tip").type, "single");
  EXPECT_EQ(data.vector("tip").quantity, Quantity::acceleration);
  EXPECT_EQ(data.vector("tip").unit, "m/s^2");
  EXPECT_EQ(data_variable_names(write("nameless", text)), (std::vector<std::string>{"t", "tip"}));
}

TEST_F(Uff, AcceptsWhatProgramsWrite) {
  const Numbers expected = {1, -2.5, 3e-3};
  const std::string valid = data_set("tip", three_single, "  1.00000E+00 -2.50000E+00  3.00000E-03\n");
  std::string crlf, blanks;
  for (const char c : valid) {
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
    blanks += c == '\n' ? "          \n" : std::string(1, c);
  }
  const std::string other_sets = "    -1\n   151\nmodel\n\n    -1\n    -1\n   164\n         1  SI\n    -1\n";
  for (const std::string& text :
       {valid, crlf, blanks, other_sets + valid + other_sets, valid.substr(0, valid.size() - 1),
        data_set("tip", three_single, "  1.00000D+00 -2.50000D+00  3.00000d-03\n"),
        data_set("tip", three_single, " 1.0 -2.5\n\n 3E-3\n"),
        data_set("tip", three_single, "+1.00000E+000-2.50000E+000 3.00000E-003\n"),
        data_set("tip", "2 3 1 0 0.01 0\n", "  1.00000E+00 -2.50000E+00  3.00000E-03\n"),
        data_set("tip", "         2         3         1 0.00000E+000 1.00000E-002 0.00000E+000\n",
                 "1 -2.5 3.0-3\n")})
    EXPECT_EQ(functions(text).at(0).real, expected) << text;
}

// Blocks that are filled up with zeros, blanks or ends of lines, which the header counts or does not.
TEST_F(Uff, PaddedBinaryDataAreRead) {
  UffFunction even;
  even.id_lines[0] = "tip";
  even.rate = 100;
  UffFunction uneven = even;
  uneven.even = false;
  for (int i = 0; i < 21; ++i) {
    even.real.push_back(0.25 * i);
    uneven.uneven_abscissa.push_back(0.5 * i * i);
  }
  even.count = uneven.count = 21;
  uneven.real = even.real;
  int read = 0;
  for (const UffEncoding encoding : {UffEncoding::little_endian, UffEncoding::big_endian})
    for (UffFunction function : {even, uneven})
      for (const UffOrdinate ordinate : {UffOrdinate::real_single, UffOrdinate::real_double}) {
        function.ordinate = ordinate;
        const std::string text = uff_text({function}, encoding);
        const std::string end = "    -1\n";
        const std::size_t begin = text.find("    58b") + 7, last = text.size() - end.size();
        const std::string bytes = text.substr(begin + 24, 12);
        for (const std::string padding : {"\n", "\r\n", "   ", "    \n", "\n\n"})
          for (const std::size_t zeros : {0u, 1u, 5u, 43u}) {
            const std::string fill = std::string(zeros, '\0') + padding;
            std::string counted = text.substr(0, last) + fill + end;
            counted.replace(begin + 24, 12, fmt::format("{:12}", std::stoul(bytes) + fill.size()));
            for (const std::string& file :
                 {counted, text.substr(0, last) + fill + (fill.ends_with('\n') ? "" : "\n") + end,
                  counted + text}) {
              const std::vector<UffFunction> found = functions(file);
              ASSERT_FALSE(found.empty());
              EXPECT_EQ(found[0].real, function.real);
              EXPECT_EQ(found[0].uneven_abscissa, function.uneven_abscissa);
              ++read;
            }
          }
        std::string other = text.substr(0, last) + "x" + end;
        other.replace(begin + 24, 12, fmt::format("{:12}", std::stoul(bytes) + 1));
        EXPECT_TRUE(contains(complaint(other), "bytes for 21"));
      }
  EXPECT_EQ(read, 480);
}

TEST_F(Uff, SharedPaddedFileIsRead) {
  const fs::path file = testing_support::source_folder() / "../shared/faults/small_ones/d04_58b_bytes_pad.uff";
  if (!fs::exists(file)) GTEST_SKIP() << "../shared/faults is not there";
  EXPECT_EQ(read_data_file(file).vector("tip").values.size(), 600u);
}

TEST_F(Uff, FortranNumbers) {
  EXPECT_EQ(fortran_number(" 1.5D+02 "), 150);
  EXPECT_EQ(fortran_number("1.25-100"), 1.25e-100);
  EXPECT_EQ(fortran_number("-.5"), -0.5);
  EXPECT_EQ(fortran_number("+1."), 1);
  EXPECT_EQ(fortran_number("1E-999"), 0);
  EXPECT_TRUE(std::isinf(fortran_number("1E999").value()));
  EXPECT_TRUE(std::isnan(fortran_number("*************").value()));
  EXPECT_TRUE(std::isnan(fortran_number("-1.#IND0E+00").value()));
  for (const char* const text : {"", " ", "x", "1.2.3", "0x10", "+-1", "1,5", "--1", "D", "1E", "1D5D6"})
    EXPECT_FALSE(fortran_number(text)) << text;
}

TEST_F(Uff, ARoundedIntervalMeansARoundRate) {
  EXPECT_EQ(meant_rate(" 2.44141E-04", 2.44141e-4), 4096);
  EXPECT_EQ(meant_rate(" 1.95313E-02", 1.95313e-2), 51.2);
  EXPECT_EQ(meant_rate(" 2.26757E-05", 2.26757e-5), 44100);
  EXPECT_EQ(meant_rate(" 1.00000E-03", 1e-3), 1000);
  EXPECT_EQ(meant_rate(" 3.00000E-03", 3e-3), 1 / 3e-3);
  EXPECT_EQ(meant_rate("2.44141000000E-04", 2.44141e-4), 1 / 2.44141e-4);
  EXPECT_EQ(meant_rate("2.4E-04", 2.4e-4), 1 / 2.4e-4);
  const DataFile data = variables(
      data_set("tip", "         2         3         1  0.00000E+00  2.44141E-04  0.00000E+00\n", " 1.0 2.0 3.0\n"));
  EXPECT_EQ(even_time_axis(data.vector("t").values, data.file, data.place).sample_rate_hz, 4096);
}

// Values that six digits, and the two byte widths, keep.
std::vector<UffFunction> every_form() {
  std::vector<UffFunction> made;
  for (const UffOrdinate type : {UffOrdinate::real_single, UffOrdinate::real_double, UffOrdinate::complex_single,
                                 UffOrdinate::complex_double})
    for (const bool even : {true, false}) {
      UffFunction function;
      function.id_lines = {"channel " + std::string(1, static_cast<char>('a' + made.size())), "", "date", "", ""};
      function.identification = 3;
      function.version = 2;
      function.load_case = 1;
      function.response = {"WING", 12, -3};
      function.reference = {"", 1, 3};
      function.ordinate = type;
      function.even = even;
      function.start = even ? -0.25 : 0;
      function.rate = even ? 4096 : 1;
      function.z_value = 1.5;
      function.abscissa = {17, 0, 0, 0, "Time", "s"};
      function.numerator = {12, 1, 0, 0, "Acceleration", "m/s^2"};
      function.denominator = {13, 0, 1, 0, "Force", "N"};
      for (int i = 0; i < 7; ++i) {
        if (!even) function.uneven_abscissa.push_back(0.125 * i * i);
        function.real.push_back(is_double(type) ? std::sin(i) : 0.25 * i - 1);
        if (is_complex(type)) function.imaginary.push_back(-0.5 * i);
      }
      made.push_back(function);
    }
  return made;
}

void expect_equal(const UffFunction& read, const UffFunction& made, double tolerance) {
  EXPECT_EQ(read.id_lines, made.id_lines);
  EXPECT_EQ(read.type, made.type);
  EXPECT_EQ(read.identification, made.identification);
  EXPECT_EQ(read.version, made.version);
  EXPECT_EQ(read.load_case, made.load_case);
  EXPECT_EQ(read.response.entity, made.response.entity);
  EXPECT_EQ(read.response.node, made.response.node);
  EXPECT_EQ(read.response.direction, made.response.direction);
  EXPECT_EQ(read.reference.entity, made.reference.entity);
  EXPECT_EQ(read.ordinate, made.ordinate);
  EXPECT_EQ(read.even, made.even);
  EXPECT_EQ(read.start, made.start);
  EXPECT_EQ(read.rate, made.rate);
  EXPECT_EQ(read.z_value, made.z_value);
  EXPECT_EQ(read.numerator.unit, made.numerator.unit);
  EXPECT_EQ(read.numerator.length_exponent, made.numerator.length_exponent);
  EXPECT_EQ(read.denominator.label, made.denominator.label);
  EXPECT_EQ(read.uneven_abscissa, made.uneven_abscissa);
  EXPECT_EQ(read.imaginary, made.imaginary);
  ASSERT_EQ(read.real.size(), made.real.size());
  for (std::size_t i = 0; i < made.real.size(); ++i) EXPECT_NEAR(read.real[i], made.real[i], tolerance);
}

TEST_F(Uff, EveryFormComesBackFromEveryEncoding) {
  const std::vector<UffFunction> made = every_form();
  for (const UffEncoding encoding : {UffEncoding::ascii, UffEncoding::little_endian, UffEncoding::big_endian}) {
    const std::vector<UffFunction> read = functions(uff_text(made, encoding));
    ASSERT_EQ(read.size(), made.size());
    for (std::size_t i = 0; i < made.size(); ++i)
      expect_equal(read[i], made[i], encoding == UffEncoding::ascii ? 1e-12 : 0);
  }
}

TEST_F(Uff, AsciiLinesHaveTheColumnsOfTheFormat) {
  const std::string text = uff_text({every_form().at(3)}, UffEncoding::ascii);
  EXPECT_TRUE(
      contains(text, "\n    1         3    2         1 WING              12  -3 NONE               1   3\n"));
  EXPECT_TRUE(contains(text, "\n         4         7         0  0.00000E+00  0.00000E+00  1.50000E+00\n"));
  EXPECT_TRUE(contains(text, "\n        12    1    0    0 Acceleration         m/s^2               \n"));
  EXPECT_TRUE(contains(text, "\n  0.00000E+00  0.000000000000E+00  1.25000E-01  8.414709848079E-01\n"));
}

// Made by hand, byte by byte: 1.0 and -2.0 as single numbers of either order.
TEST_F(Uff, AMinimalBinaryFileIsRead) {
  const std::string head = "channel\nNONE\nNONE\nNONE\nNONE\n" + identification +
                           "         2         2         1  0.00000E+00  5.00000E-01  0.00000E+00\n" + seconds +
                           acceleration + no_axis + no_axis;
  const std::string little("\x00\x00\x80\x3F\x00\x00\x00\xC0", 8), big("\x3F\x80\x00\x00\xC0\x00\x00\x00", 8);
  const std::string tail = "     0     0           0           0\n";
  for (const std::string end : {"    -1\n", "\n    -1\n", "\r\n    -1   \r\n", "    -1"}) {
    EXPECT_EQ(functions("    -1\n    58b     1     2          11           8" + tail + head + little + end)[0].real,
              (Numbers{1, -2}));
    EXPECT_EQ(functions("    -1\n    58b     2     2          11           8" + tail + head + big + end)[0].real,
              (Numbers{1, -2}));
  }
  const auto refused = [&](const std::string& numbers) {
    return complaint("    -1\n    58b" + numbers + tail + head + little + "    -1\n");
  };
  EXPECT_TRUE(contains(refused("     3     2          11           8"), "line 2: byte order 3"));
  EXPECT_TRUE(contains(refused("     1     1          11           8"), "VAX"));
  EXPECT_TRUE(contains(refused("     1     2          12           8"), "12 lines"));
  EXPECT_TRUE(contains(refused("     1     2          11           9"), "9 bytes for 2 values of 4 bytes"));
  EXPECT_TRUE(contains(refused("     1     2          11           4"), "announces 2 values and 4 bytes"));
  EXPECT_TRUE(
      contains(refused("     1     2          11999999999999"), "999999999999 bytes of data are announced"));
  EXPECT_TRUE(contains(refused("     x     2          11           8"), "does not describe its binary data"));
}

// Case 6 of the format has single abscissae and double values: some programs store them so, some both as double.
TEST_F(Uff, UnevenDoubleDataMayHaveSingleAbscissae) {
  const std::string head = "channel\nNONE\nNONE\nNONE\nNONE\n" + identification +
                           "         4         1         0  0.00000E+00  0.00000E+00  0.00000E+00\n" + seconds +
                           acceleration + no_axis + no_axis;
  const std::string pair("\x3F\x80\x00\x00\x40\x04\x00\x00\x00\x00\x00\x00", 12);
  const std::vector<UffFunction> read =
      functions("    -1\n    58b     2     2          11          12     0     0           0           0\n" + head +
                pair + "    -1\n");
  EXPECT_EQ(read[0].uneven_abscissa, Numbers{1});
  EXPECT_EQ(read[0].real, Numbers{2.5});
}

TEST_F(Uff, ManyDataSetsAreChannelsWithTheFirstNamesThatTellThemApart) {
  const auto two = [&](const std::string& a, const std::string& b, const std::string& label_a,
                       const std::string& label_b, int node_b) {
    const auto set = [&](const std::string& name, const std::string& label, int node) {
      UffFunction function;
      function.id_lines.front() = name;
      function.numerator.label = label;
      function.response = {"", node, -2};
      function.abscissa = {17, 0, 0, 0, "", "s"};
      function.real = {1, 2};
      return function;
    };
    return data_variable_names(
        write("a.unv", uff_text({set(a, label_a, 7), set(b, label_b, node_b)}, UffEncoding::ascii)));
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(two("base", "tip", "x", "x", 7), (Names{"t", "base", "tip"}));
  EXPECT_EQ(two("run 1", "run 1", "base", "tip", 7), (Names{"t", "base", "tip"}));
  EXPECT_EQ(two("", "", "", "", 8), (Names{"t", "7y-", "8y-"}));
  EXPECT_EQ(two("t", "tip", "a", "a", 8), (Names{"t", "7y-", "8y-"}));
  EXPECT_EQ(two("a", "a", "b", "b", 7), (Names{"t", "channel 1", "channel 2"}));
}

TEST_F(Uff, ChannelsOfDifferentTimesHaveTimesOfTheirOwn) {
  std::vector<UffFunction> made = {every_form()[0], every_form()[1]};
  const DataFile data = variables(uff_text(made, UffEncoding::little_endian));
  ASSERT_EQ(data.variables.size(), 4u);
  EXPECT_EQ(data.vector("channel a.t").values[1], -0.25 + 1.0 / 4096);
  EXPECT_EQ(data.vector("channel b.t").values[3], 0.125 * 9);
}

TEST_F(Uff, UnitsBecomeSi) {
  const auto read = [&](const std::string& axis) {
    return variables(data_set("tip", three_single, " 1.0 2.0 3.0\n", axis + "\n")).vector("tip");
  };
  const DataVariable g = read("        12    0    0    0 Acceleration         g                   ");
  EXPECT_EQ(g.quantity, Quantity::acceleration);
  EXPECT_EQ(g.unit, "m/s^2");
  EXPECT_EQ(g.stated_unit, "g");
  EXPECT_EQ(g.values, (Numbers{9.80665, 2 * 9.80665, 3 * 9.80665}));
  EXPECT_EQ(read("         8    0    0    0 NONE                 [mm]").values[0], 1e-3);
  EXPECT_EQ(read("         1    0    0    0 1x                   m/s\xB2").quantity, Quantity::acceleration);
  EXPECT_EQ(read("         1    0    0    0 1x                   m/s\xB2").stated_unit, "m/s²");
  EXPECT_EQ(read("         1    0    0    0 1x                   m/s²").unit, "m/s^2");
  EXPECT_EQ(read("        13    0    0    0 Force                kN").values[0], 1000);
  EXPECT_EQ(read("         8    0    0    0 Angle                deg").quantity, Quantity::angle);
  EXPECT_EQ(read("         3    0    0    0 Strain               %").values[0], 0.01);
  EXPECT_EQ(read("         0    0    0    0 Output               V").quantity, Quantity::voltage);
  for (const char* const unknown :
       {"        12    0    0    0 Acceleration         EU", "        12    0    0    0 Acceleration         NONE",
        "        12    0    0    0 Acceleration         N", "         1    0    0    0 Ratio                %",
        "        15    0    0    0 Pressure             Pa", "         0"}) {
    EXPECT_FALSE(read(unknown).quantity) << unknown;
    EXPECT_EQ(read(unknown).values[0], 1) << unknown;
  }
}

TEST_F(Uff, TimeBecomesSeconds) {
  const auto read = [&](const std::string& axis) {
    return variables(data_set("tip", three_single, " 1.0 2.0 3.0\n", acceleration, axis));
  };
  EXPECT_EQ(read("        17    0    0    0 Time                 ms\n").vector("t").values[1], 1e-5);
  EXPECT_EQ(read("         0    0    0    0 NONE                 NONE\n").vector("t").values[1], 0.01);
  EXPECT_TRUE(contains(refusal([&] { read("        17    0    0    0 Time                 ticks\n").vector("t"); }),
                       "--sample-rate"));
  EXPECT_TRUE(contains(refusal([&] { read("        18    0    0    0 NONE                 NONE\n").vector("t"); }),
                       "not time (17)"));
}

TEST_F(Uff, OtherFunctionsAreNoChannels) {
  const std::string frf = "    4" + identification.substr(5);
  const std::string text = data_set("tip", three_single, " 1.0 2.0 3.0\n") +
                           data_set("H1", three_single, " 1.0 2.0 3.0\n", acceleration, no_axis, frf);
  EXPECT_EQ(variables(text).vector("t").values.size(), 3u);
  EXPECT_TRUE(
      contains(refusal([&] { variables(text).vector("H1"); }),
               "variable H1: is a frequency response function (function type 4), no time response (type 1)"));
  EXPECT_TRUE(
      contains(refusal([&] { variables(uff_text({every_form().at(4)}, UffEncoding::ascii)).vector("channel e"); }),
               "is complex"));
  const FileInspection inspected = inspect_file(write("b.uff", text));
  ASSERT_EQ(inspected.variables.size(), 3u);
  EXPECT_TRUE(contains(inspected.variables[2].fault, "frequency response function"));
  EXPECT_FALSE(inspected.variables[2].quality);
}

TEST_F(Uff, ComplaintsNameTheLine) {
  const std::string numbers = "  1.00000E+00 -2.50000E+00  3.00000E-03\n";
  const auto with = [&](const std::string& form, const std::string& text) {
    return complaint(data_set("tip", form, text));
  };
  EXPECT_TRUE(contains(complaint(""), "is empty"));
  EXPECT_TRUE(contains(complaint("t,a\n0,1\n"), "line 1: is no delimiter"));
  EXPECT_TRUE(contains(complaint("    -1\n"), "line 1: no data set follows"));
  EXPECT_TRUE(contains(complaint("    -1\nxx\n"), "line 2: is no number of a data set"));
  EXPECT_TRUE(contains(complaint("    -1\n   151\n"), "data set 151 does not end"));
  EXPECT_TRUE(contains(complaint("    -1\n   151\n    -1\n"), "without a data set 58"));
  EXPECT_TRUE(contains(complaint(data_set("a", "x\n", numbers)), "line 9: does not say the form of the data"));
  EXPECT_TRUE(
      contains(complaint(data_set("a", three_single, numbers, "axis\n")), "line 11: does not describe an axis"));
  EXPECT_TRUE(contains(complaint(data_set("a", three_single, numbers, acceleration, seconds, "  one\n")),
                       "line 8: does not identify a function"));
  EXPECT_TRUE(contains(with(three_single, " 1.0 two 3.0\n"), "line 14: is no line of numbers"));
  EXPECT_TRUE(contains(with(three_single, " 1.0 2.0\n"), "line 15: the data set ends after 2 numbers"));
  EXPECT_TRUE(contains(with(three_single, numbers + numbers), "line 15: holds more numbers"));
  EXPECT_TRUE(contains(with(three_single, " 1.0 NaN 3.0\n"), "variable tip, value 2: is not a finite number"));
  EXPECT_TRUE(contains(with("         2 999999999         1  0.00000E+00  1.00000E-02  0.00000E+00\n", numbers),
                       "its header announces 999999999 values"));
  for (const char* const form : {"         3         3         1  0.00000E+00  1.00000E-02  0.00000E+00\n",
                                 "         2        -3         1  0.00000E+00  1.00000E-02  0.00000E+00\n",
                                 "         2         3         2  0.00000E+00  1.00000E-02  0.00000E+00\n",
                                 "         2         3         1  0.00000E+00  0.00000E+00  0.00000E+00\n",
                                 "         2         3         1          NaN  1.00000E-02  0.00000E+00\n",
                                 "         299999999999999999999                                        \n"})
    EXPECT_TRUE(contains(with(form, numbers), "line 9")) << form;
}

class UffImport : public Uff {
 protected:
  ImportOptions options(const std::string& unit, const std::vector<std::string>& channels) const {
    std::vector<UffFunction> made = {every_form()[0], every_form()[0]};
    made[0].id_lines[0] = "base";
    made[1].id_lines[0] = "tip";
    for (UffFunction& function : made) function.numerator.unit = unit;
    ImportOptions options;
    options.files = {write("run.unv", uff_text(made, UffEncoding::big_endian))};
    options.kind = "sweep";
    options.channels = channels;
    return options;
  }
};

TEST_F(UffImport, TheFilesUnitsAreTaken) {
  const ImportedFiles imported = import_files(options("g", {"base:excitation", "far:end=tip:response"}));
  ASSERT_EQ(imported.campaign.channels.size(), 2u);
  EXPECT_EQ(imported.campaign.channels[0].role, ChannelRole::excitation);
  EXPECT_EQ(imported.campaign.channels[1].name, "far:end");
  EXPECT_EQ(imported.campaign.channels[1].unit, "m/s^2");
  EXPECT_EQ(imported.campaign.sample_rate_hz, 4096);
  EXPECT_EQ(imported.samples[0].start_s, -0.25);
  EXPECT_EQ(imported.samples[0].channels[1][6], 0.5 * 9.80665);
  ASSERT_EQ(imported.converted.size(), 2u);
  EXPECT_EQ(imported.converted[1].from_unit, "g");
  EXPECT_TRUE(imported.left_out.empty());
  write_campaign(imported.campaign, imported.samples, folder_ / "c");
  const Campaign campaign = read_campaign(folder_ / "c");
  EXPECT_EQ(read_record(campaign, campaign.records[0]).channels, imported.samples[0].channels);
}

TEST_F(UffImport, EveryFileMustSayItsUnits) {
  options("EU", {});
  fs::rename(folder_ / "run.unv", folder_ / "second.unv");
  ImportOptions made = options("g", {"tip:response"});
  made.files.push_back(folder_ / "second.unv");
  EXPECT_TRUE(contains(refusal([&] { import_files(made); }),
                       "second.unv, variable tip: does not say quantity and unit, as the first file does"));
}

TEST_F(UffImport, WhatTheFileDoesNotSayIsAskedFor) {
  EXPECT_TRUE(contains(refusal([&] { import_files(options("g", {})); }),
                       "base:response (acceleration in m/s^2, as the file says)"));
  EXPECT_TRUE(
      contains(refusal([&] { import_files(options("EU", {"tip:response"})); }),
               "gives 'tip' the unit 'EU', which does not say what it measures; give --channel NAME:ROLE:"));
  EXPECT_TRUE(contains(refusal([&] { import_files(options("", {"tip:response"})); }), "does not say"));
  EXPECT_EQ(import_files(options("EU", {"tip:response:angle:rad"})).campaign.channels[0].unit, "rad");
  EXPECT_TRUE(contains(refusal([&] { import_files(options("g", {"tip:response:velocity:m/s"})); }),
                       "variable tip: measures acceleration in g; --channel tip says velocity"));
  EXPECT_TRUE(contains(refusal([&] { import_files(options("g", {"top:response"})); }), "base, tip"));
}

TEST_F(UffImport, ACampaignMayHaveUniversalFilesAsRecords) {
  const std::string toml =
      "schema = 1\nname = \"x\"\nsample_rate_hz = 4096.0\n[[channel]]\nname = \"tip\"\nrole = \"response\"\n"
      "quantity = \"acceleration\"\nunit = \"m/s^2\"\n[[record]]\nfile = \"run.unv\"\nkind = \"impact\"\n";
  options("g", {});
  write("campaign.toml", toml);
  const Campaign campaign = read_campaign(folder_);
  const Record record = read_record(campaign, campaign.records[0]);
  EXPECT_EQ(record.sample_rate_hz, 4096);
  EXPECT_EQ(record.channels[0][0], -9.80665);
  options("N", {});
  EXPECT_EQ(read_record(campaign, campaign.records[0]).channels[0][0], -1);
  write("campaign.toml", std::string(toml)
                             .replace(toml.find("acceleration"), 12, "velocity")
                             .replace(toml.find("m/s^2") - 4, 5, "m/s"));
  options("g", {});
  const Campaign velocity = read_campaign(folder_);
  EXPECT_TRUE(contains(refusal([&] { read_record(velocity, velocity.records[0]); }),
                       "measures acceleration in g; campaign.toml says velocity"));
}

TEST_F(UffImport, InspectionShowsChannelsAndTime) {
  options("g", {});
  const FileInspection file = inspect_file(folder_ / "run.unv");
  EXPECT_EQ(file.format, "UFF 58");
  EXPECT_EQ(file.time, "t");
  ASSERT_TRUE(file.axis);
  EXPECT_EQ(file.axis->sample_rate_hz, 4096);
  ASSERT_EQ(file.variables.size(), 3u);
  EXPECT_EQ(file.variables[1].unit, "m/s^2");
  EXPECT_EQ(file.variables[1].stated_unit, "g");
  EXPECT_TRUE(file.variables[1].quality);
}

TEST_F(UffImport, ChannelsThatBeginLaterAreShiftedByWholeSteps) {
  const auto made = [&](double delay_steps) {
    std::vector<UffFunction> functions = {every_form()[0], every_form()[0]};
    for (std::size_t f = 0; f < 2; ++f) {
      functions[f].id_lines[0] = f == 0 ? "base" : "tip";
      functions[f].numerator.unit = "N";
      functions[f].rate = 512;
      functions[f].start = f == 0 ? 0 : delay_steps / 512;
      functions[f].count = 20;
      functions[f].real.clear();
      for (int n = 0; n < 20; ++n) functions[f].real.push_back(n);
    }
    ImportOptions options;
    options.files = {write("run.unv", uff_text(functions, UffEncoding::big_endian))};
    options.kind = "sweep";
    options.channels = {"base:excitation:force:N", "tip:response:force:N"};
    options.time = "base.t";
    return options;
  };
  for (const int delay : {3, -5}) {
    for (const bool rate_alone : {false, true}) {
      ImportOptions options = made(delay);
      if (rate_alone) options.time.clear(), options.sample_rate_hz = 512;
      const ImportedFiles imported = import_files(options);
      const Record& record = imported.samples[0];
      ASSERT_EQ(record.samples(), static_cast<std::size_t>(20 - std::abs(delay)));
      EXPECT_EQ(record.channels[0][0] - record.channels[1][0], delay);
      EXPECT_EQ(record.start_s, rate_alone && delay < 0 ? 0 : std::max(0, delay) / 512.0);
      ASSERT_EQ(imported.warnings.size(), 1u);
      EXPECT_TRUE(contains(imported.warnings[0], delay > 0 ? "3 samples later" : "5 samples earlier"));
    }
  }
  EXPECT_TRUE(contains(refusal([&] { import_files(made(2.5)); }), "2.5 steps from the begin of the others"));
  EXPECT_TRUE(contains(refusal([&] { import_files(made(2.5)); }), "resample it"));
  EXPECT_TRUE(contains(refusal([&] { import_files(made(40)); }), "fewer than two samples"));
}

}  // namespace
}  // namespace secular
