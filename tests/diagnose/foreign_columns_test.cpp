// Columns of what readings hold beside the motion: a zero's course of any slow shape, and nothing of the motion's.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "diagnose/evidence/foreign_content.hpp"
#include "diagnose/evidence/segment.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double natural_hz = 10, column_step_s = 1 / 320.0;

// Of two channels, the second one wanders.
Segment segment_of(double turns) {
  Segment s;
  s.sample_s = column_step_s;
  s.response = MatrixXd::Zero(2, static_cast<Index>(turns / natural_hz / column_step_s));
  s.wandering = {1};
  s.zeros_below_hz = natural_hz / 4;
  return s;
}

// What the columns leave of a course in the second channel, as a share of it.
double left_of(const Segment& s, const std::function<double(double)>& course) {
  const Index samples = s.response.cols();
  VectorXd reading = VectorXd::Zero(2 * samples);
  for (Index i = 0; i < samples; ++i) reading(samples + i) = course(static_cast<double>(i) * column_step_s);
  const MatrixXd columns = foreign_columns(s);
  return (reading - columns * (columns.transpose() * reading)).norm() / reading.norm();
}

TEST(ForeignColumns, FollowWhatAnAmplifierDoesAfterABlow) {
  for (const double turns : {6.0, 15.0, 40.0})
    for (const auto& [time_in_turns, most] : {std::pair{2.0, 4e-3}, {5.0, 1e-3}, {60.0, 1e-3}}) {
      const double time_s = time_in_turns / natural_hz;
      EXPECT_LT(left_of(segment_of(turns), [&](double t) { return std::exp(-t / time_s); }), most)
          << turns << ' ' << time_in_turns;
    }
}

TEST(ForeignColumns, LeaveTheMotionAlone) {
  for (const double turns : {6.0, 15.0, 40.0}) {
    const auto swings = [](double t) { return std::exp(-t) * std::cos(2 * std::numbers::pi * natural_hz * t); };
    EXPECT_GT(left_of(segment_of(turns), swings), 0.99) << turns;
  }
}

TEST(ForeignColumns, AreOrthonormalAndOfTheWanderingChannelAlone) {
  const Segment s = segment_of(15);
  const MatrixXd columns = foreign_columns(s);
  EXPECT_EQ(columns.cols(), zero_count(s, s.response.cols()));
  EXPECT_LT((columns.transpose() * columns - MatrixXd::Identity(columns.cols(), columns.cols())).norm(), 1e-12);
  EXPECT_EQ(columns.topRows(s.response.cols()).norm(), 0);
}

// While errors are coarse the first ones count, in the first turns: they must not follow the motion there.
TEST(ForeignColumns, OfAFewTurnsLeaveTheMotionAloneInThese) {
  Segment s = segment_of(40);
  const Index few = s.response.cols() * 6 / 40, held = zero_count(s, few);
  const MatrixXd columns = foreign_columns(s).middleRows(s.response.cols(), few).leftCols(held);
  VectorXd motion(few);
  for (Index i = 0; i < few; ++i)
    motion(i) = std::cos(2 * std::numbers::pi * natural_hz * static_cast<double>(i) * column_step_s);
  const VectorXd left = motion - columns * columns.colPivHouseholderQr().solve(motion);
  EXPECT_GT(left.norm() / motion.norm(), 0.98);
}

}  // namespace
}  // namespace secular
