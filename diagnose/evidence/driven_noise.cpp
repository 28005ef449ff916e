#include "diagnose/evidence/driven_noise.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Motions that begin a little apart or are driven a little differently, by what was changed: each part of the
// state, each excitation.
struct Neighbours {
  StretchOfMotion still;
  std::vector<StretchOfMotion> moved;
  VectorXd still_error;
  std::vector<VectorXd> moved_error;
};

// What sample i has of the changes: states, accelerations, errors, each a column for every change.
struct Changes {
  MatrixXd states, accelerations, errors;
};

Neighbours neighbours_of(const SegmentModel& model, const SegmentTrial& trial, const std::vector<Index>& at_jumps,
                         bool driven_apart) {
  const Index parts = trial.state.size(), inputs = driven_apart ? trial.segment.excitation.rows() : 0;
  const VectorXd steps = state_steps(trial.state);
  std::vector<Segment> driven(static_cast<std::size_t>(inputs), trial.segment);
  std::vector<SegmentTrial> trials(1, trial);
  for (Index k = 0; k < parts; ++k) {
    trials.push_back(trial);
    trials.back().state(k) += steps(k);
  }
  for (Index j = 0; j < inputs; ++j) {
    Segment& segment = driven[static_cast<std::size_t>(j)];
    segment.excitation.row(j).array() += segment.excitation_noise_sd(j);
    trials.push_back({segment, trial.samples, trial.unknowns, trial.state, trial.change});
  }
  std::vector<StretchOfMotion> motions;
  std::vector<VectorXd> errors = model.errors(trials, nullptr, &motions);
  for (VectorXd& error : errors) error = silenced(std::move(error), trial.samples, at_jumps);
  return {
      motions.front(), {motions.begin() + 1, motions.end()}, errors.front(), {errors.begin() + 1, errors.end()}};
}

// What a sample reads of coloured noises; nothing where its errors do not count.
MatrixXd read_colours(const Segment& segment, Index channels, const std::vector<Index>& at_jumps, Index sample) {
  MatrixXd reading = MatrixXd::Zero(channels, static_cast<Index>(segment.coloured.size()));
  if (std::binary_search(at_jumps.begin(), at_jumps.end(), sample)) return reading;
  for (std::size_t c = 0; c < segment.coloured.size(); ++c)
    reading(static_cast<Index>(segment.coloured[c].channel), static_cast<Index>(c)) = 1;
  return reading;
}

Changes changes_at(const Neighbours& n, Index sample) {
  const Index modes = n.still.displacement.rows(), samples = n.still.displacement.cols(),
              channels = n.still_error.size() / samples, count = static_cast<Index>(n.moved.size());
  Changes c{MatrixXd(2 * modes, count), MatrixXd(modes, count), MatrixXd(channels, count)};
  for (Index m = 0; m < count; ++m) {
    const StretchOfMotion& moved = n.moved[static_cast<std::size_t>(m)];
    c.states.col(m) << moved.displacement.col(sample) - n.still.displacement.col(sample),
        moved.velocity.col(sample) - n.still.velocity.col(sample);
    c.accelerations.col(m) = moved.acceleration.col(sample) - n.still.acceleration.col(sample);
    const VectorXd& error = n.moved_error[static_cast<std::size_t>(m)];
    for (Index r = 0; r < channels; ++r)
      c.errors(r, m) = error(r * samples + sample) - n.still_error(r * samples + sample);
  }
  return c;
}

}  // namespace

