#include <cmath>
#include <cstdint>
#include <limits>

#include "measure/data/inspection.hpp"
#include "measure/formats/data_file.hpp"
#include "measure/formats/hdf5_file.hpp"
#include "measure/formats/stored_numbers.hpp"
#include "tests/campaign/hdf5_writer.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/mat_writer.hpp"
#include "tests/campaign/mutation.hpp"
#include "tests/campaign/variable_names.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<double>;

class Mat73 : public TemporaryFolder {
 protected:
  fs::path path() const { return folder_ / "a.mat"; }
};

// An array of structures, arr(1).x and arr(2).x, and cells c{1} and c{2}.
void add_structures_and_cells(MatWriter& writer) {
  writer.add(MatWriter::structure("arr", 2, {"x"}, {MatWriter::row("", {6, 7}), MatWriter::column("", {8, 9})}));
  std::size_t shape[2] = {1, 2};
  matvar_t* cells[2] = {MatWriter::row("", {1, 2}), MatWriter::row("", {3, 4, 5})};
  writer.add(Mat_VarCreate("c", MAT_C_CELL, MAT_T_CELL, 2, shape, cells, 0));
}

TEST_F(Mat73, ListsAndReadsNumericClasses) {
  for (const bool compressed : {false, true}) {
    {
      MatWriter writer(path(), MAT_FT_MAT73);
      writer.add(MatWriter::column("d", {0.1, -2, 3e300}), compressed);
      writer.add(MatWriter::array<float>("s", MAT_C_SINGLE, MAT_T_SINGLE, 1, 3, {0.5f, -2, 3}), compressed);
      writer.add(MatWriter::array<std::int8_t>("i8", MAT_C_INT8, MAT_T_INT8, 1, 3, {-128, 0, 127}), compressed);
      writer.add(MatWriter::array<std::uint16_t>("u16", MAT_C_UINT16, MAT_T_UINT16, 1, 2, {0, 65535}), compressed);
      writer.add(MatWriter::array<std::int64_t>("i64", MAT_C_INT64, MAT_T_INT64, 1, 2, {-5, 1LL << 40}),
                 compressed);
      writer.add(MatWriter::array<double>("m", MAT_C_DOUBLE, MAT_T_DOUBLE, 3, 2, {1, 2, 3, 4, 5, 6}), compressed);
      writer.add(MatWriter::array<double>("none", MAT_C_DOUBLE, MAT_T_DOUBLE, 0, 0, {}));
      writer.add(MatWriter::text("note", "second run"));
      writer.add_sparse_identity("selection", 4);
    }
    const DataFile data = read_data_file(path());
    EXPECT_EQ(data.format, "MAT v7.3");
    EXPECT_EQ(data.names(), "d, i64, i8, m(:,1), m(:,2), none, s, u16");
    EXPECT_EQ(data.vector("d").values, (Numbers{0.1, -2, 3e300}));
    EXPECT_EQ(data.vector("d").shape, (std::vector<std::size_t>{3, 1}));
    EXPECT_EQ(data.vector("s").values, (Numbers{0.5, -2, 3}));
    EXPECT_EQ(data.vector("s").shape, (std::vector<std::size_t>{1, 3}));
    EXPECT_EQ(data.vector("s").type, "single");
    EXPECT_EQ(data.vector("i8").values, (Numbers{-128, 0, 127}));
    EXPECT_EQ(data.vector("u16").values, (Numbers{0, 65535}));
    EXPECT_EQ(data.vector("i64").values, (Numbers{-5, 1099511627776.0}));
    EXPECT_EQ(data.vector("i64").type, "int64");
    EXPECT_TRUE(contains(refusal([&] { data.vector("m"); }), "variable m: is a matrix"));
    EXPECT_TRUE(contains(refusal([&] { data.vector("none"); }), "is empty"));
    EXPECT_EQ(data.variables[5].type, "double");
  }
}

TEST_F(Mat73, NestedStructsAndCellsHavePaths) {
  {
    MatWriter writer(path(), MAT_FT_MAT73);
    writer.add(MatWriter::structure(
        "run", 1, {"deep", "x"},
        {MatWriter::structure("", 1, {"y"}, {MatWriter::row("", {1, 2, 3})}), MatWriter::column("", {4, 5, 6})}));
    add_structures_and_cells(writer);
  }
  EXPECT_EQ(data_variable_names(path()),
            (std::vector<std::string>{"arr(1).x", "arr(2).x", "c{1}", "c{2}", "run.deep.y", "run.x"}));
  const DataFile data = read_data_file(path(), {"run.deep.y", "arr(2).x", "c{2}"});
  EXPECT_EQ(data.vector("run.deep.y").values, (Numbers{1, 2, 3}));
  EXPECT_EQ(data.vector("arr(2).x").values, (Numbers{8, 9}));
  EXPECT_EQ(data.vector("c{2}").values, (Numbers{3, 4, 5}));
  EXPECT_TRUE(data.vector("run.x").values.empty());
}

