#include "estimator/identification/setting_functions.hpp"

#include <gtest/gtest.h>

#include <random>

namespace secular {
namespace {

std::vector<Eigen::VectorXd> records(int count) {
  std::vector<Eigen::VectorXd> of_records;
  for (int r = 0; r < count; ++r) {
    const double level = 1 + r % 3, frequency = 60 + 0.1 * r;
    of_records.push_back(Eigen::VectorXd{{1, level, frequency, 2 * level, level * level}});
  }
  return of_records;
}

TEST(SettingFunctions, AreOrthonormalAndIndependentAndTakeNoMoreThanTheyLeave) {
  const Eigen::MatrixXd functions = independent_functions(records(20));
  EXPECT_EQ(functions.cols(), 4);  // the second of level is the first
  EXPECT_TRUE((functions.transpose() * functions).isIdentity(1e-12));
  EXPECT_EQ(independent_functions(records(6)).cols(), 3);
  EXPECT_EQ(independent_functions(records(3)).cols(), 1);
  const Eigen::MatrixXd of_none = independent_functions({});
  EXPECT_EQ(of_none.size(), 0);
  EXPECT_EQ(follows_settings(Eigen::VectorXd(0), of_none), Following::too_few);
}

TEST(SettingFunctions, WhatIsMadeOfThemFollowsThem) {
  const auto of_records = records(20);
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise;
  Eigen::VectorXd own(20);
  for (Eigen::Index r = 0; r < 20; ++r) {
    const Eigen::VectorXd& settings = of_records[static_cast<std::size_t>(r)];
    own(r) = 3 * settings(1) - settings(4) + 0.1 * noise(random);
  }
  EXPECT_EQ(follows_settings(own, independent_functions(of_records)), Following::settings);
  EXPECT_EQ(follows_settings(own.head(5), independent_functions(records(5))), Following::too_few);
}

// At random it is said to follow in one of twenty: in 400 draws 20, with a standard deviation of 4.4.
TEST(SettingFunctions, ChanceIsTakenForALawAsOftenAsIsSaid) {
  const Eigen::MatrixXd functions = independent_functions(records(20));
  std::mt19937_64 random(4);
  std::normal_distribution<double> noise;
  int following = 0;
  for (int draw = 0; draw < 400; ++draw) {
    Eigen::VectorXd own(20);
    for (double& value : own) value = noise(random);
    following += follows_settings(own, functions) == Following::settings ? 1 : 0;
  }
  EXPECT_NEAR(following, 20, 4 * 4.4);
}

}  // namespace
}  // namespace secular
