// Matrices with a channel a column, data sets of several names, and data sets that were written in part.
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "measure/data/inspection.hpp"
#include "measure/formats/data_file.hpp"
#include "tests/campaign/hdf5_writer.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/mat_writer.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/variable_names.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<double>;
using Names = std::vector<std::string>;

// Channel c at sample i, in whole numbers of two bytes.
double number(std::size_t i, std::size_t c) {
  return std::round(100 * std::sin(0.1 * static_cast<double>(i + 7 * c))) + 1000 * static_cast<double>(c);
}

Numbers channel(std::size_t samples, std::size_t c, std::size_t first = 0) {
  Numbers values(samples);
  for (std::size_t i = 0; i < samples; ++i) values[i] = number(first + i, c);
  return values;
}

// Of `samples` x `channels`, neighbours in a row (as C has it) or in a column (as MATLAB has it).
Numbers matrix(std::size_t samples, std::size_t channels, bool by_rows) {
  Numbers values(samples * channels);
  for (std::size_t i = 0; i < samples; ++i)
    for (std::size_t c = 0; c < channels; ++c) values[by_rows ? i * channels + c : c * samples + i] = number(i, c);
  return values;
}

class MatrixVariables : public TemporaryFolder {
 protected:
  fs::path path(const std::string& name = "a") const { return folder_ / name; }
  static void expect_columns(const fs::path& file, const std::string& name, std::size_t samples,
                             std::size_t columns) {
    const DataFile all = read_data_file(file);
    for (std::size_t c = 0; c < columns; ++c) {
      const std::string column = name + "(:," + std::to_string(c + 1) + ")";
      EXPECT_EQ(all.vector(column).values, channel(samples, c)) << file << column;
      EXPECT_EQ(read_data_file(file, {column}).vector(column).values, channel(samples, c)) << column;
      const DataFile first = read_data_file(file, {}, MissingNumbers::refuse, 5);
      EXPECT_EQ(first.vector(column).values, channel(5, c)) << column;
      EXPECT_TRUE(first.partial);
    }
    EXPECT_TRUE(contains(refusal([&] { all.vector(name); }),
                         "variable " + name + ": is a matrix, whose columns are " + name + "(:,1) to " + name +
                             "(:," + std::to_string(columns) + ")"));
  }
};

TEST_F(MatrixVariables, OfMatFilesAreChannels) {
  for (const mat_ft version : {MAT_FT_MAT5, MAT_FT_MAT73})
    for (const bool compressed : {false, true}) {
      {
        MatWriter writer(path(), version);
        writer.add(MatWriter::array("data", MAT_C_DOUBLE, MAT_T_DOUBLE, 40, 3, matrix(40, 3, false)), compressed);
        const Numbers few = matrix(50, 2, false);
        writer.add(MatWriter::structure("run", 1, {"y", "t"},
                                        {MatWriter::array("", MAT_C_INT16, MAT_T_INT16, 50, 2,
                                                          std::vector<std::int16_t>(few.begin(), few.end())),
                                         MatWriter::row("", channel(50, 0))}),
                   compressed);
        writer.add(MatWriter::array("wide", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, 30, matrix(30, 2, true)), compressed);
      }
      expect_columns(path(), "data", 40, 3);
      expect_columns(path(), "run.y", 50, 2);
      const DataFile data = read_data_file(path());
      EXPECT_EQ(data.vector("wide(2,:)").values, channel(30, 1));
      EXPECT_EQ(data.vector("wide(1,:)").values, channel(30, 0));
      EXPECT_EQ(data.vector("run.t").values, channel(50, 0));
    }
}

TEST_F(MatrixVariables, OfHdf5FilesAreChannels) {
  const hid_t type = H5T_STD_I16BE;
  for (const H5F_libver_t version : {H5F_LIBVER_EARLIEST, H5F_LIBVER_V18, H5F_LIBVER_LATEST}) {
    {
      Hdf5Writer writer(path(), version);
      const Numbers values = matrix(60, 3, true);
      const auto form = [&](std::vector<hsize_t> chunk, bool filtered) {
        return Hdf5Writer::Form{type, std::move(chunk), filtered, filtered, filtered, false, false, true};
      };
      writer.add("plain", {60, 3}, values, {type});
      writer.add("run/tall", {60, 3}, values, form({7, 3}, true));
      writer.add("run/tiles", {60, 3}, values, form({16, 2}, true));
      writer.add("run/dots", {60, 3}, values, form({1, 1}, false));
      writer.add("run/one", {60, 3}, values, form({60, 3}, false));
      writer.add("wide", {3, 60}, matrix(60, 3, false), form({1, 11}, true));
    }
    for (const char* const name : {"plain", "run.tall", "run.tiles", "run.dots", "run.one"})
      expect_columns(path(), name, 60, 3);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(read_data_file(path()).vector("wide(" + std::to_string(c + 1) + ",:)").values, channel(60, c));
  }
}