TEST_F(Mat73, ComplexNumbersAreNoChannel) {
  {
    MatWriter writer(path(), MAT_FT_MAT73);
    double parts[2][2] = {{1, 2}, {3, 4}};
    mat_complex_split_t split{parts[0], parts[1]};
    std::size_t shape[2] = {2, 1};
    writer.add(Mat_VarCreate("z", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, shape, &split, MAT_F_COMPLEX));
  }
  EXPECT_TRUE(contains(refusal([&] { read_data_file(path()).vector("z"); }), "variable z: is complex"));
}

TEST_F(Mat73, IsImported) {
  {
    MatWriter writer(path(), MAT_FT_MAT73);
    writer.add(MatWriter::structure("run", 1, {"time", "x"},
                                    {MatWriter::column("", {0, 0.5, 1}), MatWriter::row("", {1, 2, 3})}));
  }
  ImportOptions options;
  options.files = {path()};
  options.kind = "free_decay";
  options.time = "run.time";
  options.channels = {"tip=run.x:response:angle:rad"};
  const ImportedFiles imported = import_files(options);
  EXPECT_EQ(imported.campaign.sample_rate_hz, 2);
  EXPECT_EQ(imported.samples[0].channels[0], (Numbers{1, 2, 3}));
  EXPECT_EQ(inspect_file(path()).time, "run.time");
}

class Hdf5 : public TemporaryFolder {
 protected:
  fs::path path() const { return folder_ / "a.h5"; }
};

Numbers sine(std::size_t count) {
  Numbers values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = std::round(1000 * std::sin(0.01 * static_cast<double>(i)));
  return values;
}

TEST_F(Hdf5, EveryStorageIsRead) {
  for (const H5F_libver_t version : {H5F_LIBVER_EARLIEST, H5F_LIBVER_V18}) {
    const Numbers values = sine(5000), few = sine(20);
    {
      Hdf5Writer writer(path(), version);
      writer.add("contiguous", {5000}, values);
      writer.add("run/a/big_endian", {5000}, values, {H5T_IEEE_F64BE});
      writer.add("single", {5000}, values, {H5T_IEEE_F32LE});
      writer.add("int16_be", {5000}, values, {H5T_STD_I16BE});
      writer.add("int32", {5000, 1}, values, {H5T_STD_I32LE, {64, 8}, true, true, true});
      writer.add("more/row", {1, 5000}, values, {H5T_IEEE_F64LE, {1, 100}});
      writer.add("more/deflated", {5000}, values, {H5T_IEEE_F64LE, {512}, true});
      writer.add("more/compact", {20}, few, {H5T_IEEE_F64LE, {}, false, false, false, true});
      writer.add("more/matrix", {4, 5}, few);
      writer.add("more/scalar", {}, {7});
      writer.add_text("note", "second run");
    }
    const DataFile data = read_data_file(path());
    EXPECT_EQ(data.format, "HDF5");
    EXPECT_EQ(data.variables.size(), 13u);
    for (const char* const name :
         {"contiguous", "run.a.big_endian", "single", "int16_be", "int32", "more.row", "more.deflated"})
      EXPECT_EQ(data.vector(name).values, values) << name;
    EXPECT_EQ(data.vector("more.compact").values, few);
    EXPECT_EQ(data.vector("more.scalar").values, Numbers{7});
    EXPECT_EQ(data.vector("int32").shape, (std::vector<std::size_t>{5000, 1}));
    EXPECT_TRUE(contains(refusal([&] { data.vector("more.matrix"); }), "is a matrix"));
  }
}

