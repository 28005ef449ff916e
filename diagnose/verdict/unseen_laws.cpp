#include "diagnose/verdict/unseen_laws.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "diagnose/inference/directions.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of a law's length: what the model's own laws and the states leave of one that they hold is rounding of its
/// column.
constexpr double least_left = 0.1;

/// By what power of the amplitude a law changes rate of decay or frequency.
struct Law {
  bool of_damping;
  int power;
};
// Dry friction, quadratic and cubic damping; stiffness that grows with the amplitude, cubic and quintic stiffness.
constexpr std::array laws{Law{true, -1}, Law{true, 1}, Law{true, 2}, Law{false, 1}, Law{false, 2}, Law{false, 4}};

// Of a decay's computed reading: the part that grows with the amplitude, and that which a later motion adds.
struct Motion {
  VectorXd reading, later, amplitude;
};

Motion motion_of(const Segment& segment, Index channel, double frequency) {
  const Index count = segment.response.cols();
  Motion motion{segment.response.row(channel).transpose(), VectorXd::Zero(count), VectorXd::Zero(count)};
  motion.reading.array() -= motion.reading.mean();
  for (Index i = 1; i + 1 < count; ++i)
    motion.later(i) =
        (motion.reading(i + 1) - motion.reading(i - 1)) / (2 * std::sin(frequency * segment.sample_s));
  motion.amplitude = (motion.reading.array().square() + motion.later.array().square()).sqrt();
  return motion;
}

// What the law adds to a reading, to first order.
VectorXd column_of(const Law& law, const Motion& motion, double largest) {
  VectorXd column(motion.reading.size());
  double sum = 0;
  for (Index i = 0; i < column.size(); ++i) {
    column(i) = sum * (law.of_damping ? motion.reading(i) : motion.later(i));
    sum += std::pow(std::max(motion.amplitude(i) / largest, 1e-3), law.power);
  }
  return column;
}

// Rows of all records: the laws, and what an earlier begin or a larger one of each record adds.
struct LawColumns {
  MatrixXd laws, of_begins;
};

LawColumns columns_of(const Comparison& comparison, const Refit& fit) {
  const std::vector<RowLabel> labels = comparison.discrepancy.labels();
  const Index channels = static_cast<Index>(comparison.sensors.responses.size());
  std::vector<std::size_t> records;
  for (const RowLabel& label : labels)
    if (records.empty() || records.back() != label.record) records.push_back(label.record);
  LawColumns columns{MatrixXd::Zero(fit.rows.size(), static_cast<Index>(laws.size())),
                     MatrixXd::Zero(fit.rows.size(), 2 * static_cast<Index>(records.size()))};
  double largest = 0;
  Index row = 0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    row += 2;  // changes of stiffness and damping, which are in the readings
    for (const Segment& segment : comparison.segment_evidence->predicted(records[r], fit.unknowns, 1))
      for (Index c = 0; c < channels; ++c) {
        const Motion motion = motion_of(segment, c, fit.unknowns(0));
        if (largest == 0) largest = motion.amplitude.maxCoeff();
        const Index count = motion.reading.size();
        for (std::size_t l = 0; l < laws.size(); ++l)
          columns.laws.col(static_cast<Index>(l)).segment(row, count) = column_of(laws[l], motion, largest);
        columns.of_begins.col(2 * static_cast<Index>(r)).segment(row, count) = motion.reading;
        columns.of_begins.col(2 * static_cast<Index>(r) + 1).segment(row, count) = motion.later;
        row += count;
      }
  }
  return columns;
}

}  // namespace

bool UnseenLaws::is_seen() const {
  return p_value < diagnose_thresholds().gap_alarm;
}

UnseenLaws unseen_laws(const Comparison& comparison, const Refit& fit) {
  UnseenLaws result;
  result.moved = VectorXd::Zero(static_cast<Index>(fit.free.size()));
  if (fit.rank == 0 || fit.scale.size() != result.moved.size()) return result;
  const LawColumns columns = columns_of(comparison, fit);
  const MatrixXd to_unknowns = Directions(fit.jacobian).to_orthonormal(), model = fit.jacobian * to_unknowns;
  const MatrixXd begins = Eigen::HouseholderQR<MatrixXd>(columns.of_begins).householderQ() *
                          MatrixXd::Identity(fit.rows.size(), columns.of_begins.cols());
  double tried = 0, least_p = 1;
  for (std::size_t l = 0; l < laws.size(); ++l) {
    VectorXd law = columns.laws.col(static_cast<Index>(l));
    law -= begins * (begins.transpose() * law);
    const double length = law.norm();
    const VectorXd along = model.transpose() * law;
    law -= model * along;
    law -= begins * (begins.transpose() * law);
    const double left = law.norm();
    if (!(left > least_left * length)) continue;
    tried += 1;
    const double deviations = std::abs(law.dot(fit.rows)) / left;
    const VectorXd per_deviation = (fit.scale.cwiseProduct(to_unknowns * along) / left).cwiseAbs();
    result.moved = result.moved.cwiseMax(std::sqrt(std::max(0.0, deviations * deviations - 1)) * per_deviation);
    const double p = 2 * normal_upper_tail(deviations);
    if (p >= least_p) continue;
    least_p = p;
    result.deviations = deviations;
  }
  if (tried > 0) result.p_value = std::min(1.0, tried * least_p);
  return result;
}

}  // namespace secular
