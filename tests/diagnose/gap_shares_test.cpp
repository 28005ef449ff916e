// Shares of a gap, on rows that are made up.
#include "diagnose/verdict/gap_shares.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int few_dwells = 20;

// Balances in phase and in quadrature of one mode, then a channel's line: three rows a dwell.
std::vector<RowLabel> labels_of_few() {
  std::vector<RowLabel> all;
  for (int d = 0; d < few_dwells; ++d) {
    RowLabel label;
    label.amplitude = 1e-3 * (1 + d);
    label.place = "v";
    label.harmonic = "Omega";
    label.balance = true;
    for (const EffectComponent part : {EffectComponent::conservative, EffectComponent::dissipative}) {
      label.component = part;
      all.push_back(label);
    }
    label.place = "upper";
    label.balance = false;
    label.component = EffectComponent::measurement;
    all.push_back(label);
  }
  return all;
}

VectorXd rows(double in_phase, double in_quadrature, double line, bool large_only = false) {
  VectorXd all = VectorXd::Zero(3 * few_dwells);
  for (int d = 0; d < few_dwells; ++d)
    if (!large_only || d > few_dwells / 2) all.segment<3>(3 * d) << in_phase, in_quadrature, line;
  return all;
}

TEST(GapShares, AreThoseOfTheEnergy) {
  const VectorXd gap = rows(0, 3, 1);
  const std::vector<GapShare> shares = gap_shares(gap, gap, labels_of_few(), nullptr);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_EQ(shares[0].mode, "v");
  EXPECT_EQ(shares[0].component, EffectComponent::dissipative);
  EXPECT_EQ(shares[0].harmonic, "Omega");
  EXPECT_DOUBLE_EQ(shares[0].share, 0.9);
  EXPECT_EQ(shares[0].region, "all amplitudes");
  EXPECT_EQ(shares[1].mode, "upper");
  EXPECT_DOUBLE_EQ(shares[1].share, 0.1);
}

TEST(GapShares, DoNotDependOnTheSizeOfTheGap) {
  const VectorXd gap = rows(1, 2, 1);
  const std::vector<GapShare> one = gap_shares(gap, gap, labels_of_few(), nullptr),
                              other = gap_shares(1e6 * gap, 1e6 * gap, labels_of_few(), nullptr);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t s = 0; s < one.size(); ++s) EXPECT_NEAR(one[s].share, other[s].share, 1e-12);
}

// Whitening mixes the parts of a pair: the whole of it goes to where the force is.
TEST(GapShares, OfAPairGoToThePartThatTheForceIsIn) {
  const std::vector<GapShare> shares = gap_shares(rows(2, 2, 0), rows(0, 5, 0), labels_of_few(), nullptr);
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(shares[0].component, EffectComponent::dissipative);
  EXPECT_DOUBLE_EQ(shares[0].share, 1);
}

TEST(GapShares, SayWhereTheAmplitudeIsLarge) {
  const VectorXd gap = rows(0, 3, 0, true);
  const std::vector<GapShare> shares = gap_shares(gap, gap, labels_of_few(), nullptr);
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(shares[0].region, "amplitude > 0.022");  // middle of half of the peaks, 0.011, as a peak
}

TEST(GapShares, OfANamedForceAreItsOwn) {
  Candidate named;
  named.component = EffectComponent::parametric_excitation;
  named.equation = true;
  const VectorXd gap = rows(2, 2, 0);
  const std::vector<GapShare> shares = gap_shares(gap, gap, labels_of_few(), &named);
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(shares[0].component, EffectComponent::parametric_excitation);
}

}  // namespace
}  // namespace secular
