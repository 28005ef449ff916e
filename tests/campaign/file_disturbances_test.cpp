// What a file holds beside its motion, before anybody says what its variables are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "measure/data/inspection.hpp"
#include "measure/disturbances/catalogue.hpp"
#include "measure/formats/number_table.hpp"
#include "tests/campaign/mat_writer.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

namespace fs = std::filesystem;
using Samples = std::vector<double>;

constexpr double file_rate = 512;
constexpr std::size_t file_count = 4096;

class FileDisturbances : public TemporaryFolder {
 protected:
  static Samples time() {
    Samples stamps(file_count);
    for (std::size_t i = 0; i < file_count; ++i) stamps[i] = static_cast<double>(i) / file_rate;
    return stamps;
  }
  // Two modes that decay, in noise, and a tone of such an amplitude.
  static Samples decay(unsigned seed, double tone, double tone_hz) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
    Samples samples(file_count);
    for (std::size_t i = 0; i < file_count; ++i) {
      const double t = static_cast<double>(i) / file_rate, turn = 2 * std::numbers::pi * t;
      const double noise = std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform());
      samples[i] = 3 * std::exp(-0.4 * t) * std::cos(20.3 * turn) + std::exp(-0.9 * t) * std::cos(57.7 * turn + 1) +
                   tone * std::cos(tone_hz * turn) + 0.003 * noise;
    }
    return samples;
  }
  static std::vector<std::string> found_in(const fs::path& file) {
    std::vector<std::string> kinds;
    inspect_file(file, {}, [&](const Campaign& campaign, const Record& record) {
      for (const Disturbance& disturbance : find_disturbances(campaign, 0, record))
        kinds.push_back(std::string(disturbance.kind) +
                        (disturbance.channel ? " " + campaign.channels[*disturbance.channel].name : ""));
    });
    std::sort(kinds.begin(), kinds.end());
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
    return kinds;
  }
};

using Kinds = std::vector<std::string>;

TEST_F(FileDisturbances, OfACsv) {
  const auto file = [&](const Samples& tip, const Samples& mid) {
    return write("a.csv", "Time (s),tip (m/s^2),mid\n" + csv_rows({time(), tip, mid}));
  };
  const Samples clean = decay(1, 0, 0);
  EXPECT_EQ(found_in(file(clean, decay(2, 0, 0))), Kinds{});
  EXPECT_EQ(found_in(file(decay(3, 0.02, 100), clean)), Kinds{"foreign_tone tip (m/s^2)"});
  Samples shifted = clean, spiked = clean;
  for (double& x : shifted) x += 0.05;
  spiked[1000] += 2;
  spiked[3001] -= 2;
  EXPECT_EQ(found_in(file(shifted, spiked)), (Kinds{"offset tip (m/s^2)", "spikes mid"}));
}

TEST_F(FileDisturbances, OfAMatFileWithAMatrix) {
  const fs::path file = folder_ / "a.mat";
  const Samples clean = decay(1, 0, 0);
  Samples stepped = clean, held = clean, both;
  for (double& x : stepped) x = 0.1 * std::round(x / 0.1);
  for (std::size_t i = 200; i < 2000; i += 90) held[i] = held[i - 1];
  both = stepped;
  both.insert(both.end(), held.begin(), held.end());
  {
    MatWriter writer(file);
    writer.add(MatWriter::column("t", time()));
    writer.add(MatWriter::array("m", MAT_C_DOUBLE, MAT_T_DOUBLE, file_count, 2, both));
  }
  const Kinds kinds = found_in(file);
  EXPECT_TRUE(std::find(kinds.begin(), kinds.end(), "converter_step m(:,1)") != kinds.end());
  EXPECT_TRUE(std::find(kinds.begin(), kinds.end(), "held_samples m(:,2)") != kinds.end());
}

TEST_F(FileDisturbances, OfASharedFile) {
  const fs::path file = testing_support::source_folder() / "../shared/faults/clipping_missed/0014.csv";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const Kinds kinds = found_in(file);
  EXPECT_TRUE(std::find(kinds.begin(), kinds.end(), "clipping tip") != kinds.end());
}

}  // namespace
}  // namespace secular