// A single chunk, chunks behind each other, fixed and extensible arrays, in pages and not; the library chooses.
TEST_F(Hdf5, EveryLaterIndexOfChunksIsRead) {
  const hid_t number = H5T_IEEE_F64LE, whole = H5T_STD_I16LE;
  const Numbers values = sine(5000);
  {
    Hdf5Writer writer(path(), H5F_LIBVER_LATEST);
    for (const bool filtered : {false, true}) {
      const std::string group = filtered ? "filtered/" : "plain/";
      const auto form = [&](hid_t type, std::vector<hsize_t> chunk, bool bounded, bool early = false) {
        return Hdf5Writer::Form{type, std::move(chunk), filtered, filtered, filtered, false, false, bounded, early};
      };
      writer.add(group + "single", {5000}, values, form(number, {5000}, true));
      writer.add(group + "behind", {5000}, values, form(number, {512}, true, true));
      writer.add(group + "fixed", {5000}, values, form(number, {512}, true));
      writer.add(group + "fixed_row", {1, 5000}, values, form(number, {1, 100}, true));
      writer.add(group + "fixed_pages", {5000}, values, form(whole, {2}, true));
      for (const hsize_t chunk : {5000u, 1000u, 100u, 9u, 2u})
        writer.add(group + "extensible" + std::to_string(chunk), {5000}, values, form(number, {chunk}, false));
    }
    writer.add("empty", {100}, {}, {number, {10}, false, false, false, false, true});
  }
  const DataFile data = read_data_file(path());
  ASSERT_EQ(data.variables.size(), 21u);
  for (const DataVariable& variable : data.variables)
    if (variable.name != "empty") {
      EXPECT_EQ(data.vector(variable.name).values, values) << variable.name;
    }
  EXPECT_TRUE(contains(refusal([&] { data.vector("empty"); }), "never written"));
}

TEST_F(Hdf5, ManyMembersNeedSeveralNodes) {
  {
    Hdf5Writer writer(path());
    for (int i = 0; i < 300; ++i) writer.add("channel " + std::to_string(i), {2}, {1.0 * i, 2});
  }
  const DataFile data = read_data_file(path());
  ASSERT_EQ(data.variables.size(), 300u);
  EXPECT_EQ(data.vector("channel 299").values, (Numbers{299, 2}));
}

TEST_F(Hdf5, WhatIsNotReadSaysSo) {
  {
    Hdf5Writer writer(path(), H5F_LIBVER_LATEST);
    writer.add("new", {100, 1}, sine(100), {H5T_IEEE_F64LE, {10, 1}});
    writer.add("long", {100000, 1}, Numbers(100000), {H5T_IEEE_F64LE, {10000, 1}, true});  // longer than the file
    writer.add("old", {100}, sine(100));
  }
  EXPECT_EQ(read_data_file(path()).vector("old").values, sine(100));
  EXPECT_TRUE(contains(refusal([&] { read_data_file(path()).vector("new"); }), "in a form that is not read"));
  { Hdf5Writer(path()).add("a", {100}, sine(100), {H5T_IEEE_F64LE, {10}, false, false, false, false, true}); }
  EXPECT_TRUE(contains(refusal([&] { read_data_file(path()).vector("a"); }), "never written"));
  EXPECT_TRUE(contains(refusal([&] { read_hdf5(write("b.h5", "")); }), "is not an HDF5 file"));
}

class DamagedHdf5 : public Mutation {
 protected:
  void use(const std::string& name) const {
    inspect_file(folder_ / name);
    for (const DataVariable& variable : read_data_file(folder_ / name).variables) {
      std::size_t count = variable.fault.empty() ? 1 : 0;
      for (const std::size_t length : variable.shape) count *= count == 0 ? 1 : length;
      ASSERT_EQ(variable.values.size(), count) << variable.name;
    }
  }
  void damage(const std::string& name, int rounds) {
    const std::string valid = read(name);
    run(name, valid, rounds, [&] { use(name); });
    EXPECT_GT(accepted_, 50);
  }
  void refuse_every_shorter(const std::string& name) {
    const std::string valid = read(name);
    for (std::size_t length = 0; length < valid.size(); length += length < 2000 ? 1 : 37) {
      write(name, valid.substr(0, length));
      EXPECT_THROW(use(name), InputError) << length << " of " << valid.size();
    }
  }
};

void write_arrays(const fs::path& path) {
  Hdf5Writer writer(path, H5F_LIBVER_LATEST);
  writer.add("single", {50}, sine(50), {H5T_STD_I16LE, {50}, true, true, true, false, false, true});
  writer.add("fixed", {50}, sine(50), {H5T_STD_I16LE, {16}, true, true, true, false, false, true});
  writer.add("extensible", {60}, sine(60), {H5T_STD_I16LE, {1}});
}

