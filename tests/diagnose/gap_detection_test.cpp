// Whether there is a gap, on numbers that are drawn.
#include "diagnose/verdict/gap_detection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "diagnose/thresholds.hpp"
#include "numerics/third_differences.hpp"
#include "tests/signal/gaussian.hpp"

namespace secular {
namespace {

/// What a search over `laws` candidates of one unknown each found.
struct Searched {
  Inference inference;
  std::vector<Candidate> laws;

  explicit Searched(std::size_t count) : laws(count) {
    for (Candidate& law : laws) law.strengths = {0};
    inference.linear_gain.assign(count, 0);
    inference.gain_of_records.assign(count, 0);
  }
};

DetectedGap detected_in(const RowsLeft& left, const Searched& s, std::optional<double> moved = {}) {
  return detect_gap(left, s.inference, s.laws, INFINITY, moved);
}

// Noise alone, of which ten laws explain a bit each: as often as the alarm says at most, and not much more seldom.
TEST(GapDetection, NoiseIsNoGap) {
  constexpr int campaigns = 40000, freedom = 50;
  std::mt19937_64 random(5);
  std::chi_squared_distribution<double> rows(freedom), gain(1);
  int alarms = 0;
  for (int i = 0; i < campaigns; ++i) {
    Searched s(10);
    for (double& g : s.inference.linear_gain) g = gain(random);
    if (detected_in({rows(random), freedom}, s).detected) ++alarms;
  }
  const double expected = campaigns * diagnose_thresholds().gap_alarm;
  EXPECT_LT(alarms, expected + 4 * std::sqrt(expected));
  EXPECT_GT(alarms, 0.7 * expected);
}

/// Evidence of so many rows in units of a noise that third differences of them show.
struct MeasuredRows : Evidence {
  Eigen::Index rows;
  std::vector<RowLabel> none;

  explicit MeasuredRows(Eigen::Index count) : rows(count) {}
  Eigen::Index size() const override { return rows; }
  Eigen::Index measured_rows() const override { return rows; }
  const std::vector<RowLabel>& labels() const override { return none; }
  void freeze(const Eigen::VectorXd& /*unknowns*/, double /*coarse*/) override {}
  void evaluate(const Eigen::VectorXd& /*unknowns*/, Eigen::Ref<Eigen::VectorXd> all) const override {
    all.setZero();
  }
};

// White noise in units of what third differences of it show: as often as the law says. It is the law of many rows;
// of 500, 6.4 % are below 5 %. (By chi-squared 8 % of many are.)
TEST(GapDetection, NoiseThatIsMeasuredByTheSameRowsIsNoGap) {
  constexpr int draws = 1500, rows = 5000;
  Discrepancy evidence;
  evidence.add(std::make_unique<MeasuredRows>(rows));
  testing_support::Gaussian noise(3);
  int below = 0;
  for (int i = 0; i < draws; ++i) {
    std::vector<double> series(rows);
    double squares = 0, of_differences = 0;
    for (double& value : series) {
      value = noise();
      squares += value * value;
    }
    const std::vector<double> third = third_differences(series);
    for (const double d : third) of_differences += d * d;
    const double level = of_differences / third_difference_variance / static_cast<double>(third.size());
    if (detected_in(rows_left(squares / level, rows, evidence), Searched(0)).p_value < 2 * 0.05) ++below;
  }
  const double expected = draws * 0.05;
  EXPECT_NEAR(below, expected, 3.5 * std::sqrt(expected));
}

TEST(GapDetection, EachOfTheThreeTestsSeesWhatIsItsOwn) {
  const RowsLeft quiet{50, 50};
  EXPECT_FALSE(detected_in(quiet, Searched(10), 0.5).detected);
  EXPECT_TRUE(detected_in({120, 50}, Searched(10)).detected);
  Searched law(10);
  law.inference.linear_gain[7] = 30;
  EXPECT_TRUE(detected_in(quiet, law).detected);
  EXPECT_TRUE(detected_in(quiet, Searched(10), 1e-5).detected);
}

// A gain that is the records' own frequencies as far as it goes is judged by how well their scatter is known.
TEST(GapDetection, AGainAmongScatteringRecordsSaysLess) {
  Searched law(1);
  law.inference.linear_gain = {16};
  law.inference.gain_of_records = {1};
  const RowsLeft quiet{50, 50};
  EXPECT_TRUE(detected_in(quiet, law).detected);
  // Student's t of 4 with 4 degrees of freedom: p = 0.0161, and two tests.
  EXPECT_NEAR(detect_gap(quiet, law.inference, law.laws, 4, {}).p_value, 2 * 0.01613, 1e-4);
}

TEST(GapDetection, RowsFarQuieterThanTheirNoiseShowThatItIsMisjudged) {
  EXPECT_TRUE(detected_in({10, 200}, Searched(0)).noise_misjudged);
  EXPECT_FALSE(detected_in({200, 200}, Searched(0)).noise_misjudged);
  EXPECT_FALSE(detected_in({0.1, 1}, Searched(0)).noise_misjudged);  // one row says nothing
}

}  // namespace
}  // namespace secular
