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

/// A part of a segment whose motions are computed anew: what is damped by the cube of a velocity brings motions
/// that begin apart together within a segment, and their differences to rounding.
constexpr Index part_samples = 32;

// Motions of a part that begin a little apart or are driven a little differently, by what was changed: each part of
// the state, each excitation.
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

Segment part_of_segment(const Segment& segment, Index first, Index count) {
  Segment part;
  part.time_s = segment.time_s;
  part.frequency_offset = segment.frequency_offset;
  part.sample_s = segment.sample_s;
  part.substeps = segment.substeps;
  part.noise_sd = segment.noise_sd;
  if (segment.excitation.cols() > 0) part.excitation = segment.excitation.middleCols(2 * first, 2 * count - 1);
  part.response = segment.response.middleCols(first, count);
  return part;
}

// The parts of a segment, each as it is and driven by more, by excitation.
class Parts {
 public:
  Parts(const SegmentModel& model, const SegmentTrial& trial, Index inputs)
      : length_(model.remembers(trial.unknowns) ? trial.samples : part_samples) {
    std::vector<StretchOfMotion> whole;
    model.errors({trial}, nullptr, &whole);
    const StretchOfMotion& still = whole.front();
    const Index parts = trial.state.size();
    // As long as that; the last one takes less than half a part more, or is no shorter than half of one.
    const Index count = std::max<Index>(1, (trial.samples - 1 + length_ / 2) / length_);
    std::vector<Segment> segments;
    segments.reserve(static_cast<std::size_t>(count * (1 + inputs)));
    std::vector<SegmentTrial> trials;
    for (Index p = 0; p < count; ++p) {
      // The first sample of the next part is the last of this one: states are carried on to it.
      const Index first = p * length_, samples = p + 1 < count ? length_ + 1 : trial.samples - first;
      VectorXd state = trial.state;
      if (p > 0) state << still.displacement.col(first), still.velocity.col(first);
      segments.push_back(part_of_segment(trial.segment, first, samples));
      const Segment& part = segments.back();
      trials.push_back({part, samples, trial.unknowns, state, trial.change});
      const VectorXd steps = state_steps(state);
      for (Index k = 0; k < parts; ++k) {
        trials.push_back(trials[trials.size() - static_cast<std::size_t>(1 + k)]);
        trials.back().state(k) += steps(k);
      }
      for (Index j = 0; j < inputs; ++j) {
        segments.push_back(part);
        segments.back().excitation.row(j).array() += trial.segment.excitation_noise_sd(j);
        trials.push_back({segments.back(), samples, trial.unknowns, state, trial.change});
      }
    }
    take(model, trials, static_cast<std::size_t>(1 + parts + inputs));
  }

  /// Of a sample of the segment.
  Changes changes_at(Index sample) const {
    const std::size_t p = part_of(sample);
    return changes_in(all_[p], sample - static_cast<Index>(p) * length_);
  }
  /// From a sample of the segment, not its last, to the next one; in the same part.
  MatrixXd states_after(Index sample) const {
    const std::size_t p = part_of(sample);
    return changes_in(all_[p], sample + 1 - static_cast<Index>(p) * length_).states;
  }

 private:
  std::size_t part_of(Index sample) const {
    return std::min(static_cast<std::size_t>(sample / length_), all_.size() - 1);
  }

  void take(const SegmentModel& model, const std::vector<SegmentTrial>& trials, std::size_t of_a_part) {
    std::vector<StretchOfMotion> motions;
    std::vector<VectorXd> errors = model.errors(trials, nullptr, &motions);
    for (std::size_t first = 0; first < trials.size(); first += of_a_part) {
      Neighbours near{std::move(motions[first]), {}, std::move(errors[first]), {}};
      for (std::size_t m = first + 1; m < first + of_a_part; ++m) {
        near.moved.push_back(std::move(motions[m]));
        near.moved_error.push_back(std::move(errors[m]));
      }
      all_.push_back(std::move(near));
    }
  }

  static Changes changes_in(const Neighbours& n, Index sample) {
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

  Index length_;
  std::vector<Neighbours> all_;
};

bool is_silent(const std::vector<Index>& at_jumps, Index sample) {
  return std::binary_search(at_jumps.begin(), at_jumps.end(), sample);
}

// What a sample reads of coloured noises; nothing where its errors do not count.
MatrixXd read_colours(const Segment& segment, Index channels, const std::vector<Index>& at_jumps, Index sample) {
  MatrixXd reading = MatrixXd::Zero(channels, static_cast<Index>(segment.coloured.size()));
  if (is_silent(at_jumps, sample)) return reading;
  for (std::size_t c = 0; c < segment.coloured.size(); ++c)
    reading(static_cast<Index>(segment.coloured[c].channel), static_cast<Index>(c)) = 1;
  return reading;
}

}  // namespace

DrivenNoise::DrivenNoise(const SegmentModel& model, const SegmentTrial& trial, const std::vector<Index>& at_jumps) {
  const Segment& s = trial.segment;
  const bool known = s.excitation.cols() > 0 && s.excitation_noise_sd.size() == s.excitation.rows() &&
                     s.excitation_noise_sd.maxCoeff() > 0;
  const auto colours = static_cast<Index>(s.coloured.size());
  if (!known && colours == 0) return;
  const Index parts = trial.state.size(), inputs = known ? s.excitation.rows() : 0, modes = parts / 2,
              states = parts + colours;
  const Parts near(model, trial, inputs);
  MatrixXd covariance = MatrixXd::Zero(states, states);
  for (Index c = 0; c < colours; ++c)
    covariance(parts + c, parts + c) = std::pow(s.coloured[static_cast<std::size_t>(c)].sd, 2);
  VectorXd white = VectorXd::Ones(s.response.rows());  // variances
  for (const ColouredNoise& noise : s.coloured)
    white(static_cast<Index>(noise.channel)) = noise.white_sd * noise.white_sd;
  std::vector<Step> steps;
  for (Index i = 0; i < trial.samples; ++i) {
    Changes now = near.changes_at(i);
    if (is_silent(at_jumps, i)) now.errors.setZero();
    const Eigen::FullPivLU<MatrixXd> from(now.states.leftCols(parts).transpose());
    if (!from.isInvertible()) return;
    // Changes by state, then what a change of the excitation does beside its change of the state.
    const auto by_state = [&](const MatrixXd& changes) -> MatrixXd {
      return from.solve(MatrixXd(changes.leftCols(parts).transpose())).transpose();
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
    step.gain = step.lower.triangularView<Eigen::Lower>().solve(MatrixXd(step.reading * both)).transpose();
    both -= step.gain * step.gain.transpose();
    step.transition = MatrixXd::Zero(states, states + inputs);
    if (i + 1 < trial.samples) {
      const MatrixXd on = by_state(near.states_after(i));
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
