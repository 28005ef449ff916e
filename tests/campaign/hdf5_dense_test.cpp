// Groups with more than a few members, as h5py with libver="latest" and netCDF-4 write them: links in a fractal
// heap with a version 2 B-tree as index.

#include <functional>

#include "measure/data/inspection.hpp"
#include "measure/formats/data_file.hpp"
#include "tests/campaign/hdf5_writer.hpp"
#include "tests/campaign/mutation.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<double>;

class DenseGroup : public Mutation {
 protected:
  fs::path path() const { return folder_ / "a.h5"; }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const DataVariable& variable : read_data_file(path()).variables) names.push_back(variable.name);
    return names;
  }

  // Changes what stands `offset` bytes behind the `occurrence`-th signature.
  std::string changed(const std::string& valid, const std::string& signature, std::size_t offset,
                      const std::string& value, std::size_t occurrence = 0) const {
    std::size_t at = valid.find(signature);
    for (; occurrence > 0; --occurrence) at = valid.find(signature, at + 1);
    EXPECT_NE(at, std::string::npos) << signature;
    std::string result = valid;
    return result.replace(at + offset, value.size(), value);
  }

  std::string refusal_of(const std::string& bytes) {
    write("b.h5", bytes);
    return refusal([&] { read_data_file(folder_ / "b.h5"); });
  }
};

std::string name_of(int i) {
  return "accelerometer " + std::to_string(i) + std::string(static_cast<std::size_t>(i % 23), 'x');
}

