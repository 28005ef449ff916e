#include "diagnose/evidence/taken_off.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

namespace secular {
namespace {

/// Foreign content of which a state makes all but this share, in the norm, is left in the readings: they hold it
/// as a state then, and rows see neither.
constexpr double least_own_share = 0.1;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

void take_foreign_content_off(const SegmentModel& model, FrozenSegment& frozen, const VectorXd& unknowns) {
  Segment& s = frozen.segment;
  const Index count = frozen.held, samples = frozen.samples();
  if (count == 0) return;
  const VectorXd error = frozen.seen(model.errors({frozen.trial(unknowns)}).front());
  // Beside the state: what a state does as well is no foreign content.
  MatrixXd seen_columns = frozen.seen_foreign_columns();
  const VectorXd lengths = seen_columns.colwise().norm().transpose();
  seen_columns.array().rowwise() /= lengths.transpose().array();
  const MatrixXd states = frozen.directions.of_state.rightCols(static_cast<Index>(2 * model.modes()));
  MatrixXd both(error.size(), count + states.cols());
  both << seen_columns, states;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> all;
  all.setThreshold(least_own_share);
  const VectorXd content =
      frozen.may_hold.leftCols(count) * all.compute(both).solve(error).head(count).cwiseQuotient(lengths);
  MatrixXd& taken = frozen.taken_off;
  if (taken.size() == 0) taken.setZero(s.response.rows(), samples);
  for (Index c = 0; c < s.response.rows(); ++c)
    taken.row(c) += s.noise_sd(c) * content.segment(c * samples, samples).transpose();
  s.response = frozen.measured.response - taken;
}

void take_driven_noise_off(const SegmentModel& model, FrozenSegment& frozen, const VectorXd& unknowns) {
  if (!frozen.driven_noise.is_of_excitation()) return;
  Segment& s = frozen.segment;
  const Index samples = frozen.samples();
  const std::vector<SegmentTrial> trial{frozen.trial(unknowns)};
  const VectorXd with = model.errors(trial).front();
  // Foreign content of any size says nothing of the noise.
  VectorXd white = frozen.seen(with);
  const MatrixXd foreign = orthonormal_beyond(MatrixXd(), frozen.seen_foreign_columns());
  white -= foreign * (foreign.transpose() * white);
  // Of errors r times as large in the square as noise makes them, where the model lacks something, one r-th is its.
  const double ratio = white.squaredNorm() / static_cast<double>(white.size());
  const MatrixXd noise = frozen.driven_noise.expected(white) / std::max(1.0, ratio);
  s.excitation -= s.excitation_noise_sd.asDiagonal() * at_half_samples(noise);
  const VectorXd without = model.errors(trial).front();
  for (Index c = 0; c < s.response.rows(); ++c)
    s.response.row(c) -= s.noise_sd(c) * (without - with).segment(c * samples, samples).transpose();
}

}  // namespace secular
