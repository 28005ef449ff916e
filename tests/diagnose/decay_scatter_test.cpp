// How natural frequencies differ from decay to decay, as an identification says it.
#include "diagnose/verdict/decay_scatter.hpp"

#include <gtest/gtest.h>

#include "input/input_error.hpp"

namespace secular {
namespace {

EstimatedValue natural_frequency(std::size_t mode, double value, double sd, double p_value) {
  EstimatedValue found;
  found.value = value;
  ScatterBetweenRecords& scatter = found.between_records.emplace();
  scatter.mode = mode;
  scatter.sd = sd;
  scatter.p_value = p_value;
  return found;
}

TEST(DecayScatter, IsRelativeAndOfModesWhoseDecaysPlainlyDiffer) {
  const DecayScatter found = find_decay_scatter([] {
    return std::vector{EstimatedValue(), natural_frequency(2, 50, 0.5, 1e-5), natural_frequency(0, 20, 1, 0.3)};
  });
  EXPECT_EQ(found.frequency_sd, (Eigen::VectorXd{{0, 0, 0.01}}));
  EXPECT_EQ(found.warning, "");
}

TEST(DecayScatter, OfNoDecaysIsNone) {
  EXPECT_EQ(find_decay_scatter([] { return std::vector<EstimatedValue>(1); }).frequency_sd.size(), 0);
}

TEST(DecayScatter, ThatCouldNotBeLookedForIsAWarning) {
  const DecayScatter found = find_decay_scatter(
      []() -> std::vector<EstimatedValue> { throw InputError("campaign", "", "holds no decay", "one or more"); });
  EXPECT_EQ(found.frequency_sd.size(), 0);
  EXPECT_NE(found.warning.find("holds no decay"), std::string::npos) << found.warning;
}

}  // namespace
}  // namespace secular