TEST_F(MatrixVariables, AreImportedByTheirColumns) {
  {
    Hdf5Writer writer(path());
    Numbers values = matrix(20, 3, true);
    for (std::size_t i = 0; i < 20; ++i) values[3 * i] = 0.25 * static_cast<double>(i);
    writer.add("scan", {20, 3}, values);
    writer.add_number("scan", "scale_factor", 0.5);
  }
  ImportOptions options;
  options.files = {path()};
  options.kind = "free_decay";
  options.time = "scan(:,1)";
  options.channels = {"tip=scan(:,3):response:angle:rad", "mid=scan(:,2):response:displacement:mm"};
  const ImportedFiles imported = import_files(options);
  EXPECT_EQ(imported.campaign.sample_rate_hz, 8);  // the times are halved, too
  EXPECT_EQ(imported.samples[0].channels[0][3], 0.5 * number(3, 2));
  EXPECT_EQ(imported.samples[0].channels[1][3], 0.5e-3 * number(3, 1));
  EXPECT_EQ(inspect_file(path()).time, "scan(:,1)");
  EXPECT_TRUE(inspect_file(path()).faults.empty());
  options.time = "scan";
  EXPECT_TRUE(contains(refusal([&] { import_files(options); }), "columns are scan(:,1) to scan(:,3)"));
  options.time = "scan(:,1)";
  options.channels = {"tip=scan:response:angle:rad"};
  EXPECT_TRUE(contains(refusal([&] { import_files(options); }), "columns are scan(:,1) to scan(:,3)"));
  options.channels = {"tip=scan(:,4):response:angle:rad"};
  EXPECT_TRUE(contains(refusal([&] { import_files(options); }), "no variable 'scan(:,4)'"));
}

TEST_F(MatrixVariables, WhatIsNoListOfChannelsSaysSo) {
  {
    Hdf5Writer writer(path());
    writer.add("cube", {4, 3, 2}, Numbers(24));
    writer.add("picture", {1025, 1025}, Numbers(1025 * 1025));
  }
  const DataFile data = read_data_file(path());
  EXPECT_TRUE(contains(refusal([&] { data.vector("cube"); }), "is an array of 3 dimensions"));
  EXPECT_TRUE(contains(refusal([&] { data.vector("picture"); }), "is a matrix of more than 1024"));
}

TEST_F(MatrixVariables, DataSetsOfSeveralNamesAreRead) {
  for (const H5F_libver_t version : {H5F_LIBVER_EARLIEST, H5F_LIBVER_V18, H5F_LIBVER_LATEST}) {
    {
      Hdf5Writer writer(path(), version);
      writer.add("run/x", {3000}, channel(3000, 1));
      writer.add("run/m", {30, 2}, matrix(30, 2, true));
      for (const char* const name : {"x again", "run/also", "third"}) writer.add_link("run/x", name);
      writer.add_link("run", "latest");
      writer.add_link("/", "run/root");  // a group that holds itself
      writer.add_soft_link("/run/x", "soft");
      writer.add_soft_link("m", "run/soft m");
      writer.add_soft_link("/run", "soft run");
      writer.add_soft_link("/nowhere", "dangling");
    }
    const DataFile data = read_data_file(path());
    for (const char* const name : {"run.x", "x again", "run.also", "third", "latest.x", "soft", "soft run.x"}) {
      EXPECT_EQ(data.vector(name).values, channel(3000, 1)) << name;
      EXPECT_EQ(read_data_file(path(), {name}).vector(name).values, channel(3000, 1)) << name;
    }
    for (const char* const name : {"run.m(:,2)", "run.soft m(:,2)", "latest.m(:,2)"})
      EXPECT_EQ(data.vector(name).values, channel(30, 1)) << name;
    EXPECT_TRUE(contains(refusal([&] { data.vector("dangling"); }), "has no numeric variable 'dangling'"));
    EXPECT_TRUE(inspect_file(path()).faults.empty());
  }
}

// A recorder that stopped: space for many samples, the first of which were written.
TEST_F(MatrixVariables, DataSetsWrittenInPartEndWhereTheyWereWritten) {
  for (const H5F_libver_t version : {H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST})
    for (const bool deflate : {false, true}) {
      {
        Hdf5Writer writer(path(), version);
        writer.add("t", {200}, channel(200, 0));
        writer.add_part("x", {1000000}, {.chunk = {100}, .deflate = deflate}, {0}, {200}, channel(200, 1));
        writer.add_part("m", {100000, 2}, {.chunk = {50, 2}, .deflate = deflate}, {0, 0}, {200, 2},
                        matrix(200, 2, true));
        writer.add_part("late", {1000}, {.chunk = {100}, .deflate = deflate}, {300}, {100}, channel(100, 1));
      }
      const DataFile data = read_data_file(path());
      EXPECT_EQ(data.vector("x").values, channel(200, 1));
      EXPECT_EQ(data.vector("x").shape, (std::vector<std::size_t>{200}));
      EXPECT_TRUE(contains(data.vector("x").type, "200 of 1000000 written"));
      EXPECT_EQ(data.vector("m(:,2)").values, channel(200, 1));
      EXPECT_TRUE(contains(refusal([&] { data.vector("late"); }), "never written"));
    }
}

