// What is a record's own, beside a model: rows of unit variance, the likeliest values, how records differ.
#include "diagnose/evidence/record_directions.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <random>

#include "diagnose/evidence/discrepancy.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd normal(Index size, std::mt19937_64& random) {
  std::normal_distribution<double> one;
  VectorXd values(size);
  for (double& v : values) v = one(random);
  return values;
}

MatrixXd columns_of(Index rows, std::mt19937_64& random) {
  MatrixXd columns(rows, 2);
  columns << 30 * normal(rows, random), 5 * normal(rows, random);
  return columns;
}

// (I + C C')^(-1/2) of the rows of the record; others stay.
TEST(RecordDirections, GiveRowsUnitVariance) {
  std::mt19937_64 random(1);
  const std::vector<Index> rows{1, 2, 4, 5, 6, 7};
  const MatrixXd columns = columns_of(6, random);
  const RecordDirections directions(rows, columns, VectorXd::Zero(2));
  MatrixXd all = MatrixXd::Identity(9, 9);
  directions.whiten_slopes(all);
  MatrixXd covariance = MatrixXd::Identity(9, 9);
  covariance(rows, rows) += columns * columns.transpose();
  EXPECT_LT((all * covariance * all.transpose() - MatrixXd::Identity(9, 9)).norm(), 1e-9);
}

// Rows of a linear model do not depend on where its unknowns were put.
TEST(RecordDirections, AreTheSameWhereverTheUnknownsArePut) {
  std::mt19937_64 random(2);
  const std::vector<Index> rows{0, 1, 2, 3, 4, 5};
  const MatrixXd columns = columns_of(6, random);
  const VectorXd measured = normal(6, random), put_in = normal(2, random);
  const RecordDirections here(rows, columns, VectorXd::Zero(2)), there(rows, columns, put_in);
  VectorXd at_zero = measured, at_put_in = measured + columns * put_in;
  EXPECT_LT((here.likeliest(at_zero) - there.likeliest(at_put_in)).norm(), 1e-9);
  for (Index entry = 0; entry < 2; ++entry) {
    EXPECT_NEAR(here.told(at_zero, entry).value, there.told(at_put_in, entry).value, 1e-9);
    EXPECT_NEAR(here.told(at_zero, entry).variance, there.told(at_put_in, entry).variance, 1e-12);
  }
  here.whiten_rows(at_zero);
  there.whiten_rows(at_put_in);
  EXPECT_LT((at_zero - at_put_in).norm(), 1e-9);
}

// Whatever the other unknowns of the record are.
TEST(RecordDirections, TellOneUnknownBesideTheOthers) {
  std::mt19937_64 random(3);
  const MatrixXd columns = columns_of(200, random);
  std::vector<Index> rows(200);
  for (Index i = 0; i < 200; ++i) rows[static_cast<std::size_t>(i)] = i;
  double squares = 0;
  for (int draw = 0; draw < 400; ++draw) {
    const VectorXd own{{0.7, -2}};
    const VectorXd measured = normal(200, random) - columns * own;
    const RecordDirections directions(rows, columns, VectorXd::Zero(2));
    const RecordDirections::Told told = directions.told(measured, 0);
    squares += std::pow(told.value - own(0), 2) / told.variance;
  }
  // Mean of 400 squares of standard normal values, three standard deviations.
  EXPECT_NEAR(squares / 400, 1, 3 * std::sqrt(2.0 / 400));
}

/// Two records of two rows; the first of each grows with the natural frequency, by 3 and 4 for all of it.
class TwoRecords : public Evidence {
 public:
  TwoRecords() : labels_(4) { labels_[2].record = labels_[3].record = 1; }
  Index size() const override { return 4; }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const VectorXd& /*unknowns*/, double /*coarse*/) override {}
  void evaluate(const VectorXd& unknowns, Eigen::Ref<VectorXd> rows) const override {
    rows << 3 * (unknowns(0) - 1), 0, 4 * (unknowns(0) - 1), 0;
  }

 private:
  std::vector<RowLabel> labels_;
};

// A frequency that scatters by s adds (g s)^2 to the variance 1 of a row with the slope g.
TEST(RecordDirections, AreSoMuchOfWhatAColumnTells) {
  constexpr double s = 0.5;
  Discrepancy discrepancy;
  discrepancy.add(std::make_unique<TwoRecords>());
  EXPECT_EQ(discrepancy.share_of_records(VectorXd::Unit(4, 0)), 0);
  RecordNuisances nuisances;
  nuisances.frequency_sd = VectorXd::Constant(1, s);
  discrepancy.admit(nuisances);
  discrepancy.freeze(VectorXd::Ones(1));
  EXPECT_NEAR(discrepancy.share_of_records(VectorXd::Unit(4, 0)), 1 - 1 / (1 + 9 * s * s), 1e-6);
  EXPECT_NEAR(discrepancy.share_of_records(VectorXd::Unit(4, 2)), 1 - 1 / (1 + 16 * s * s), 1e-6);
  EXPECT_NEAR(discrepancy.share_of_records(VectorXd::Unit(4, 1)), 0, 1e-12);
  EXPECT_EQ(discrepancy.share_of_records(VectorXd::Zero(4)), 0);
}

TEST(BetweenRecords, VarianceIsThatOfTheDraw) {
  std::mt19937_64 random(4);
  constexpr int draws = 600;
  constexpr Index count = 12;
  double variance = 0, alarms = 0;
  MatrixXd functions(count, 2);
  functions << VectorXd::Ones(count), VectorXd::LinSpaced(count, 0, 1);
  const VectorXd own = VectorXd::LinSpaced(count, 0.01, 0.2);
  for (int draw = 0; draw < draws; ++draw) {
    const VectorXd noise = own.cwiseSqrt().cwiseProduct(normal(count, random)), law = functions * VectorXd{{3, -5}};
    const Between between = between_records(law + noise + 0.6 * normal(count, random), own, functions);
    variance += between.sd * between.sd / draws;
    alarms += between_records(law + noise, own, functions).p_value < 0.05 ? 1.0 / draws : 0;
  }
  // Of a variance of ten degrees of freedom with the mean noise beside it, three standard deviations of the mean;
  // cut at zero hardly ever.
  const double sd = std::sqrt(2.0 / 10) * (0.36 + own.mean());
  EXPECT_NEAR(variance, 0.36, 3 * sd / std::sqrt(draws) + 0.01);
  EXPECT_NEAR(alarms, 0.05, 3 * std::sqrt(0.05 * 0.95 / draws));
}

}  // namespace
}  // namespace secular
