#include "diagnose/evidence/segment_rows.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <string>

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<RowLabel> segment_labels(const SegmentModel& model, const Segment& s) {
  std::vector<RowLabel> labels;
  RowLabel label;
  label.record = s.record;
  label.fold = s.fold;
  label.time_s = s.time_s;
  label.amplitude = 0.5 * s.response.row(0).cwiseAbs().maxCoeff();
  label.balance = true;
  for (std::size_t k = 0; k < model.modes(); ++k)
    for (const EffectComponent component : {EffectComponent::conservative, EffectComponent::dissipative}) {
      label.mode = k;
      label.place = std::string(model.model().coordinates[k]);
      label.component = component;
      label.harmonic = std::string(model.model().symbols[k].name);
      labels.push_back(label);
    }
  label.balance = false;
  label.component = EffectComponent::measurement;
  label.harmonic = "rest of the signal";
  for (Index c = 0; c < s.response.rows(); ++c) {
    label.place = model.sensors().response_names[static_cast<std::size_t>(c)];
    for (Index i = 0; i < s.response.cols(); ++i) {
      labels.push_back(label);
      labels.back().fold += fold_step * static_cast<int>(i * s.folds / s.response.cols());
    }
  }
  return labels;
}

std::vector<Index> SegmentRows::begins() const {
  std::vector<Index> all{0};
  for (std::size_t i = 0; i < segments.size(); ++i) all.push_back(all.back() + count(i));
  return all;
}

void SegmentRows::fill(std::size_t segment, VectorXd error, Eigen::Ref<VectorXd> rows) const {
  const FrozenSegment& f = segments[segment];
  const auto& [of_state, of_change, foreign] = f.directions;
  error /= f.widening;
  error -= of_state * (of_state.transpose() * error);
  VectorXd changes = VectorXd::Zero(of_change.cols());
  if (!f.segment.is_in_folds()) {
    changes = of_change.transpose() * error;
    error -= of_change * changes;
  }
  auto rest = rows.tail(error.size());
  if (noise.empty()) {
    rows.head(changes.size()) = changes;
    rest = error;
    return;
  }
  const SegmentNoise& own = noise[segment];
  rows.head(changes.size()) = changes.cwiseQuotient(own.change_sd);
  own.whiten(error, rest);
  rest /= std::max(1.0, own.disturbance);
}

VectorXd SegmentRows::by_balance(VectorXd rows) const {
  const std::vector<Index> first = begins();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const FrozenSegment& f = segments[i];
    if (!f.segment.is_in_folds()) continue;
    const Eigen::MatrixXd& of_change = f.directions.of_change;
    auto rest = rows.segment(first[i] + of_change.cols(), of_change.rows());
    const VectorXd changes = of_change.transpose() * rest;
    rest -= of_change * changes;
    rows.segment(first[i], changes.size()) = changes;
  }
  return rows;
}

Index freedom_of(const SegmentRows& rows) {
  const auto of_state = static_cast<Index>(2 * rows.model.modes());
  Index count = 0;
  for (const FrozenSegment& f : rows.segments)
    count += f.segment.response.size() - of_state -
             static_cast<Index>(f.silent.size()) * f.segment.response.rows() - f.may_hold.cols();
  return count;
}

}  // namespace secular
