// Files as instruments and other programs write them: each is made here as its program does, and read to the
// numbers, units, names and time that it means, or refused with what makes a file of it that is read.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "measure/data/inspection.hpp"
#include "measure/formats/data_file.hpp"
#include "tests/campaign/hdf5_writer.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/mat_writer.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/uff_write.hpp"

namespace secular {
namespace {

constexpr std::size_t file_samples = 64;
constexpr double file_rate_hz = 2048;

double tip_at(std::size_t i) {
  return std::round(1e4 * std::cos(0.7 * static_cast<double>(i))) / 1e4;
}

double force_at(std::size_t i) {
  return static_cast<double>((7 * i) % 13);
}

// Rows of (sample, time, force, tip) in the form of a program.
std::string rows(const std::function<std::string(std::size_t, double, double, double)>& row) {
  std::string text;
  for (std::size_t i = 0; i < file_samples; ++i)
    text += row(i, static_cast<double>(i) / file_rate_hz, force_at(i), tip_at(i));
  return text;
}

std::string with_commas(std::string text) {
  std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

class InstrumentFiles : public TemporaryFolder {
 protected:
  // What two channels are called and mean.
  struct Meant {
    std::string force, tip;
    double force_si = 1, tip_si = 9.80665, start_s = 0;
  };

  // Imports with what `inspect` takes for the time.
  void expect(const std::string& program, const std::string& text, const Meant& meant) {
    SCOPED_TRACE(program);
    ImportOptions options;
    options.files = {write("a.csv", text)};
    const FileInspection inspection = inspect_file(options.files.front());
    ASSERT_TRUE(inspection.axis.has_value());
    EXPECT_NEAR(inspection.axis->sample_rate_hz, file_rate_hz, 1e-6 * file_rate_hz);
    options.time = inspection.time;
    options.kind = "free_decay";
    options.channels = {"force=" + meant.force, "tip=" + meant.tip};
    const ImportedFiles imported = import_files(options);
    const Record& record = imported.samples.at(0);
    ASSERT_EQ(record.samples(), file_samples);
    EXPECT_EQ(record.jitter_s, 0);
    EXPECT_NEAR(record.start_s, meant.start_s, 1e-6);
    for (std::size_t i = 0; i < file_samples; ++i) {
      EXPECT_NEAR(record.channels[0][i], meant.force_si * force_at(i), 1e-9);
      EXPECT_NEAR(record.channels[1][i], meant.tip_si * tip_at(i), 1e-9);
    }
  }
};

const auto tab_row = [](std::size_t, double t, double force, double tip) {
  return fmt::format("{:.10f}\t{:.4f}\t{:.4f}\n", t, force, tip);
};

TEST_F(InstrumentFiles, AcquisitionProgramsPutUnitsBelowOrBehindNames) {
  const std::string table = rows(tab_row);
  expect("a remark below the units", "File name: a.dxd\nRate: 2048\n\nTime\tF\tTip\ns\tN\tg\n-\tAve\tAve\n" + table,
         {"F:excitation", "Tip:response"});
  expect("numbers in a preamble", "DATAFILE_40\n3\nT0 = 12.03.2024\nZeit 1\tF\tTip\ns\tN\tg\n" + with_commas(table),
         {"F:excitation", "Tip:response"});
  expect("a time that is called otherwise, in Latin-1",
         "Zeit 1 - Rate [s]\tKraft [N]\tSpitze [mm/s\xb2]\n" + with_commas(table),
         {"Kraft [N]:excitation", "Spitze [mm/s\u00b2]:response", 1, 1e-3});
  expect("units behind in", "in s\tF in kN\ttip in m/s^2\n" + table,
         {"F in kN:excitation", "tip in m/s^2:response", 1000, 1});
  expect("columns without names below a preamble", "Header lines: 4\nSize: 64\nFormat: t F tip\n\n" + table,
         {"column2:excitation:force:N", "column3:response:acceleration:g"});
}

TEST_F(InstrumentFiles, Oscilloscopes) {
  const auto row = [](std::size_t, double t, double force, double tip) {
    return fmt::format("{:.9E},{:.5E},{:.5E}\n", t - 0.5, force, tip);
  };
  expect("channels that are counted", "x-axis,1,2\nsecond,Volt,Volt\n" + rows(row),
         {"1:excitation", "2:response", 1, 1, -0.5});
  expect("units in the place of names",
         "Length,64\nUnits,CH1:V,CH2:V\nSource,CH1,CH2\nSecond,Volt,Volt\n" + rows(row),
         {"CH1:excitation", "CH2:response", 1, 1, -0.5});
  const std::string counted = rows([](std::size_t i, double, double force, double tip) {
    return fmt::format("{},{:.2e},{:.4e},\n", i, force, tip);
  });
  expect("begin and step above",
         "X,CH1,CH2,Start,Increment,\nSequence,VOLT,VOLT,-5.0e-01,4.8828125e-04\n" + counted,
         {"CH1:excitation", "CH2:response", 1, 1, -0.5});
  const std::string settings[] = {"Record Length,64", "Source,CH1", "Vertical Units,V"};
  const std::string beside = rows([&](std::size_t i, double t, double force, double) {
    return fmt::format("{},,{:.9f},{:.5f},\n", i < 3 ? settings[i] : ",", t - 0.5, force);
  });
  const DataFile data = read_data_file(write("tds.csv", beside), {"t", "CH1"});
  EXPECT_EQ(data.vector("t").stated_unit, "s");
  EXPECT_EQ(data.vector("CH1").stated_unit, "V");
  EXPECT_EQ(data.vector("CH1").values.at(5), force_at(5));
  EXPECT_NEAR(data.vector("t").values.at(2), -0.5 + 2 / file_rate_hz, 1e-9);
}

TEST_F(InstrumentFiles, StampsAndIndexColumns) {
  const auto stamped = [](const std::string& begin, bool comma) {
    return rows([&](std::size_t, double t, double force, double tip) {
      const std::string stamp = fmt::format("{}{:012.9f}", begin, t);
      return comma ? with_commas(fmt::format("{:.4f};{:.4f}", force, tip))
                             .insert(
                                 0, stamp.substr(0, begin.size()) + with_commas(stamp.substr(begin.size())) + ";") +
                         "\n"
                   : fmt::format("{},{:.4f},{:.4f}\n", stamp, force, tip);
    });
  };
  const double day = 19794 * 86400.0;  // 12 March 2024
  expect("an index of stamps", ",F [N],Tip [g]\n" + stamped("2024-03-12 00:00:", false),
         {"F [N]:excitation", "Tip [g]:response", 1, 9.80665, day});
  expect("an index of durations", ",F [N],Tip [g]\n" + stamped("0 days 00:00:", false),
         {"F [N]:excitation", "Tip [g]:response"});
  expect("dates with points beside decimal commas", "Stempel;F [N];Tip [g]\n" + stamped("12.03.2024 00:00:", true),
         {"F [N]:excitation", "Tip [g]:response", 1, 9.80665, day});
  expect("a unit of stamps", "Time,F,Tip\nDate/Time,N,g\n" + stamped("2024-03-12 00:00:", false),
         {"F:excitation", "Tip:response", 1, 9.80665, day});
  const auto counted = [](const std::string& mark, bool time) {
    return rows([&](std::size_t i, double t, double force, double tip) {
      return fmt::format("{0}{1}{0},{2}{3},{4}\n", mark, i, time ? fmt::format("{:.10f},", t) : "", force, tip);
    });
  };
  expect("a counter and a time", ",time,F,Tip\n" + counted("", true),
         {"F:excitation:force:N", "Tip:response:acceleration:g"});
  expect("a quoted counter", "\"\",\"t\",\"F\",\"Tip\"\n" + counted("\"", true),
         {"F:excitation:force:N", "Tip:response:acceleration:g"});
  // A counter alone is no time in seconds.
  const std::filesystem::path alone = write("a.csv", ",F,Tip\n" + counted("", false));
  EXPECT_TRUE(inspect_file(alone).time.empty());
  ImportOptions options;
  options.files = {alone};
  options.kind = "free_decay";
  options.channels = {"Tip:response:acceleration:g"};
  options.time = "column1";
  EXPECT_TRUE(contains(refusal([&] { import_files(options); }), "counts rows"));
  options.time = "column1:ms";
  EXPECT_NEAR(import_files(options).samples.at(0).sample_rate_hz, 1000, 1e-6);
}

TEST_F(InstrumentFiles, GroupedThousandsNameTheOptionThatReadsThem) {
  ImportOptions options;
  options.files = {write("a.csv", "t;F [N]\n0,0;1.154,5\n0,5;2,0\n1,0;2,0\n")};
  options.kind = "free_decay";
  options.channels = {"F [N]:response"};
  EXPECT_TRUE(contains(refusal([&] { import_files(options); }), "--decimal-mark ,"));
  options.decimal_mark = ",";
  EXPECT_EQ(import_files(options).samples.at(0).channels[0], (std::vector<double>{1154.5, 2, 2}));
}

// Runs of one file are records: elements of a struct array, and repeats of the degrees of freedom of a UFF file.
TEST_F(InstrumentFiles, RunsOfOneFileAreRecords) {
  {
    MatWriter writer(folder_ / "runs.mat");
    std::vector<matvar_t*> fields;
    for (const double run : {1.0, 2.0, 3.0}) {
      fields.push_back(MatWriter::column("t", {0, 0.5, 1}));
      fields.push_back(MatWriter::column("tip", {run, 2 * run, 3}));
    }
    writer.add(MatWriter::structure("run", 3, {"t", "tip"}, fields));
  }
  ImportOptions options;
  options.files = {folder_ / "runs.mat"};
  options.kind = "free_decay";
  options.time = "run(*).t";
  options.channels = {"tip=run(*).tip:response:acceleration:g"};
  const ImportedFiles runs = import_files(options);
  ASSERT_EQ(runs.samples.size(), 3U);
  EXPECT_EQ(runs.sources, (std::vector<std::filesystem::path>(3, folder_ / "runs.mat")));
  EXPECT_NEAR(runs.samples[2].channels[0][1], 6 * 9.80665, 1e-12);
  EXPECT_TRUE(runs.left_out.empty());
  EXPECT_EQ(runs.converted.size(), 1U);

  std::vector<UffFunction> functions;
  for (const double run : {1.0, 2.0, 3.0})
    for (const int node : {1, 2}) {
      UffFunction& function = functions.emplace_back();
      function.id_lines.fill("NONE");
      function.id_lines[0] = node == 1 ? "hammer" : "tip";
      function.response = {"NONE", node, 3};
      function.rate = 1024;
      function.abscissa.data_type = 17;
      function.numerator.data_type = node == 1 ? 13 : 12;
      function.real = {run, run * node, 0};
      function.count = 3;
    }
  options.files = {write("runs.uff", uff_text(functions, UffEncoding::little_endian))};
  options.time = "";
  options.channels = {"hammer:excitation:force:N", "tip:response:acceleration:m/s^2"};
  EXPECT_EQ(count_segments(options.files[0]), 3U);
  const ImportedFiles repeats = import_files(options);
  ASSERT_EQ(repeats.samples.size(), 3U);
  EXPECT_EQ(repeats.samples[2].channels, (std::vector<std::vector<double>>{{3, 3, 0}, {3, 6, 0}}));
  // Without a place of measurement they may be as many channels as well.
  for (UffFunction& function : functions) function.response.node = 0;
  EXPECT_EQ(count_segments(write("runs.uff", uff_text(functions, UffEncoding::little_endian))), 1U);
}

TEST_F(InstrumentFiles, WhatIsNotReadSaysWhatToDo) {
  const std::string zeros(700, '\0');
  const auto zip = [&](const std::string& first) { return "PK\x03\x04" + zeros.substr(0, 26) + first + zeros; };
  const struct {
    std::string name, bytes, is, way;
  } files[] = {{"a.csv.gz", "\x1f\x8b" + zeros, "gzip", "gunzip a.csv.gz"},
               {"a.xlsx", zip("[Content_Types].xml"), "Excel", "CSV"},
               {"a.ods", zip("mimetypeapplication/vnd.oasis.opendocument.spreadsheet"), "OpenDocument", "CSV"},
               {"a.npz", zip("t.npy"), "NumPy archive", "savemat('a.mat', dict(numpy.load('a.npz')))"},
               {"a.npy", "\x93NUMPY\x01" + zeros, "NumPy array", "numpy.load('a.npy')"},
               {"a.xls", "\xd0\xcf\x11\xe0" + zeros, "Excel", "CSV"},
               {"a.parquet", "PAR1" + zeros, "Parquet", "read_parquet('a.parquet')"},
               {"a.feather", "ARROW1" + zeros, "Feather", "to_csv('a.csv'"},
               {"a.mf4", "MDF     4.10" + zeros, "MDF", "asammdf"},
               {"a.tdms", "TDSm" + zeros, "TDMS", "nptdms"},
               {"a.tdm", "<?xml version=\"1.0\"?>\n<usi:tdm version=\"1.0\">\n", "DIAdem", "LVM"},
               {"a.svd", "P" + zeros, "Polytec", "UFF"},
               {"a.dat", "|CF,2,1,1;" + zeros, "FAMOS", "CSV"},
               {"a.mseed", "000001D STA  " + zeros, "miniSEED", "obspy"},
               {"a.json", "{\"t\": [0, 1], \"a\": [1, 2]}", "JSON", "pandas"},
               {"b.json", "[{\"t\": 0, \"a\": 1}]", "JSON", "pandas"}};
  for (const auto& file : files) {
    const std::string said = refusal([&] { read_data_file(write(file.name, file.bytes)); });
    EXPECT_TRUE(contains(said, file.is) && contains(said, "not read; ") && contains(said, file.way)) << file.name;
  }
  {
    const hid_t record = H5Tcreate(H5T_COMPOUND, 16);
    H5Tinsert(record, "t", 0, H5T_IEEE_F64LE);
    H5Tinsert(record, "tip", 8, H5T_IEEE_F64LE);
    Hdf5Writer(folder_ / "a.h5").add("log", {4}, {}, {.type = record, .unwritten = true});
    H5Tclose(record);
  }
  const DataFile table = read_data_file(folder_ / "a.h5");
  ASSERT_EQ(table.variables.size(), 1U);
  EXPECT_TRUE(contains(table.variables[0].fault, "table of records"));
}

// A timetable: its element names class and object, and its numbers stand in one without a name.
TEST_F(InstrumentFiles, ObjectsOfMatlabSayWhatToDo) {
  const auto word = [](std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
    return bytes;
  };
  const auto element = [&](std::uint32_t type, const std::string& content) {
    return word(type) + word(static_cast<std::uint32_t>(content.size())) + content +
           std::string((8 - content.size() % 8) % 8, '\0');
  };
  const auto matrix = [&](std::uint32_t array_class, const std::string& name, std::uint32_t length,
                          const std::string& data) {
    return element(
        14, element(6, word(array_class) + word(0)) + element(5, word(length) + word(1)) + element(1, name) + data);
  };
  const std::string reference = matrix(13, "", 2, element(6, word(0xdd000000) + word(2)));
  const std::string object = element(14, element(6, word(17) + word(0)) + element(1, "TT") + element(1, "MCOS") +
                                             element(1, "timetable") + reference);
  std::string header = "MATLAB 5.0 MAT-file";
  header.resize(124, ' ');
  header += std::string("\x00\x01IM", 4);
  const DataFile data =
      read_data_file(write("a.mat", header + object + matrix(9, "", 16, element(2, std::string(16, '\1')))));
  ASSERT_EQ(data.variables.size(), 1U);
  EXPECT_TRUE(contains(data.variables[0].fault, "timetable2table"));
}

}  // namespace
}  // namespace secular
