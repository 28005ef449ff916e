#include "estimator/identification/instrument_rows.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace secular {
namespace {

// Columns that share with the response what their instruments do not have.
struct SharedErrors {
  Eigen::MatrixXd instruments{200, 2}, columns{200, 2};
  Eigen::VectorXd response{200};
  std::vector<std::size_t> record;

  explicit SharedErrors(double strength) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    for (Eigen::Index r = 0; r < 200; ++r) {
      const double shared = normal(random);
      instruments.row(r) << 1, normal(random);
      columns.row(r) << 1, strength * instruments(r, 1) + shared;
      response(r) = 3 - 2 * columns(r, 1) + shared;
      record.push_back(static_cast<std::size_t>(r));
    }
  }
};

// Least squares of the rows is (Z'X)^-1 Z'y with residuals y - Xc, and that is right; least squares of y on X is
// not.
TEST(InstrumentRows, HaveTheEstimateByInstrumentsAsLeastSquares) {
  const SharedErrors data(1);
  const InstrumentRows rows = instrument_rows(data.instruments, data.columns, data.response);
  const Eigen::VectorXd found = rows.design.colPivHouseholderQr().solve(rows.response);
  const Eigen::VectorXd direct =
      (data.instruments.transpose() * data.columns).inverse() * (data.instruments.transpose() * data.response);
  EXPECT_LT((found - direct).norm(), 1e-10);
  EXPECT_LT((rows.response - rows.design * found - data.response + data.columns * direct).norm(), 1e-10);
  EXPECT_LT((data.instruments * rows.onto - rows.design).norm(), 1e-10);
  EXPECT_NEAR(found(1), -2, 4 / std::sqrt(200));
  EXPECT_GT(data.columns.colPivHouseholderQr().solve(data.response)(1), -1.7);
}

// By (55) as it is written, over combinations of the two columns; instruments of noise have none.
TEST(InstrumentRows, KnowTheStrengthOfTheFirstStage) {
  const SharedErrors data(0.5);
  const InstrumentRows rows = instrument_rows(data.instruments, data.columns, data.response);
  const Eigen::MatrixXd directions =
      Eigen::HouseholderQR<Eigen::MatrixXd>(data.instruments).householderQ() * Eigen::MatrixXd::Identity(200, 2);
  double most = 0;
  for (double angle = 0; angle < 3.1416; angle += 1e-3) {
    const Eigen::VectorXd w = Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const Eigen::VectorXd left = (data.columns - rows.design) * w;
    most = std::max(most, (left.asDiagonal() * directions).squaredNorm() / (rows.design * w).squaredNorm());
  }
  EXPECT_NEAR(instrument_relevance(rows.design, data.columns, data.record) * most, 1, 1e-3);
  EXPECT_LT(instrument_relevance(instrument_rows(data.instruments, SharedErrors(0).columns, data.response).design,
                                 SharedErrors(0).columns, data.record),
            4);
}

}  // namespace
}  // namespace secular