// What was left out between is missing, not zero.
TEST_F(MatrixVariables, APartThatWasLeftOutIsMissing) {
  {
    Hdf5Writer writer(path());
    writer.add_part("x", {1000}, {.chunk = {100}}, {0}, {300}, channel(300, 1));
    writer.write_part("x", {400}, {100}, channel(100, 1, 400));
  }
  EXPECT_TRUE(
      contains(refusal([&] { read_data_file(path()); }), "variable x, element 301: is not a finite number"));
  const Numbers values = read_data_file(path(), {}, MissingNumbers::keep_as_nan).vector("x").values;
  ASSERT_EQ(values.size(), 500U);
  EXPECT_EQ(values[299], number(299, 1));
  EXPECT_TRUE(std::isnan(values[300]) && std::isnan(values[399]));
  EXPECT_EQ(values[499], number(499, 1));
}

// Dimensions as unsigned numbers, which libmatio passes over: in a plain variable, in a struct, in a compressed
// one.
TEST_F(MatrixVariables, UnsignedDimensionsOfMatFilesAreRead) {
  {
    MatWriter writer(path("plain"));
    writer.add(MatWriter::column("t", channel(40, 0)));
    writer.add(MatWriter::structure("run", 1, {"y"}, {MatWriter::row("", channel(40, 1))}));
    writer.add(MatWriter::array("m", MAT_C_DOUBLE, MAT_T_DOUBLE, 40, 2, matrix(40, 2, false)));
  }
  std::string text = read("plain");
  const std::string signed_one("\5\0\0\0\10\0\0\0", 8);
  int changed = 0;
  for (std::size_t at = text.find(signed_one); at != std::string::npos;
       at = text.find(signed_one, at + 1), ++changed)
    text[at] = 6;
  EXPECT_EQ(changed, 4);
  write("unsigned", text);
  // The same with its variables compressed one by one.
  std::string compressed = text.substr(0, 128);
  for (std::size_t at = 128; at < text.size();) {
    std::uint32_t size = 0;
    for (std::size_t i = 4; i-- > 0;) size = size << 8 | static_cast<unsigned char>(text[at + 4 + i]);
    std::string packed(compressBound(size + 8), '\0');
    uLongf length = packed.size();
    ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &length,
                       reinterpret_cast<const Bytef*>(text.data() + at), size + 8),
              Z_OK);
    compressed += std::string("\17\0\0\0", 4);
    for (std::size_t i = 0; i < 4; ++i) compressed += static_cast<char>(length >> (8 * i) & 0xff);
    compressed += packed.substr(0, length);
    at += size + 8;
  }
  write("compressed", compressed);
  for (const char* const name : {"plain", "unsigned", "compressed"}) {
    EXPECT_EQ(data_variable_names(path(name)), (Names{"t", "run.y", "m(:,1)", "m(:,2)"})) << name;
    const DataFile data = read_data_file(path(name));
    EXPECT_EQ(data.vector("t").values, channel(40, 0)) << name;
    EXPECT_EQ(data.vector("run.y").values, channel(40, 1)) << name;
    EXPECT_EQ(data.vector("m(:,2)").values, channel(40, 1)) << name;
  }
}

TEST_F(MatrixVariables, SharedFilesAreRead) {
  const fs::path faults = testing_support::source_folder() / "../shared/faults";
  if (!fs::exists(faults)) GTEST_SKIP() << "../shared/faults is not there";
  const DataFile plain = read_data_file(faults / "header_rows/d10_units_row.csv");
  const auto same = [&](const char* file, const std::string& variable, const char* column) {
    const Numbers read = read_data_file(faults / file).vector(variable).values, right = plain.vector(column).values;
    ASSERT_EQ(read.size(), right.size()) << file;
    for (std::size_t i = 0; i < read.size(); ++i) ASSERT_NEAR(read[i], right[i], 1e-6) << file << variable << i;
  };
  same("matrix_variables/d21b_matrix.mat", "data(:,1)", "t");
  same("matrix_variables/d21b_matrix.mat", "data(:,3)", "mid");
  same("matrix_variables/d21c_struct.mat", "run.y(:,2)", "mid");
  same("matrix_variables/d22b_matrix.h5", "signals(:,2)", "tip");
  same("mat_other_writers/d24_uint32_dims.mat", "t", "t");
  EXPECT_GT(read_data_file(faults / "robustness/hard_link.h5").variables.size(), 1U);
  EXPECT_EQ(read_data_file(faults / "robustness/partly_written.h5").vector("t").values.size(), 2000U);
  EXPECT_GE(read_data_file(faults / "robustness/partly_written.h5").vector("tip").values.size(), 2000U);
}

}  // namespace
}  // namespace secular
