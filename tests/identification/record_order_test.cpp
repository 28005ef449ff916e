// Shifts of dwells at two levels, of which a fit takes out a smooth function of frequency at each.
#include "estimator/identification/record_order.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "estimator/identification/estimate.hpp"
#include "numerics/quadratic_form.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct TwentyDwells {
  std::vector<DwellPlace> places;
  MatrixXd taken_out = MatrixXd(20, 3), left;

  // Of a campaign that goes up at each level, or in any order.
  explicit TwentyDwells(const std::function<double(int)>& time) {
    for (int r = 0; r < 20; ++r) {
      const double frequency = (r % 10) / 4.5 - 1, level = r < 10 ? 1 : 1.5;
      places.push_back({level, frequency, time(r)});
      taken_out.row(r) << 1, level * level * std::exp(-frequency * frequency), frequency;
    }
    const MatrixXd span = Eigen::HouseholderQR<MatrixXd>(taken_out).householderQ() * MatrixXd::Identity(20, 3);
    left = MatrixXd::Identity(20, 20) - span * span.transpose();
  }
  double p_value(const std::function<double(const DwellPlace&)>& shift) const {
    VectorXd shifts(20);
    for (Index r = 0; r < 20; ++r) shifts(r) = shift(places[static_cast<std::size_t>(r)]);
    shifts = VectorXd(left * shifts);
    ScatterBetweenRecords scatter;
    scatter.shifts.assign(shifts.begin(), shifts.end());
    scatter.covariance = left;
    return order_p_value(scatter, places);
  }
};

// Of two values the share of the first square follows the arcsine law; a common factor and directions that do not
// vary do not matter.
TEST(QuadraticForm, HasTheArcsineLawOfTwoValues) {
  MatrixXd form = MatrixXd::Zero(3, 3), covariance = MatrixXd::Zero(3, 3);
  form(0, 0) = 1;
  covariance.diagonal() << 4, 4, 0;
  for (const double share : {0.01, 0.3, 0.5, 0.95})
    EXPECT_NEAR(ratio_lower_tail(share, form, covariance), 2 / std::numbers::pi * std::asin(std::sqrt(share)),
                1e-9);
}

// Either order is said to be followed at 5 %: at random as often as that at least and twice that at most; in 400
// draws 20 to 40, within four standard deviations of 4.4 and 6.
TEST(RecordOrder, IsFollowedAtRandomAsOftenAsIsSaid) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const TwentyDwells dwells([](int r) { return (7 * r) % 20; });
  int followed = 0;
  for (int draw = 0; draw < 400; ++draw)
    followed += dwells.p_value([&](const DwellPlace&) { return normal(random); }) < 0.05 ? 1 : 0;
  EXPECT_GT(followed, 20 - 4 * 4.4);
  EXPECT_LT(followed, 40 + 4 * 6);
}

// A drift by a period and a half, and a state that changes twice, in dwells of any order and in those of levels one
// after the other; a bend over frequency at one level.
TEST(RecordOrder, IsFollowedByDriftsAndStatesAndBends) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  const auto drift = [&](const DwellPlace& at) {
    return std::sin(3 * std::numbers::pi * at.time / 20) + 0.2 * normal(random);
  };
  const auto state = [&](const DwellPlace& at) {
    return (at.time > 5 && at.time < 14 ? 1 : 0) + 0.2 * normal(random);
  };
  const auto bend = [&](const DwellPlace& at) {
    return at.level > 1.2 ? std::pow(at.frequency, 3) + 0.1 * normal(random) : 0.1 * normal(random);
  };
  const TwentyDwells any([](int r) { return (7 * r) % 20; }), ascending([](int r) { return r; });
  for (const TwentyDwells* dwells : {&any, &ascending}) {
    EXPECT_LT(dwells->p_value(drift), 0.01);
    EXPECT_LT(dwells->p_value(state), 0.01);
    EXPECT_LT(dwells->p_value(bend), 0.05);
  }
}

TEST(TruncationCorrection, IsSettledWhereNoValueMovesByMoreThanItsErrorBar) {
  Estimate estimate;
  EstimatedValue value;
  value.name = "a";
  value.value = 3;
  value.sd = 1;
  value.degrees_of_freedom = 10;
  estimate.parameters = {value};
  const VectorXd before{{3.0}};
  EXPECT_TRUE(with_unsettled_correction(estimate, before, VectorXd{{3.9}}).correction_settled);
  EXPECT_FALSE(with_unsettled_correction(estimate, before, VectorXd{{4.1}}).correction_settled);
}

}  // namespace
}  // namespace secular
