// Damaged files: whatever the bytes, the outcome is success or an InputError, never another exception or a crash.

#include "tests/campaign/mutation.hpp"

#include <cstdint>

#include "measure/data/campaign.hpp"
#include "measure/data/inspection.hpp"
#include "measure/formats/data_file.hpp"
#include "tests/campaign/mat_writer.hpp"

namespace secular {
namespace {

const char* const campaign_toml = R"(schema = 1
name = "beam"
sample_rate_hz = 10.0
[[channel]]
name = "base"
role = "excitation"
quantity = "acceleration"
unit = "m/s^2"
[[channel]]
name = "tip"
role = "response"
quantity = "displacement"
unit = "m"
[modal_basis]
channels = ["tip"]
modes = ["v"]
mass_normalised_shapes = [[1.5]]
[[record]]
file = "records/0001.csv"
kind = "dwell"
excitation_frequency_hz = 2.5
group = "up"
)";

const char* const record_csv = "t,base,tip\n0,1.5,-2e-3\n0.1,2.5,3\n0.2,0.125,-4\n0.3,7,1e-7\n0.4,-1,0\n";

TEST_F(Mutation, CampaignFile) {
  write("records/0001.csv", record_csv);
  run("campaign.toml", campaign_toml, 4000, [&] { read_campaign(folder_); });
}

TEST_F(Mutation, CsvRecord) {
  write("campaign.toml", campaign_toml);
  const std::string valid = record_csv;
  write("records/0001.csv", valid);
  const Campaign campaign = read_campaign(folder_);
  run("records/0001.csv", valid, 4000, [&] {
    inspect_records(campaign);
    const Record record = read_record(campaign, campaign.records.front());
    for (const std::vector<double>& channel : record.channels) ASSERT_EQ(channel.size(), record.samples());
  });
  EXPECT_GT(accepted_, 50);
}

void use_mat(const std::filesystem::path& path) {
  inspect_file(path);
  const DataFile data = read_data_file(path, {"t", "run.a"});
  ASSERT_EQ(data.vector("t").values.size(), data.vector("t").shape[0] * data.vector("t").shape[1]);
  data.vector("run.a");
}

void write_mat(const std::filesystem::path& path, bool compressed) {
  MatWriter writer(path);
  writer.add(MatWriter::text("note", "second run"), compressed);
  writer.add_sparse_identity("selection", 3, compressed);
  writer.add(MatWriter::column("t", {0, 0.1, 0.2, 0.3, 0.4, 0.5}), compressed);
  writer.add(
      MatWriter::structure("run", 1, {"a", "b"},
                           {MatWriter::row("", {1, 2, 3, 4, 5, 6}),
                            MatWriter::array<std::int16_t>("", MAT_C_INT16, MAT_T_INT16, 2, 2, {1, 2, 3, 4})}),
      compressed);
}

TEST_F(Mutation, MatFile) {
  write_mat(folder_ / "a.mat", false);
  run("a.mat", read("a.mat"), 2000, [&] { use_mat(folder_ / "a.mat"); });
}

TEST_F(Mutation, CompressedMatFile) {
  write_mat(folder_ / "a.mat", true);
  run("a.mat", read("a.mat"), 2000, [&] { use_mat(folder_ / "a.mat"); });
}

TEST_F(Mutation, EveryLengthOfATruncatedMatFileIsRefused) {
  for (const bool compressed : {false, true}) {
    write_mat(folder_ / "a.mat", compressed);
    const std::string valid = read("a.mat");
    for (std::size_t length = 0; length < valid.size(); ++length) {
      write("a.mat", valid.substr(0, length));
      EXPECT_THROW(use_mat(folder_ / "a.mat"), InputError) << length << " of " << valid.size();
    }
  }
}

}  // namespace
}  // namespace secular