DrivenNoise::DrivenNoise(const SegmentModel& model, const SegmentTrial& trial, const std::vector<Index>& at_jumps) {
  const Segment& s = trial.segment;
  const bool known = s.excitation.cols() > 0 && s.excitation_noise_sd.size() == s.excitation.rows() &&
                     s.excitation_noise_sd.maxCoeff() > 0;
  const auto colours = static_cast<Index>(s.coloured.size());
  if (!known && colours == 0) return;
  const Neighbours near = neighbours_of(model, trial, at_jumps, known);
  const Index parts = trial.state.size(), inputs = known ? s.excitation.rows() : 0, modes = parts / 2,
              states = parts + colours;
  MatrixXd covariance = MatrixXd::Zero(states, states);
  for (Index c = 0; c < colours; ++c)
    covariance(parts + c, parts + c) = std::pow(s.coloured[static_cast<std::size_t>(c)].sd, 2);
  VectorXd white = VectorXd::Ones(near.still_error.size() / trial.samples);  // variances
  for (const ColouredNoise& noise : s.coloured)
    white(static_cast<Index>(noise.channel)) = noise.white_sd * noise.white_sd;
  std::vector<Step> steps;
  for (Index i = 0; i < trial.samples; ++i) {
    const Changes now = changes_at(near, i);
    const Eigen::FullPivLU<MatrixXd> from(now.states.leftCols(parts).transpose());
    if (!from.isInvertible()) return;
    // Changes by state, then what a change of the excitation does beside its change of the state.
    const auto by_state = [&](const MatrixXd& changes) -> MatrixXd {
      return from.solve(changes.leftCols(parts).transpose()).transpose();
    };
    const MatrixXd beside = now.states.rightCols(inputs), reading = by_state(now.errors);
    MatrixXd push = MatrixXd::Zero(parts, inputs);
    push.bottomRows(modes) =
        s.sample_s * (now.accelerations.rightCols(inputs) - by_state(now.accelerations) * beside);
    // The state before this sample's noise, coloured noises, then the noise.
    MatrixXd both = MatrixXd::Identity(states + inputs, states + inputs);
    both.topLeftCorner(states, states) = covariance;
    Step step;
    step.reading.resize(reading.rows(), states + inputs);
    step.reading << reading, read_colours(s, reading.rows(), at_jumps, i),
        now.errors.rightCols(inputs) - reading * beside + 0.5 * reading * push;
    MatrixXd innovation = step.reading * both * step.reading.transpose();
    innovation.diagonal() += white;
    step.lower = innovation.llt().matrixL();
    step.gain = step.lower.triangularView<Eigen::Lower>().solve(step.reading * both).transpose();
    both -= step.gain * step.gain.transpose();
    step.transition = MatrixXd::Zero(states, states + inputs);
    if (i + 1 < trial.samples) {
      const MatrixXd on = by_state(changes_at(near, i + 1).states);
      step.transition.topLeftCorner(parts, parts) = on;
      step.transition.topRightCorner(parts, inputs) = on * push;
    }
    for (Index c = 0; c < colours; ++c)
      step.transition(parts + c, parts + c) =
          std::exp(-s.sample_s / s.coloured[static_cast<std::size_t>(c)].time_s);
    covariance = step.transition * both * step.transition.transpose();
    for (Index c = 0; c < colours; ++c) {
      const double keeps = step.transition(parts + c, parts + c), sd = s.coloured[static_cast<std::size_t>(c)].sd;
      covariance(parts + c, parts + c) += (1 - keeps * keeps) * sd * sd;
    }
    if (!covariance.allFinite() || !step.lower.allFinite()) return;
    steps.push_back(std::move(step));
  }
  steps_ = std::move(steps);
  inputs_ = inputs;
}

VectorXd DrivenNoise::whitened(VectorXd error) const {
  if (steps_.empty()) return error;
  const auto samples = static_cast<Index>(steps_.size()), channels = error.size() / samples;
  const Index parts = steps_.front().transition.rows();
  VectorXd both = VectorXd::Zero(steps_.front().transition.cols()), innovation(channels), next(parts);
  // Few numbers at a time: products that are written out take no memory of their own.
  for (Index i = 0; i < samples; ++i) {
    const Step& step = steps_[static_cast<std::size_t>(i)];
    auto here = error(Eigen::seqN(i, channels, samples));
    innovation = here;
    innovation.noalias() -= step.reading.lazyProduct(both);
    for (Index c = 0; c < channels; ++c) {
      for (Index before = 0; before < c; ++before) innovation(c) -= step.lower(c, before) * innovation(before);
      innovation(c) /= step.lower(c, c);
    }
    here = innovation;
    both.noalias() += step.gain.lazyProduct(innovation);
    next.noalias() = step.transition.lazyProduct(both);
    both.setZero();
    both.head(parts) = next;
  }
  return error;
}

MatrixXd DrivenNoise::expected(const VectorXd& white) const {
  if (steps_.empty()) return {};
  const auto samples = static_cast<Index>(steps_.size()), channels = white.size() / samples;
  const Index parts = steps_.front().transition.rows(), inputs = inputs_;
  MatrixXd noise(inputs, samples);
  VectorXd later = VectorXd::Zero(parts);
  for (Index i = samples - 1; i >= 0; --i) {
    const Step& step = steps_[static_cast<std::size_t>(i)];
    VectorXd both = step.transition.transpose() * later;
    VectorXd innovation = white(Eigen::seqN(i, channels, samples)) - step.gain.transpose() * both;
    step.lower.triangularView<Eigen::Lower>().transpose().solveInPlace(innovation);
    both += step.reading.transpose() * innovation;
    noise.col(i) = both.tail(inputs);
    later = both.head(parts);
  }
  return noise;
}

}  // namespace secular
