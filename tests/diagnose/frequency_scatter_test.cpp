// Natural frequencies that differ from record to record, on rows that are made up.
#include "diagnose/evidence/frequency_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index records = 24, rows_of_record = 4;

std::vector<RowLabel> labels() {
  std::vector<RowLabel> all;
  for (Index r = 0; r < records; ++r) {
    RowLabel label;
    label.record = static_cast<std::size_t>(r);
    all.insert(all.end(), static_cast<std::size_t>(rows_of_record), label);
  }
  return all;
}

MatrixXd random_matrix(Index rows, Index columns, std::mt19937& random) {
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

// Rows that are linear in one natural frequency (the first unknown) and three numbers more.
struct Draw {
  MatrixXd jacobian, changes;
  VectorXd rows;
  VectorXd shifts;
};

Draw draw(double sd, unsigned seed) {
  std::mt19937 random(seed);
  Draw d;
  d.changes = 300 * random_matrix(records * rows_of_record, 1, random);
  d.jacobian = random_matrix(records * rows_of_record, 4, random);
  d.jacobian.col(0) = d.changes;
  d.rows = random_matrix(records * rows_of_record, 1, random);
  d.shifts = sd * random_matrix(records, 1, random);
  for (Index r = 0; r < records; ++r)
    d.rows.segment(r * rows_of_record, rows_of_record) -=
        d.changes.col(0).segment(r * rows_of_record, rows_of_record) * d.shifts(r);
  return d;
}

FrequencyScatter scatter_of(const Draw& d) {
  return frequency_scatter(d.rows, d.jacobian, d.changes, labels(), static_cast<double>(d.rows.size()));
}

TEST(FrequencyScatter, VarianceIsUnbiasedAndShiftsAreFound) {
  const double sd = 0.004;
  double squares = 0, off = 0, most_off = 0;
  constexpr int draws = 300;
  for (unsigned seed = 0; seed < draws; ++seed) {
    const Draw d = draw(sd, seed);
    const FrequencyScatter found = scatter_of(d);
    squares += found.relative_sd * found.relative_sd / draws;
    EXPECT_LT(found.p_value, 1e-3);
    // A shift of all records is none: the frequency itself is fitted.
    const VectorXd told = found.shifts.col(0).array() - found.shifts.col(0).mean(),
                   is = d.shifts.array() - d.shifts.mean();
    off += (told - is).squaredNorm() / draws;
    // What is known of a shift of variance s^2 from rows u of unit noise has the variance s^2/(1 + s^2 u'u).
    for (Index r = 0; r < records; ++r)
      most_off += sd * sd /
                  (1 + sd * sd * d.changes.col(0).segment(r * rows_of_record, rows_of_record).squaredNorm()) /
                  draws;
  }
  // Four unknowns of 96 rows are fitted beside the shifts, and s is found from them.
  EXPECT_LT(off, 1.25 * most_off);
  // A variance from 23 differences scatters by sqrt(2/23) in each draw.
  EXPECT_NEAR(squares, sd * sd, 5 * sd * sd * std::sqrt(2.0 / 23 / draws));
}

TEST(FrequencyScatter, WithoutScatterTheAlarmIsAsRareAsItSays) {
  int below = 0;
  constexpr int draws = 1000;
  for (unsigned seed = 0; seed < draws; ++seed) below += scatter_of(draw(0, 10000 + seed)).p_value < 0.05;
  EXPECT_NEAR(below, 50, 5 * std::sqrt(50.0));
}

// Noise that is misjudged is no scatter between records.
TEST(FrequencyScatter, RowsThatVaryMoreThanTheyShouldAreNoScatter) {
  int alarms = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Draw d = draw(0, 20000 + seed);
    d.rows *= 5;
    alarms += scatter_of(d).p_value < 1e-3;
  }
  EXPECT_LE(alarms, 4);
}

TEST(FrequencyScatter, FewRecordsTellNothing) {
  const Draw d = draw(0.1, 3);
  std::vector<RowLabel> few = labels();
  for (RowLabel& label : few) label.record %= 4;
  EXPECT_EQ(frequency_scatter(d.rows, d.jacobian, d.changes, few, 96).relative_sd, 0);
}

// Rows a (1 + b d) with d the relative change of the only frequency, two records.
class TwoRecords : public Evidence {
 public:
  TwoRecords() : labels_(2 * rows_of_record) {
    for (std::size_t r = rows_of_record; r < labels_.size(); ++r) labels_[r].record = 1;
    std::mt19937 random(5);
    slope_ = 200 * random_matrix(size(), 1, random);
  }
  Index size() const override { return static_cast<Index>(labels_.size()); }
  const std::vector<RowLabel>& labels() const override { return labels_; }
  void freeze(const VectorXd&, double) override {}
  void evaluate(const VectorXd& unknowns, Eigen::Ref<VectorXd> rows) const override {
    rows = slope_ * (unknowns(0) / 7 - 1);
  }
  const VectorXd& slope() const { return slope_; }

 private:
  std::vector<RowLabel> labels_;
  VectorXd slope_;
};

// Rows of unit variance that scatter has made of covariance I + s^2 U U' are independent and of unit variance
// again, and no record has a part in another's.
TEST(FrequencyScatter, RowsAreOfUnitVarianceAgain) {
  auto evidence = std::make_unique<TwoRecords>();
  const VectorXd slope = evidence->slope();
  Discrepancy all;
  all.add(std::move(evidence));
  const double sd = 0.01;
  const VectorXd at = VectorXd::Constant(1, 7);
  const MatrixXd changes = all.frequency_changes(at, 1);
  all.admit_scatter(sd, 1);
  all.freeze(at);
  EXPECT_LT((changes.col(0) - slope).norm(), 1e-6 * slope.norm());
  const std::vector<std::size_t> which = {0};
  const VectorXd column = all.slopes(at, which, VectorXd::Constant(1, 1e-3), 1) / 1e-3 * 7;
  for (Index r = 0; r < 2; ++r) {
    const VectorXd u = slope.segment(r * rows_of_record, rows_of_record),
                   seen = column.segment(r * rows_of_record, rows_of_record);
    // (1 + s^2 u'u)^(-1/2) along u.
    EXPECT_LT((seen - u / std::sqrt(1 + sd * sd * u.squaredNorm())).norm(), 1e-6 * u.norm());
  }
  all.admit_scatter(0, 1);
  all.freeze(at);
  EXPECT_LT((all(VectorXd::Constant(1, 7.07)) - slope / 100).norm(), 1e-9);
}

}  // namespace
}  // namespace secular