// The library's own count of links decides when a group becomes dense (more than 8).
TEST_F(DenseGroup, EveryMemberOfGroupsOfAllSizes) {
  for (const int count : {8, 9, 40, 46, 600, 3000}) {
    {
      Hdf5Writer writer(path(), H5F_LIBVER_V18);
      for (int i = 0; i < count; ++i) writer.add("run/" + name_of(i), {2}, {1.0 * i, 0.5});
    }
    const DataFile data = read_data_file(path());
    ASSERT_EQ(data.variables.size(), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
      ASSERT_EQ(data.vector("run." + name_of(i)).values, (Numbers{1.0 * i, 0.5})) << count;
  }
}

TEST_F(DenseGroup, MembersStandInOrderOfCreationElseOfNames) {
  for (const bool order : {false, true}) {
    {
      Hdf5Writer writer(path(), H5F_LIBVER_V18);
      writer.add_group("run", {order, false});
      for (int i = 0; i < 200; ++i) writer.add("run/" + std::to_string(1000 - 3 * i), {1}, {1.0 * i});
      for (int i = 0; i < 200; i += 2) writer.remove("run/" + std::to_string(1000 - 3 * i));
    }
    std::vector<std::string> expected;
    for (int i = 1; i < 200; i += 2) expected.push_back("run." + std::to_string(1000 - 3 * i));
    if (!order) std::sort(expected.begin(), expected.end());
    EXPECT_EQ(names(), expected);
  }
}

TEST_F(DenseGroup, InEachOther) {
  {
    Hdf5Writer writer(path(), H5F_LIBVER_V18);
    for (int a = 0; a < 12; ++a)
      for (int b = 0; b < 12; ++b)
        writer.add("a" + std::to_string(a) + "/b" + std::to_string(b) + "/x", {2}, {1.0 * a, 1.0 * b});
    for (int b = 0; b < 700; ++b) writer.add("a3/b3/" + std::to_string(b), {1}, {1.0 * b});
  }
  const DataFile data = read_data_file(path());
  EXPECT_EQ(data.variables.size(), 144u + 700u);
  EXPECT_EQ(data.vector("a11.b7.x").values, (Numbers{11, 7}));
  EXPECT_EQ(data.vector("a3.b3.699").values, Numbers{699});
}

TEST_F(DenseGroup, LinksThatLeadElsewhereAndNamesOfAnyLength) {
  const std::string name(3000, 'n'), longer(9000, 'm');  // the second is too long for the heap's blocks
  {
    Hdf5Writer writer(path(), H5F_LIBVER_V18);
    for (int i = 0; i < 20; ++i) writer.add_soft_link("/" + longer, "soft " + std::to_string(i));
    writer.add_soft_link(std::string(9000, 's'), "long soft");
    writer.add(longer, {2}, {1, 2});
    writer.add(name, {2}, {3, 4});
    for (int i = 0; i < 60; ++i) writer.add_link(name, std::to_string(i) + name);
  }
  const DataFile data = read_data_file(path());
  EXPECT_EQ(data.variables.size(), 82u);
  EXPECT_EQ(data.vector("soft 19").values, (Numbers{1, 2}));
  EXPECT_EQ(data.vector(longer).values, (Numbers{1, 2}));
  EXPECT_EQ(data.vector("59" + name).values, (Numbers{3, 4}));
}

TEST_F(DenseGroup, CompressedListOfMembersSaysSo) {
  {
    Hdf5Writer writer(path(), H5F_LIBVER_V18);
    writer.add_group("run", {false, true});
    for (int i = 0; i < 30; ++i) writer.add("run/" + name_of(i), {1}, {1.0 * i});
  }
  EXPECT_TRUE(
      contains(refusal([&] { read_data_file(path()); }), "run: is a group whose list of members is compressed"));
  {
    Hdf5Writer writer(path(), H5F_LIBVER_V18);
    writer.add_group("run", {false, true});
    for (int i = 0; i < 30; ++i) writer.add("run/" + name_of(i), {1}, {1.0 * i});
    writer.add("t", {1}, {2});
  }
  EXPECT_EQ(read_data_file(path()).vector("t").values, Numbers{2});
  EXPECT_TRUE(contains(refusal([&] { read_data_file(path()).vector("run"); }), "list of members is compressed"));
}

// 120 names of one data set: an index of two levels and an indirect block in few bytes.
void write_small(const fs::path& path) {
  Hdf5Writer writer(path, H5F_LIBVER_V18);
  writer.add("run/x", {2}, {1, 2});
  for (int i = 0; i < 120; ++i) writer.add_link("run/x", "run/channel " + std::to_string(i));
}

TEST_F(DenseGroup, EveryFaultOfTheStructureIsNamed) {
  write_small(path());
  const std::string valid = read("a.h5"), far(8, '\x7F'), nowhere(8, '\xFF'), zeros(8, '\0');
  ASSERT_EQ(names().size(), 121u);
  const auto expect = [&](const std::string& what, const std::string& bytes) {
    const std::string message = refusal_of(bytes);
    EXPECT_TRUE(contains(message, what)) << message;
  };
  const std::string byte_one(1, '\1');
  // Heap: signature, version, identifier, sizes, root.
  expect("heap of a group is missing", changed(valid, "FRHP", 0, "frhp"));
  expect("heap of a group is missing", changed(valid, "FRHP", 4, byte_one));
  expect("an unknown form", changed(valid, "FRHP", 5, std::string("\x09", 1)));
  for (const std::size_t field : {10u, 110u, 112u, 120u, 128u})
    expect("impossible sizes", changed(valid, "FRHP", field, std::string(4, '\0')));
  expect("impossible sizes", changed(valid, "FRHP", 110, std::string("\x03", 1)));
  expect("impossible sizes", changed(valid, "FRHP", 128, std::string("\x41", 1)));
  for (const std::string& address : {far, nowhere})
    expect("behind the end of the file", changed(valid, "FRHP", 132, address));
  expect("block of a group's heap is damaged", changed(valid, "FRHP", 132, zeros));
  expect("outside of its group's heap", changed(valid, "FRHP", 140, byte_one));
  expect("block of a group's heap is damaged", changed(valid, "FRHP", 140, std::string(2, '\0')));
  // Blocks: signature, version, whose they are, where in the heap.
  for (const std::string block : {"FHIB", "FHDB"})
    for (const std::size_t field : {0u, 4u, 5u, 13u})
      expect("block of a group's heap is damaged", changed(valid, block, field, std::string("\x33", 1)));
  for (const std::string& address : {far, nowhere})
    expect("behind the end of the file", changed(valid, "FHIB", 17, address));
  // Index: signature, version, kind, node, record, depth, root, numbers of records.
  expect("index of a group is missing", changed(valid, "BTHD", 0, "bthd"));
  expect("index of a group is missing", changed(valid, "BTHD", 4, byte_one));
  expect("records of another kind", changed(valid, "BTHD", 5, std::string("\6", 1)));
  expect("records of another kind", changed(valid, "BTHD", 10, std::string("\x0F", 1)));
  expect("impossible nodes", changed(valid, "BTHD", 6, std::string("\x14\0\0\0", 4)));
  expect("impossible nodes", changed(valid, "BTHD", 6, std::string("\x1D\0\0\0", 4)));
  expect("goes round in circles", changed(valid, "BTHD", 6, std::string(4, '\x7F')));
  expect("too deep", changed(valid, "BTHD", 12, std::string(2, '\xFF')));
  expect("index of a group is damaged", changed(valid, "BTHD", 12, std::string(2, '\0')));
  expect("behind the end of the file", changed(valid, "BTHD", 16, far));
  expect("more records than room", changed(valid, "BTHD", 24, std::string(2, '\xFF')));
  expect("other records than it says", changed(valid, "BTHD", 26, byte_one));
  expect("other records than it says", changed(valid, "BTHD", 26, nowhere));
  // Nodes: signature, version, kind, records, pointers.
  for (const std::string node : {"BTIN", "BTLF"})
    for (const std::size_t field : {0u, 4u, 5u})
      expect("index of a group is damaged", changed(valid, node, field, std::string("\x33", 1)));
  expect("unknown form", changed(valid, "BTLF", 10, std::string("\x40", 1)));
  expect("unknown form", changed(valid, "BTLF", 10, std::string("\x80", 1)));
  expect("too short for a link", changed(valid, "BTLF", 10, std::string("\x20", 1)));
  expect("long object of a group's heap is missing", changed(valid, "BTLF", 10, std::string("\x10", 1)));
  expect("outside of its group's heap", changed(valid, "BTLF", 11, std::string(4, '\x7F')));
  expect("outside of its block", changed(valid, "BTLF", 11, std::string(4, '\0')));
  expect("outside of its block", changed(valid, "BTLF", 15, std::string(2, '\x7F')));
  expect("longer than the space it stands in", changed(valid, "BTLF", 15, std::string("\x05\0", 2)));
  expect("longer than the space it stands in", changed(valid, "FHDB", 21, std::string(40, '\xFF')));
}

// A node that is its own child, a long name that all links share: much out of little.
TEST_F(DenseGroup, LoopsAndOverlapsEnd) {
  write_small(path());
  const std::string valid = read("a.h5");
  const std::size_t node = valid.find("BTIN"), leaf = valid.find("BTLF"), header = valid.find("BTHD");
  ASSERT_NE(node, std::string::npos);
  const auto number = [&](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(valid[at]));
  };
  const std::size_t records = number(header + 24);
  std::string round = valid;
  for (std::size_t child = 0; child <= records; ++child) {
    const std::size_t at = node + 6 + 11 * records + 9 * child;
    for (std::size_t byte = 0; byte < 8; ++byte) round[at + byte] = static_cast<char>(node >> (8 * byte) & 0xFF);
  }
  round[header + 12] = 16;  // as deep as is believed
  const std::string message = refusal_of(round);
  EXPECT_TRUE(contains(message, "round in circles") || contains(message, "more records than room") ||
              contains(message, "impossible nodes"))
      << message;
  std::string twice = valid;
  const std::size_t first = node + 6 + 11 * records;
  twice.replace(first + 9, 9, valid, first, 9);
  write("b.h5", twice);
  try {  // the same leaf again: as many records, or not as many as the index says
    read_data_file(folder_ / "b.h5");
  } catch (const InputError&) {
  }
  std::string overlapping = valid;
  const std::size_t last_leaf = valid.rfind("BTLF");
  for (const std::size_t at : {leaf, last_leaf})
    for (std::size_t record = 0; record < 20; ++record)
      overlapping.replace(at + 6 + 11 * record, 11, std::string("\0\0\0\0\0\x20\x01\0\0\0\x02", 11));
  EXPECT_THROW(
      {
        write("b.h5", overlapping);
        read_data_file(folder_ / "b.h5");
      },
      InputError);
}

TEST_F(DenseGroup, DamageAnywhere) {
  write_small(path());
  const std::string valid = read("a.h5");
  run("a.h5", valid, 500, [&] {
    inspect_file(path());
    read_data_file(path());
  });
  EXPECT_GT(accepted_, 50);
  for (std::size_t at = 8; at < valid.size(); ++at) {
    if (valid[at] == 0 || at % 3 != 0) continue;
    for (const int value : {0x00, 0xFF}) {
      std::string damaged = valid;
      damaged[at] = static_cast<char>(value);
      write("a.h5", damaged);
      try {
        read_data_file(path());
      } catch (const InputError&) {
      }
    }
  }
  for (std::size_t length = 0; length < valid.size(); length += 101) {
    write("a.h5", valid.substr(0, length));
    EXPECT_THROW(read_data_file(path()), InputError) << length;
  }
}

}  // namespace
}  // namespace secular
