// Text files of LabVIEW.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

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

TEST_F(Lvm, ComplaintsNameTheLine) {
  EXPECT_TRUE(contains(refusal([] { read_lvm(lvm_files / "damaged/two_segments.lvm"); }),
                       "line 22: begins a second segment"));
  EXPECT_TRUE(contains(refusal([] { read_lvm(lvm_files / "damaged/few_fields.lvm"); }),
                       "line 19: has 2 fields, the names are 3"));
  EXPECT_TRUE(contains(refusal([] { read_lvm(lvm_files / "damaged/no_names.lvm"); }), "without a line of names"));
  EXPECT_TRUE(contains(refusal([] { read_lvm(lvm_files / "damaged/no_step.lvm"); }), "states no number for X0"));
}

}  // namespace
}  // namespace secular