void write_plain(const fs::path& path, H5F_libver_t version) {
  Hdf5Writer writer(path, version);
  writer.add("t", {50}, sine(50));
  writer.add("run/a", {50}, sine(50), {H5T_STD_I32LE, {16}, true, true, true});
  writer.add("run/b", {50}, sine(50), {H5T_STD_I16LE, {16}});
}

TEST_F(DamagedHdf5, Mat73) {
  {
    MatWriter writer(folder_ / "a.mat", MAT_FT_MAT73);
    writer.add(MatWriter::column("t", sine(50)), true);
    writer.add(MatWriter::structure("run", 1, {"a"}, {MatWriter::row("", {1, 2, 3})}));
    add_structures_and_cells(writer);
  }
  refuse_every_shorter("a.mat");
  {
    MatWriter writer(folder_ / "b.mat", MAT_FT_MAT73);
    writer.add(MatWriter::column("t", sine(50)), true);
    writer.add(MatWriter::structure("run", 1, {"a"}, {MatWriter::row("", {1, 2, 3})}));
  }
  damage("b.mat", 4000);
}

TEST_F(DamagedHdf5, Plain) {
  write_plain(folder_ / "a.h5", H5F_LIBVER_EARLIEST);
  damage("a.h5", 4000);
}

TEST_F(DamagedHdf5, PlainOfVersion18) {
  write_plain(folder_ / "a.h5", H5F_LIBVER_V18);
  damage("a.h5", 4000);
}

TEST_F(DamagedHdf5, ArraysOfChunks) {
  write_arrays(folder_ / "a.h5");
  refuse_every_shorter("a.h5");
  write_arrays(folder_ / "a.h5");
  damage("a.h5", 1000);
}

// The structure is a small part of a file: every byte of it is set to what may mislead.
TEST_F(DamagedHdf5, EveryByteOfTheStructure) {
  for (const H5F_libver_t version : {H5F_LIBVER_EARLIEST, H5F_LIBVER_V18}) {
    write_plain(folder_ / "a.h5", version);
    const std::string valid = read("a.h5");
    for (std::size_t at = 8; at < valid.size(); ++at) {
      if (valid[at] == 0 && at % 7 != 0) continue;
      for (const int value : {0x00, 0x01, 0x7F, 0xFF}) {
        std::string damaged = valid;
        damaged[at] = static_cast<char>(value);
        write("a.h5", damaged);
        try {
          use("a.h5");
        } catch (const InputError&) {
        }
      }
    }
  }
}

TEST_F(Mat73, ScaleOffsetAndUnitOfAttributesAreApplied) {
  for (const H5F_libver_t version : {H5F_LIBVER_EARLIEST, H5F_LIBVER_V18, H5F_LIBVER_LATEST})
    for (const std::size_t others :
         {std::size_t{0}, std::size_t{12}}) {  // many attributes stand outside of the header
      const fs::path file = folder_ / "a.h5";
      {
        Hdf5Writer writer(file, version);
        Hdf5Writer::Form counts;
        counts.type = H5T_STD_I16BE;
        for (const char* set : {"t", "x", "y", "z"}) writer.add(set, {3}, {0, 2, -4}, counts);
        for (std::size_t i = 0; i < others; ++i)
          for (const char* set : {"t", "x"}) writer.add_number(set, "other" + std::to_string(i), 7);
        writer.add_unit("t", "units", "milliseconds since 2020-01-01", true);
        writer.add_number("x", "scale_factor", 0.5, {1});
        writer.add_number("x", "add_offset", 3);
        writer.add_unit("x", "units", "g", others == 0);
        writer.add_unit("y", "units", "counts", true);
        writer.add_number("z", "scale_factor", 0.5, {2});
      }
      DataFile data = read_data_file(file);
      EXPECT_EQ(data.vector("x").values, (Numbers{3 * 9.80665, 4 * 9.80665, 1 * 9.80665}));
      EXPECT_EQ(data.vector("x").unit, "m/s^2");
      EXPECT_EQ(data.vector("x").stated_unit, "g");
      EXPECT_EQ(data.vector("y").values, (Numbers{0, 2, -4}));
      EXPECT_TRUE(data.vector("y").unit.empty());
      EXPECT_TRUE(contains(refusal([&] { data.vector("z"); }), "scale_factor that is not one number"));
      convert_to_seconds(data.vector("t"), data.file);
      EXPECT_EQ(data.vector("t").values, (Numbers{0, 0.002, -0.004}));
    }
}

}  // namespace
}  // namespace secular
