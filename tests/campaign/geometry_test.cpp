// Points, lines and sensors of a structure: from universal files and campaign.toml, and as text.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "measure/data/campaign_text.hpp"
#include "measure/data/geometry_text.hpp"
#include "measure/data/held_campaign.hpp"
#include "measure/formats/uff_geometry.hpp"
#include "tests/campaign/imported_files.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/campaign/uff_write.hpp"

namespace secular {
namespace {

class GeometryFiles : public TemporaryFolder {
 protected:
  static std::string data_set(int number, const std::string& lines) {
    return fmt::format("    -1\n{:6}\n{}    -1\n", number, lines);
  }
  static std::string short_node(int label, double x, double y, double z) {
    return fmt::format("{:10}{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}\n", label, 0, 0, 11, x, y, z);
  }
  // A frame of four nodes and a trace line with the pen lifted once: 1-2-3, 3-4.
  static std::string frame() {
    return data_set(15, short_node(1, 0, 0, 0) + short_node(2, 0, 0, 0.25) + short_node(3, 0.5, 0, 0.25) +
                            short_node(14, 0.5, 0, -1.5e-3)) +
           data_set(82, fmt::format("{:10}{:10}{:10}\nframe\n{:10}{:10}{:10}{:10}{:10}{:10}\n", 1, 6, 7, 1, 2, 3, 0,
                                    3, 14));
  }
  static UffFunction channel(long long node, int direction) {
    UffFunction f;
    f.id_lines = {fmt::format("node {} along {}", node, direction), "", "", "", ""};
    f.response = {"", node, direction};
    f.rate = 100;
    f.abscissa.data_type = 17;
    f.numerator.data_type = 12;
    f.numerator.unit = "m/s^2";
    f.abscissa.unit = "s";
    f.real = std::vector<double>(64, 0.5);
    f.real[3] = direction;
    return f;
  }
};

TEST_F(GeometryFiles, NodesAndTraceLinesOfAUniversalFile) {
  const UffGeometry read = read_uff_geometry(write("frame.uff", frame()));
  ASSERT_EQ(read.nodes.size(), 4u);
  EXPECT_EQ(read.nodes[3].label, 14);
  EXPECT_EQ(read.nodes[3].at, (std::array<double, 3>{0.5, 0, -1.5e-3}));
  EXPECT_EQ(read.trace_lines, (std::vector<std::vector<long long>>{{1, 2, 3}, {3, 14}}));
  const std::string longer =
      data_set(2411, fmt::format("{:10}{:10}{:10}{:10}\n{:>25}{:>25}{:>25}\n", 7, 1, 1, 11,
                                 "1.0000000000000000D+00", "-2.5000000000000000D-01", "0.0000000000000000D+00"));
  const UffGeometry of_longer = read_uff_geometry(write("long.unv", longer));
  ASSERT_EQ(of_longer.nodes.size(), 1u);
  EXPECT_EQ(of_longer.nodes[0].at, (std::array<double, 3>{1, -0.25, 0}));
}

TEST_F(GeometryFiles, WhatIsNoNodeIsRefusedWithItsLine) {
  const auto path =
      write("bad.uff", data_set(15, short_node(1, 0, 0, 0) + "         2         0         0  oops\n"));
  EXPECT_TRUE(contains(refusal([&] { read_uff_geometry(path); }), "line 4"));
  const auto cut = write("cut.uff", data_set(2411, fmt::format("{:10}{:10}{:10}{:10}\n", 7, 1, 1, 11)));
  EXPECT_TRUE(contains(refusal([&] { read_uff_geometry(cut); }), "no coordinates"));
}

TEST_F(GeometryFiles, AnImportKnowsWhereItsChannelsAre) {
  ImportOptions options;
  options.files = {write("run.uff", frame() + uff_text({channel(2, -1), channel(14, 3)}, UffEncoding::ascii))};
  options.kind = "free_decay";
  options.channels = {"a=node 2 along -1:response", "b=node 14 along 3:response"};
  const ImportedFiles imported = import_files(options);
  ASSERT_TRUE(imported.campaign.geometry);
  const Geometry& geometry = *imported.campaign.geometry;
  ASSERT_EQ(geometry.points.size(), 4u);
  ASSERT_EQ(geometry.sensors.size(), 2u);
  EXPECT_EQ(geometry.sensors[0].channel, "a");
  EXPECT_EQ(geometry.points[geometry.sensors[0].point].name, "2");
  EXPECT_EQ(geometry.sensors[0].direction, (std::array<double, 3>{-1, 0, 0}));
  EXPECT_EQ(geometry.points[geometry.sensors[1].point].name, "14");
  EXPECT_EQ(geometry.lines.size(), 2u);

  // The same where the nodes are in a file of their own, and nothing where there are none.
  options.files = {write("samples.uff", uff_text({channel(2, -1), channel(14, 3)}, UffEncoding::ascii))};
  EXPECT_FALSE(import_files(options).campaign.geometry);
  options.geometry = write("nodes.uff", frame());
  EXPECT_EQ(geometry_text(*import_files(options).campaign.geometry), geometry_text(geometry));
  options.geometry = write("none.csv", "t,a\n0,1\n");
  EXPECT_TRUE(contains(refusal([&] { import_files(options); }), "--geometry"));
}

TEST(GeometryText, ReadingRestoresIt) {
  const std::string head =
      "schema = 1\nname = \"beam\"\nsample_rate_hz = 100.0\n\n[[channel]]\nname = \"tip\"\nrole = "
      "\"response\"\nquantity "
      "= \"acceleration\"\nunit = \"m/s^2\"\n";
  const std::string record = "\n[[record]]\nfile = \"one\"\nkind = \"free_decay\"\n";
  const auto campaign = [&](const std::string& geometry) {
    return held_campaign(head + geometry + record, {{0, {std::vector<double>(50, 1.0)}}});
  };
  const Campaign read = campaign(
      "[geometry]\nlines = [[\"root\", \"end\"]]\n[geometry.points]\nroot = [0, 0, 0]\nend = [0.1, 0.2, "
      "0.30000000000000004]\n[geometry.sensors]\ntip = { point = \"end\", direction = [0, 3, 4] }\n");
  ASSERT_TRUE(read.geometry);
  EXPECT_EQ(read.geometry->sensors[0].direction, (std::array<double, 3>{0, 0.6, 0.8}));
  const Campaign again = campaign(geometry_text(*read.geometry));
  EXPECT_EQ(campaign_text(again), campaign_text(read));
  EXPECT_EQ(again.geometry->points[0].at[2], 0.30000000000000004);

  const auto refused = [&](const std::string& geometry) { return refusal([&] { campaign(geometry); }); };
  EXPECT_TRUE(contains(refused("[geometry]\nlines = [[\"a\", \"b\"]]\n[geometry.points]\na = [0, 0, 0]\n"), "'b'"));
  EXPECT_TRUE(contains(refused("[geometry.points]\na = [0, 0]\n"), "[x, y, z]"));
  EXPECT_TRUE(
      contains(refused("[geometry.points]\na = [0, 0, 0]\n[geometry.sensors]\nroot = { point = \"a\", direction "
                       "= [1, 0, 0] }\n"),
               "no response"));
  EXPECT_TRUE(
      contains(refused("[geometry.points]\na = [0, 0, 0]\n[geometry.sensors]\ntip = { point = \"a\", direction = "
                       "[0, 0, 0] }\n"),
               "no length"));
}

}  // namespace
}  // namespace secular
