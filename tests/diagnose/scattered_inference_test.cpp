// The search for explanations where every record has a natural frequency of its own, on rows that are a few lines
// of algebra.
#include "diagnose/verdict/scattered_inference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index swings = 12, of_each = 60;
constexpr double reading_sd = 0.02;

/// Records of (1 + u_1 a) cos(u_0 (1 + own) t), each with an amplitude a of its own.
class Tones : public Evidence {
 public:
  Tones(const VectorXd& truth, double scatter) : labels_(swings * of_each), offsets_(swings) {
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal;
    for (std::size_t r = 0; r < labels_.size(); ++r) {
      labels_[r].record = r / of_each;
      labels_[r].fold = static_cast<int>(labels_[r].record);
      labels_[r].amplitude = amplitude(labels_[r].record);
      labels_[r].level = 1;
    }
    for (double& offset : offsets_) offset = scatter * normal(random);
    measured_ = signal(truth);
    for (double& y : measured_) y += reading_sd * normal(random);
    own_ = offsets_;
    offsets_.setZero();
  }

  Index size() const override { return swings * of_each; }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const VectorXd& /*unknowns*/, double /*coarse*/) override {}
  void evaluate(const VectorXd& unknowns, Eigen::Ref<VectorXd> rows) const override {
    rows = (measured_ - signal(unknowns)) / reading_sd;
  }
  void set_frequency_offsets(const std::map<std::size_t, VectorXd>& offsets) override {
    offsets_.setZero();
    for (const auto& [record, offset] : offsets) offsets_(static_cast<Index>(record)) = offset(0);
  }

  /// Of the frequencies that were put in.
  double sd_of_own() const {
    return std::sqrt((own_.array() - own_.mean()).square().sum() / static_cast<double>(swings - 1));
  }

 private:
  // In an order that no low power of the record's number follows.
  static double amplitude(std::size_t record) { return 0.2 + 0.1 * static_cast<double>((5 * record) % swings); }

  VectorXd signal(const VectorXd& unknowns) const {
    VectorXd y(size());
    for (std::size_t r = 0; r < labels_.size(); ++r) {
      const auto record = static_cast<Index>(labels_[r].record);
      const double t = 0.5 * static_cast<double>(r % of_each + 1);
      y(static_cast<Index>(r)) =
          (1 + unknowns(1) * labels_[r].amplitude) * std::cos(unknowns(0) * (1 + offsets_(record)) * t);
    }
    return y;
  }

  std::vector<RowLabel> labels_;
  VectorXd offsets_, own_, measured_;
};

/// One law, whose strength is the second unknown.
std::vector<Candidate> one_law() {
  Candidate law;
  law.effect = "law";
  law.strengths = {1};
  law.shape_starts = {VectorXd()};
  return {law};
}

struct ScatteredSearch {
  ScatteredInference search;
  RecordNuisances of_records;
  double sd_of_own = 0;
};

ScatteredSearch searched(double strength, double scatter, bool admitted, bool knows_without = false) {
  ScatteredSearch found;
  const VectorXd truth{{1, strength}}, start{{1, 0}};
  auto evidence = std::make_unique<Tones>(truth, scatter);
  found.sd_of_own = evidence->sd_of_own();
  Discrepancy discrepancy;
  discrepancy.add(std::move(evidence));
  if (admitted) found.of_records.frequency_sd = VectorXd::Constant(1, 0.01);
  discrepancy.admit(found.of_records);
  found.search = infer_beside_scatter(discrepancy, found.of_records, {one_law(), start, {0}, {}}, knows_without);
  return found;
}

TEST(ScatteredInference, OfOneFrequencyForAllHasNoScatter) {
  const ScatteredSearch found = searched(0, 0, false);
  EXPECT_FALSE(found.search.scatter.any());
  EXPECT_EQ(found.of_records.frequency_sd.size(), 0);
}

// Of twelve draws the standard deviation is what it is; the noise adds 1e-4.
TEST(ScatteredInference, FindsTheScatterThatIsThere) {
  const ScatteredSearch found = searched(0, 2e-3, true);
  ASSERT_TRUE(found.search.scatter.any());
  EXPECT_TRUE(found.search.scatter.suffices);
  EXPECT_NEAR(found.search.scatter.sd(0), found.sd_of_own, 0.3 * found.sd_of_own);
  EXPECT_EQ(found.search.scatter.records.size(), static_cast<std::size_t>(swings));
  // What the search was made beside is what it found.
  EXPECT_NEAR(found.of_records.frequency_sd(0), found.search.scatter.sd(0), 0.5 * found.search.scatter.sd(0));
}

// Frequencies that were allowed to differ and do not: what is known already is not searched for once more.
TEST(ScatteredInference, OfNoneThatIsThereEndsWhereTheRestIsKnown) {
  const ScatteredSearch alone = searched(0.5, 0, true), known = searched(0.5, 0, true, true);
  EXPECT_FALSE(alone.search.scatter.any());
  EXPECT_TRUE(alone.search.scatter.suffices);
  EXPECT_LE(alone.of_records.frequency_sd(0), no_scatter);
  EXPECT_FALSE(known.search.scatter.suffices);
  EXPECT_GT(known.of_records.frequency_sd(0), no_scatter);
}

TEST(ScatteredInference, FindsTheLawBesideIt) {
  const ScatteredSearch found = searched(0.5, 2e-3, true);
  ASSERT_FALSE(found.search.inference.explanations.empty());
  const Refit& best = found.search.inference.explanations.front().fit;
  EXPECT_NEAR(best.unknowns(1), 0.5, 0.02);
  EXPECT_TRUE(found.search.scatter.suffices);
  EXPECT_NEAR(found.search.scatter.sd(0), found.sd_of_own, 0.3 * found.sd_of_own);
}

}  // namespace
}  // namespace secular
