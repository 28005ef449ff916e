#include "diagnose/evidence/frozen_directions.hpp"

#include <vector>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the square of a natural frequency, or of it: stiffness and damping that are added for a difference.
constexpr double changed_by = 1e-6;

// A segment as it is, then with each part of the state and each mode's stiffness and damping changed.
void add_trials(const FrozenSegment& f, std::size_t modes, const VectorXd& unknowns,
                std::vector<SegmentTrial>& trials) {
  const VectorXd steps = state_steps(f.state);
  trials.push_back(f.trial(unknowns));
  for (Index row = 0; row < f.state.size(); ++row) {
    trials.push_back(f.trial(unknowns));
    trials.back().state(row) += steps(row);
  }
  for (std::size_t k = 0; k < modes; ++k) {
    const double w = unknowns(static_cast<Index>(k));
    for (const LinearChange& change : {LinearChange{changed_by * w * w, 0}, LinearChange{0, changed_by * w}}) {
      trials.push_back(f.trial(unknowns));
      trials.back().change.resize(modes);
      trials.back().change[k] = change;
    }
  }
}

MatrixXd columns_of(std::span<const VectorXd> moved, const VectorXd& still, double scale) {
  MatrixXd columns(still.size(), static_cast<Index>(moved.size()));
  for (std::size_t i = 0; i < moved.size(); ++i) columns.col(static_cast<Index>(i)) = (moved[i] - still) * scale;
  return columns;
}

}  // namespace

void freeze_directions(const SegmentModel& model, std::span<FrozenSegment> segments, const VectorXd& unknowns) {
  const std::size_t both = 2 * model.modes(), of_one = 1 + 2 * both;
  std::vector<const FrozenSegment*> of;
  std::vector<SegmentTrial> trials;
  for (const FrozenSegment& f : segments) {
    of.insert(of.end(), of_one, &f);
    add_trials(f, model.modes(), unknowns, trials);
  }
  const std::vector<VectorXd> errors = seen_errors(model, of, std::move(trials));
  std::span<const VectorXd> rest(errors);
  for (FrozenSegment& f : segments) {
    f.directions = ErrorDirections(f.seen_foreign_columns(), columns_of(rest.subspan(1, both), rest[0], 1e4),
                                   columns_of(rest.subspan(1 + both, both), rest[0], 1 / changed_by));
    rest = rest.subspan(of_one);
  }
}

}  // namespace secular
