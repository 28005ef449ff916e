#include "diagnose/evidence/segment_evidence.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "diagnose/evidence/state_search.hpp"
#include "diagnose/thresholds.hpp"
#include "numerics/hertz.hpp"
#include "numerics/in_parallel.hpp"
#include "numerics/median.hpp"
#include "numerics/third_differences.hpp"

namespace secular {
namespace {

/// Fewest segments of one decay that tell a repeatability.
constexpr auto& fewest_segments = diagnose_thresholds().fewest_segments;

/// What remains of a decay's segments changes by this factor's logarithm from one to the next, beyond any smooth
/// law, where the record itself is disturbed (slips of its clock, knocks).
constexpr auto& irregular = diagnose_thresholds().irregular;

/// Foreign content of which a state makes all but this share, in the norm, is left in the readings: they hold it
/// as a state then, and rows see neither.
constexpr double told_apart = 0.1;

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Orthonormal columns that span what `columns` adds to `basis`.
MatrixXd beyond(const MatrixXd& basis, MatrixXd columns) {
  for (int pass = 0; pass < 2; ++pass)
    if (basis.cols() > 0) columns -= basis * (basis.transpose() * columns);
  for (Index i = 0; i < columns.cols(); ++i) {
    for (int pass = 0; pass < 2; ++pass)
      for (Index j = 0; j < i; ++j) columns.col(i) -= columns.col(j) * columns.col(j).dot(columns.col(i));
    const double length = columns.col(i).norm();
    if (length > 1e-12)
      columns.col(i) /= length;
    else
      columns.col(i).setZero();
  }
  return columns;
}

// Standard deviation of what is independent from one value to the next, by the median of |normal|, 0.6745.
double roughness(const std::vector<double>& values) {
  std::vector<double> third = third_differences(values);
  for (double& difference : third) difference = std::abs(difference);
  return upper_median(std::move(third)) / (0.6745 * std::sqrt(third_difference_variance));
}

double lower_quartile(std::vector<double> values) {
  const auto quarter = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), quarter, values.end());
  return *quarter;
}

// Variance of what is white in a series, channel after channel: anything sampled this densely is smooth. Samples
// that do not count are zero in all channels, and leave differences that much less.
double white_variance(const VectorXd& error, Index samples, const std::vector<Index>& silent) {
  VectorXd live = VectorXd::Ones(samples);
  for (const Index sample : silent) live(sample) = 0;
  double sum = 0, count = 0;
  for (Index first = 0; first + samples <= error.size(); first += samples) {
    const std::vector<double> third = third_differences({error.data() + first, static_cast<std::size_t>(samples)});
    for (std::size_t d = 0; d < third.size(); ++d) {
      const auto i = static_cast<Index>(d);
      sum += third[d] * third[d];
      count += live(i) + 9 * live(i + 1) + 9 * live(i + 2) + live(i + 3);
    }
  }
  return count > 0 ? sum / count : 1;
}

// What is white in the errors, whatever the channel's noise floor was taken for, from the variances of segments.
double white_level(const std::vector<double>& white) {
  return std::max(1e-3,
                  std::sqrt(std::accumulate(white.begin(), white.end(), 0.0) / static_cast<double>(white.size())));
}

// Root mean square of the loudest channel, in units of its noise.
double loudness(const Segment& s) {
  return (s.response.rowwise().norm().array() / s.noise_sd.array()).maxCoeff() /
         std::sqrt(static_cast<double>(s.response.cols()));
}

// Samples at the end of a driven segment that do not count beside errors widened by this share of the motion: the
// finer the errors, the more turns of the lowest mode count, from where something drives (docs/inference.md (40)).
// Over n turns a natural frequency that is wrong by d of itself turns the motion by 2 pi n d, and where that is
// half a turn a fit finds no way.
Index beyond_horizon(const Segment& s, double share, double lowest) {
  if (s.excitation.cols() == 0) return 0;
  constexpr double whole_from = 0.01;  // the finest of wide errors
  const double turns = std::max(diagnose_thresholds().decay_turns,
                                diagnose_thresholds().driven_turns * std::min(1.0, whole_from / share));
  const double least = diagnose_thresholds().drives_from * s.excitation.cwiseAbs().maxCoeff();
  Index begin = 0;
  while (begin < s.response.cols() && !(s.excitation.col(2 * begin).cwiseAbs().maxCoeff() > least)) ++begin;
  const double counted = static_cast<double>(begin) + std::ceil(turns * two_pi / lowest / s.sample_s);
  return s.response.cols() - static_cast<Index>(std::min(static_cast<double>(s.response.cols()), counted));
}

// Readings at the samples are what they are; halfway between they are stronger or later. Two thirds of what a
// signal does are of there (Simpson's rule).
constexpr double part_between = 2.0 / 3;

Segment stronger_between_samples(Segment s, double share) {
  for (Index i = 1; i < s.excitation.cols(); i += 2) s.excitation.col(i) *= 1 + share / part_between;
  return s;
}

Segment later_between_samples(Segment s, double late_s) {
  for (Index i = 1; i + 1 < s.excitation.cols(); i += 2)
    s.excitation.col(i) -= late_s / part_between / s.sample_s * (s.excitation.col(i + 1) - s.excitation.col(i - 1));
  return s;
}

// Of orthonormal columns of errors, channel after channel.
VectorXd sd_of_changes(const NoiseInCosines& noise, const MatrixXd& basis) {
  const Index samples = noise.cosines.rows();
  VectorXd squares = VectorXd::Zero(basis.cols());
  for (Index c = 0; c < noise.sd.cols(); ++c)
    squares += (noise.sd.col(c).asDiagonal() * noise.cosines * basis.middleRows(c * samples, samples))
                   .colwise()
                   .squaredNorm()
                   .transpose();
  return squares.cwiseSqrt();
}

}  // namespace

SegmentEvidence::SegmentEvidence(const CompiledModel& model, std::vector<StateForce> forces, SensorModel sensors,
                                 FaultTable table, std::vector<Segment> segments, unsigned threads)
    : SegmentEvidence(SegmentModel(model, std::move(forces), std::move(sensors), std::move(table)),
                      std::move(segments), threads) {}

SegmentEvidence::SegmentEvidence(SegmentModel model, std::vector<Segment> segments, unsigned threads)
    : model_(std::move(model)),
      measured_(std::move(segments)),
      segments_(measured_),
      threads_(threads),
      frozen_(segments_.size()) {
  for (const Segment& s : segments_) {
    foreign_.push_back(foreign_columns(s));
    RowLabel label;
    label.record = s.record;
    label.fold = s.fold;
    label.time_s = s.time_s;
    label.amplitude = 0.5 * s.response.row(0).cwiseAbs().maxCoeff();
    label.balance = true;
    for (std::size_t k = 0; k < model_.modes(); ++k)
      for (const EffectComponent component : {EffectComponent::conservative, EffectComponent::dissipative}) {
        label.mode = k;
        label.place = std::string(model_.model().coordinates[k]);
        label.component = component;
        label.harmonic = std::string(model_.model().symbols[k].name);
        labels_.push_back(label);
      }
    label.balance = false;
    label.component = EffectComponent::measurement;
    label.harmonic = "rest of the signal";
    for (Index c = 0; c < s.response.rows(); ++c) {
      label.place = model_.sensors().response_names[static_cast<std::size_t>(c)];
      labels_.insert(labels_.end(), static_cast<std::size_t>(s.response.cols()), label);
    }
  }
}

Index SegmentEvidence::freedom() const {
  Index silent = 0;
  for (const Frozen& f : frozen_) silent += static_cast<Index>(f.silent.size() * model_.sensors().responses.size());
  Index foreign = 0;
  for (const MatrixXd& columns : foreign_) foreign += columns.cols();
  return size() - static_cast<Index>(4 * model_.modes() * segments_.size()) - silent - foreign;
}

std::vector<VectorXd> SegmentEvidence::frozen_errors(const std::vector<std::size_t>& segments,
                                                     const std::vector<SegmentTrial>& trials) const {
  std::vector<VectorXd> all = model_.errors(trials);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = seen(segments[i], std::move(all[i]));
  return all;
}

std::vector<VectorXd> SegmentEvidence::frozen_errors(const VectorXd& unknowns) const {
  std::vector<SegmentTrial> trials;
  for (std::size_t i = 0; i < segments_.size(); ++i) trials.push_back(frozen_trial(i, unknowns));
  return frozen_errors(all_segments(), trials);
}

std::vector<std::size_t> SegmentEvidence::all_segments() const {
  std::vector<std::size_t> all(segments_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

void SegmentEvidence::freeze_states(std::size_t first, std::size_t end, const VectorXd& unknowns) {
  std::vector<VectorXd> states = states_at(first, end, unknowns, Stretch::to_the_horizon);
  for (std::size_t i = first; i < end; ++i) {
    frozen_[i].state = std::move(states[i - first]);
    frozen_[i].silent.clear();
  }
  if (model_.sensors().derivatives == 2) silence_jumps(first, end, unknowns);
  for (std::size_t i = first; i < end; ++i)
    for (Index k = horizon(i); k < segments_[i].response.cols(); ++k) frozen_[i].silent.push_back(k);
}

void SegmentEvidence::silence_jumps(std::size_t first, std::size_t end, const VectorXd& unknowns) {
  std::vector<SegmentTrial> trials;
  for (std::size_t i = first; i < end; ++i)
    trials.push_back({segments_[i], horizon(i), unknowns, frozen_[i].state});
  std::vector<std::vector<Index>> jumps;
  model_.errors(trials, &jumps);
  std::vector<StateSearch> searches;
  for (std::size_t i = first; i < end; ++i) {
    std::vector<Index>& at = frozen_[i].silent;
    for (const Index before : jumps[i - first])
      for (const Index sample : {before, before + 1})
        if (at.empty() || at.back() < sample) at.push_back(sample);
    if (!at.empty()) searches.push_back({segments_[i], frozen_[i].state, horizon(i), at});
  }
  improve_states(model_, unknowns, searches);
  auto found = searches.begin();
  for (std::size_t i = first; i < end; ++i)
    if (!frozen_[i].silent.empty()) frozen_[i].state = (found++)->state;
}

std::vector<VectorXd> SegmentEvidence::states_at(std::size_t first, std::size_t end, const VectorXd& unknowns,
                                                 Stretch stretch) const {
  std::vector<VectorXd> states;
  std::vector<Index> counted;
  for (std::size_t i = first; i < end; ++i) {
    states.push_back(frozen_[i].state);
    counted.push_back(stretch == Stretch::whole ? segments_[i].response.cols() : horizon(i));
  }
  find_states(model_, std::span(segments_).subspan(first, end - first), counted, unknowns, states);
  return states;
}

void SegmentEvidence::freeze_bases(std::size_t first, std::size_t end, const VectorXd& unknowns) {
  const auto modes = model_.modes();
  const std::size_t of_one = 1 + 4 * modes;
  // As it is, then with each part of the state and each mode's stiffness and damping changed.
  std::vector<std::size_t> segments;
  std::vector<SegmentTrial> trials;
  for (std::size_t s = first; s < end; ++s) {
    const VectorXd& state = frozen_[s].state;
    const VectorXd steps = state_steps(state);
    segments.insert(segments.end(), of_one, s);
    const std::size_t still = trials.size();
    for (std::size_t i = 0; i < of_one; ++i) trials.push_back(frozen_trial(s, unknowns));
    for (std::size_t i = 0; i < 2 * modes; ++i) {
      const auto row = static_cast<Index>(i);
      trials[still + 1 + i].state(row) += steps(row);
    }
    for (std::size_t k = 0; k < modes; ++k) {
      const double w = unknowns(static_cast<Index>(k));
      const std::size_t changed = still + 1 + 2 * modes + 2 * k;
      for (const std::size_t i : {changed, changed + 1}) trials[i].change.resize(modes);
      trials[changed].change[k].stiffness = 1e-6 * w * w;
      trials[changed + 1].change[k].damping = 1e-6 * w;
    }
  }
  const std::vector<VectorXd> errors = frozen_errors(segments, trials);
  for (std::size_t s = first; s < end; ++s) {
    const std::size_t still = (s - first) * of_one;
    const auto differences = [&](std::size_t changed, double scale) {
      MatrixXd columns(errors[still].size(), static_cast<Index>(2 * modes));
      for (std::size_t i = 0; i < 2 * modes; ++i)
        columns.col(static_cast<Index>(i)) = (errors[still + changed + i] - errors[still]) * scale;
      return columns;
    };
    Frozen& f = frozen_[s];
    const MatrixXd states = differences(1, 1e4), foreign = seen_foreign_columns(s);
    f.state_basis.resize(states.rows(), foreign.cols() + states.cols());
    f.state_basis << beyond(MatrixXd(), foreign), MatrixXd::Zero(states.rows(), states.cols());
    f.state_basis.rightCols(states.cols()) = beyond(f.state_basis.leftCols(foreign.cols()), states);
    f.change_basis = beyond(f.state_basis, differences(1 + 2 * modes, 1e6));
  }
}

Index SegmentEvidence::foreign_count(std::size_t segment) const {
  return foreign_[segment].cols() - (coarse_ ? tone_count(segments_[segment]) : 0);
}

MatrixXd SegmentEvidence::seen_foreign_columns(std::size_t segment) const {
  MatrixXd columns = foreign_[segment].leftCols(foreign_count(segment));
  for (auto column : columns.colwise()) column = seen(segment, column);
  return columns;
}

void SegmentEvidence::take_foreign_content_off(std::size_t segment, const VectorXd& unknowns) {
  Segment& s = segments_[segment];
  const Index count = foreign_count(segment), samples = s.response.cols();
  if (count == 0) return;
  const VectorXd error = frozen_errors({segment}, {frozen_trial(segment, unknowns)}).front();
  // Beside the state: what a state does as well is no foreign content.
  MatrixXd seen_columns = seen_foreign_columns(segment);
  const VectorXd lengths = seen_columns.colwise().norm().transpose();
  seen_columns.array().rowwise() /= lengths.transpose().array();
  const MatrixXd states = frozen_[segment].state_basis.rightCols(static_cast<Index>(2 * model_.modes()));
  MatrixXd both(error.size(), count + states.cols());
  both << seen_columns, states;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> all;
  all.setThreshold(told_apart);
  const VectorXd content =
      foreign_[segment].leftCols(count) * all.compute(both).solve(error).head(count).cwiseQuotient(lengths);
  MatrixXd& taken = frozen_[segment].foreign;
  if (taken.size() == 0) taken.setZero(s.response.rows(), samples);
  for (Index c = 0; c < s.response.rows(); ++c)
    taken.row(c) += s.noise_sd(c) * content.segment(c * samples, samples).transpose();
  s.response = measured_[segment].response - taken;
}

void SegmentEvidence::take_driven_noise_off(std::size_t segment, const VectorXd& unknowns) {
  if (!frozen_[segment].driven_noise.is_of_excitation()) return;
  Segment& s = segments_[segment];
  const Index samples = s.response.cols();
  const std::vector<SegmentTrial> trial{frozen_trial(segment, unknowns)};
  const VectorXd with = model_.errors(trial).front();
  // Foreign content of any size says nothing of the noise.
  VectorXd white = seen(segment, with);
  const MatrixXd foreign = beyond(MatrixXd(), seen_foreign_columns(segment));
  white -= foreign * (foreign.transpose() * white);
  // Of errors r times as large in the square as noise makes them, where the model lacks something, one r-th is its.
  const double ratio = white.squaredNorm() / static_cast<double>(white.size());
  const MatrixXd noise = frozen_[segment].driven_noise.expected(white) / std::max(1.0, ratio);
  s.excitation -= s.excitation_noise_sd.asDiagonal() * at_half_samples(noise);
  const VectorXd without = model_.errors(trial).front();
  for (Index c = 0; c < s.response.rows(); ++c)
    s.response.row(c) -= s.noise_sd(c) * (without - with).segment(c * samples, samples).transpose();
}

void SegmentEvidence::freeze_motions(std::size_t first, std::size_t end, const VectorXd& unknowns) {
  freeze_states(first, end, unknowns);
  for (std::size_t i = first; i < end; ++i)
    frozen_[i].driven_noise =
        coarse_ ? DrivenNoise() : DrivenNoise(model_, frozen_trial(i, unknowns), frozen_[i].silent);
}

void SegmentEvidence::freeze(const VectorXd& unknowns, double coarse) {
  coarse_ = coarse > 0;
  const double lowest = unknowns.head(static_cast<Index>(model_.modes())).minCoeff();
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    frozen_[i].widening = coarse > 0 ? std::hypot(1.0, std::sqrt(coarse) * loudness(segments_[i])) : 1;
    frozen_[i].beyond_horizon = coarse > 0 ? beyond_horizon(measured_[i], std::sqrt(coarse), lowest) : 0;
  }
  const std::size_t parts = std::min<std::size_t>(std::max(1U, threads_), segments_.size());
  in_parallel(parts, threads_, [&](std::size_t part) {
    const std::size_t first = part * segments_.size() / parts, end = (part + 1) * segments_.size() / parts;
    for (std::size_t i = first; i < end; ++i) {
      segments_[i].excitation = measured_[i].excitation;
      segments_[i].response = measured_[i].response;
      if (frozen_[i].foreign.size() > 0) segments_[i].response -= frozen_[i].foreign;
    }
    freeze_motions(first, end, unknowns);
    bool any_foreign = false;
    for (std::size_t i = first; i < end; ++i) any_foreign = any_foreign || foreign_count(i) > 0;
    if (any_foreign) {
      freeze_bases(first, end, unknowns);
      for (std::size_t i = first; i < end; ++i) take_foreign_content_off(i, unknowns);
      freeze_motions(first, end, unknowns);
    }
    for (std::size_t i = first; i < end; ++i) take_driven_noise_off(i, unknowns);
    freeze_bases(first, end, unknowns);
  });
  if (coarse_) noise_.clear();
  if (!coarse_) measure_noise(unknowns);
}

std::vector<SegmentEvidence::LeftOfSegment> SegmentEvidence::left_by(const VectorXd& unknowns) const {
  const std::vector<VectorXd> errors = frozen_errors(unknowns);
  std::vector<LeftOfSegment> all;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Frozen& f = frozen_[i];
    LeftOfSegment left;
    left.white = white_variance(errors[i], segments_[i].response.cols(), f.silent);
    left.changes = f.change_basis.transpose() * errors[i];
    left.rest = errors[i] - f.state_basis * (f.state_basis.transpose() * errors[i]) - f.change_basis * left.changes;
    const auto silent = static_cast<Index>(f.silent.size()) * segments_[i].response.rows();
    left.rest_rms =
        left.rest.norm() /
        std::sqrt(static_cast<double>(errors[i].size() - silent - f.state_basis.cols() - f.change_basis.cols()));
    all.push_back(std::move(left));
  }
  return all;
}

std::shared_ptr<const NoiseInCosines> SegmentEvidence::coloured_noise(const std::vector<LeftOfSegment>& left,
                                                                      const VectorXd& unknowns) const {
  std::vector<std::size_t> alike;
  for (std::size_t i = 0; i < segments_.size(); ++i)
    if (segments_[i].excitation.cols() == 0 &&
        (alike.empty() || segments_[i].response.cols() == segments_[alike.front()].response.cols()))
      alike.push_back(i);
  // What one decay alone leaves may be its motion's as well.
  if (alike.size() < fewest_segments || segments_[alike.front()].record == segments_[alike.back()].record)
    return nullptr;
  std::vector<double> rest, white;
  for (const std::size_t i : alike) {
    rest.push_back(left[i].rest_rms);
    white.push_back(left[i].white);
  }
  NoiseInCosines noise;
  noise.least = white_level(white);
  if (!(lower_quartile(std::move(rest)) > noise.least)) return nullptr;
  const Index samples = segments_[alike.front()].response.cols(),
              channels = segments_[alike.front()].response.rows(), count = static_cast<Index>(alike.size());
  std::vector<Index> of_motion;
  for (std::size_t k = 0; k < model_.modes(); ++k)
    of_motion.push_back(std::lround(unknowns(static_cast<Index>(k)) * segments_[alike.front()].sample_s *
                                    static_cast<double>(samples) / std::numbers::pi));
  noise.cosines = cosines(samples);
  noise.sd.resize(samples, channels);
  for (Index c = 0; c < channels; ++c) {
    const auto of_channel = Eigen::seqN(c * samples, samples);
    CosineStretches stretches{MatrixXd(samples, count), MatrixXd::Ones(samples, count)};
    for (Index i = 0; i < count; ++i) {
      const std::size_t segment = alike[static_cast<std::size_t>(i)];
      stretches.values.col(i) = noise.cosines * left[segment].rest(of_channel);
      stretches.freedom.col(i).array() -=
          static_cast<double>(frozen_[segment].silent.size()) / static_cast<double>(samples);
      for (const MatrixXd* basis : {&frozen_[segment].state_basis, &frozen_[segment].change_basis})
        stretches.freedom.col(i) -= (noise.cosines * (*basis)(of_channel, Eigen::all)).rowwise().squaredNorm();
    }
    noise.sd.col(c) = noise_by_band(stretches, of_motion, noise.least);
  }
  return std::make_shared<const NoiseInCosines>(std::move(noise));
}

// What the first rows repeat to from segment to segment is what noise makes of them where the segments are too few
// to tell.
SegmentEvidence::Noise SegmentEvidence::noise_of(std::span<const LeftOfSegment> left, std::size_t first,
                                                 std::shared_ptr<const NoiseInCosines> coloured) const {
  const Segment& s = segments_[first];
  std::vector<double> white, rest;
  for (const LeftOfSegment& l : left) {
    white.push_back(l.white);
    rest.push_back(l.rest_rms);
  }
  const double level = white_level(white);
  const Index changes = left.front().changes.size();
  Noise noise{VectorXd::Constant(changes, level), level};
  if (s.excitation.cols() > 0) return noise;
  const bool repeats = left.size() >= fewest_segments;
  if (coloured && coloured->cosines.rows() == s.response.cols()) {
    if (!repeats) noise.change_sd = sd_of_changes(*coloured, frozen_[first].change_basis);
    noise.coloured = std::move(coloured);
  } else if (repeats) {
    noise.rest_sd = std::max(level, lower_quartile(std::move(rest)));
  }
  for (Index row = 0; repeats && row < changes; ++row) {
    std::vector<double> series;
    for (const LeftOfSegment& l : left) series.push_back(l.changes(row));
    noise.change_sd(row) = std::max(noise.change_sd(row), roughness(series));
  }
  return noise;
}

void SegmentEvidence::measure_noise(const VectorXd& unknowns) {
  if (noise_is_known_) {
    noise_.assign(segments_.size(), {VectorXd::Ones(static_cast<Index>(2 * model_.modes())), 1});
    return;
  }
  const std::vector<LeftOfSegment> left = left_by(unknowns);
  const std::shared_ptr<const NoiseInCosines> coloured = coloured_noise(left, unknowns);
  std::vector<Noise> found;
  for (std::size_t first = 0, end = 0; first < segments_.size(); first = end) {
    while (end < segments_.size() && segments_[end].record == segments_[first].record) ++end;
    const bool repeats = segments_[first].excitation.cols() == 0 && end - first >= fewest_segments;
    const Noise noise = noise_of(std::span(left).subspan(first, end - first), first, coloured);
    found.insert(found.end(), end - first, noise);
    for (std::size_t i = first; repeats && i < end && !noise_.empty(); ++i)
      found[i].change_sd = found[i].change_sd.cwiseMax(noise_[i].change_sd);
    std::vector<double> in_noise, logarithm;
    for (std::size_t i = first; i < end; ++i) {
      VectorXd rows(left[i].rest.size());
      whiten(noise, left[i].rest, rows);
      in_noise.push_back(left[i].rest_rms * rows.norm() / left[i].rest.norm());
      logarithm.push_back(std::log(std::max(in_noise.back(), std::sqrt(left[i].white) / noise.white_sd())));
    }
    const bool disturbed = repeats && roughness(logarithm) > irregular;
    for (std::size_t i = first; i < end; ++i) frozen_[i].disturbance = disturbed ? in_noise[i - first] : 0;
  }
  noise_ = std::move(found);
}

void SegmentEvidence::shift_records(const std::map<std::size_t, VectorXd>& shifts) {
  for (Segment& segment : segments_) {
    const auto own = shifts.find(segment.record);
    segment.record_shift = own == shifts.end() ? VectorXd() : own->second;
  }
}

void SegmentEvidence::evaluate(const VectorXd& unknowns, Eigen::Ref<VectorXd> rows) const {
  if (!has_frequencies(unknowns, model_.modes())) {
    rows.setConstant(std::numeric_limits<double>::infinity());
    return;
  }
  std::vector<VectorXd> errors = frozen_errors(unknowns);
  Index first = 0;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    rows_of(i, std::move(errors[i]), rows.segment(first, rows_in(i)));
    first += rows_in(i);
  }
}

void SegmentEvidence::rows_of(std::size_t segment, VectorXd error, Eigen::Ref<VectorXd> rows) const {
  const Frozen& f = frozen_[segment];
  error /= f.widening;
  error -= f.state_basis * (f.state_basis.transpose() * error);
  const VectorXd changes = f.change_basis.transpose() * error;
  error -= f.change_basis * changes;
  auto rest = rows.tail(error.size());
  if (coarse_) {
    rows.head(changes.size()) = changes;
    rest = error;
    return;
  }
  const Noise& noise = noise_[segment];
  rows.head(changes.size()) = changes.cwiseQuotient(noise.change_sd);
  whiten(noise, error, rest);
  rest /= std::max(1.0, f.disturbance);
}

void SegmentEvidence::whiten(const Noise& noise, const VectorXd& error, Eigen::Ref<VectorXd> rest) {
  if (!noise.coloured) {
    rest = error / noise.rest_sd;
    return;
  }
  const auto& [cosines, sd, least] = *noise.coloured;
  const Index samples = cosines.rows();
  for (Index c = 0; c < sd.cols(); ++c)
    rest.segment(c * samples, samples) = (cosines * error.segment(c * samples, samples)).cwiseQuotient(sd.col(c));
}

MatrixXd SegmentEvidence::between_samples(const VectorXd& unknowns, const BetweenSamples& of_blows) const {
  if (of_blows.records.empty()) return {};
  MatrixXd columns = MatrixXd::Zero(size(), 2);
  Index first = 0;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (of_blows.records.contains(segments_[i].record)) {
      constexpr double step = 1e-3;  // of a standard deviation
      const std::array<Segment, 2> moved{
          stronger_between_samples(segments_[i], step * of_blows.share),
          later_between_samples(segments_[i], step * of_blows.share / of_blows.frequency)};
      std::vector<SegmentTrial> trials{frozen_trial(i, unknowns)};
      for (const Segment& s : moved) trials.push_back({s, s.response.cols(), unknowns, frozen_[i].state});
      const std::vector<VectorXd> errors = frozen_errors({i, i, i}, trials);
      for (Index side : {0, 1}) {
        VectorXd rows(rows_in(i));
        rows_of(i, (errors[static_cast<std::size_t>(side + 1)] - errors[0]) / step, rows);
        columns.col(side).segment(first, rows.size()) = rows;
      }
    }
    first += rows_in(i);
  }
  return columns;
}

VectorXd SegmentEvidence::offset_slopes(std::size_t channel, double scale) const {
  VectorXd column(size());
  Index first = 0;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& s = segments_[i];
    const Index samples = s.response.cols(), c = static_cast<Index>(channel);
    VectorXd error = VectorXd::Zero(s.response.rows() * samples);
    error.segment(c * samples, samples).setConstant(-scale / s.noise_sd(c));
    rows_of(i, seen(i, std::move(error)), column.segment(first, rows_in(i)));
    first += rows_in(i);
  }
  return column;
}

MatrixXd SegmentEvidence::slopes(const VectorXd& unknowns, const std::vector<std::size_t>& which,
                                 const VectorXd& scale, unsigned threads) const {
  MatrixXd columns(size(), static_cast<Index>(which.size()));
  std::vector<std::size_t> others;
  std::vector<Index> places;
  for (std::size_t w = 0; w < which.size(); ++w) {
    std::size_t channel = 0;
    while (channel < model_.sensors().responses.size() && which[w] != model_.offset(channel)) ++channel;
    const auto place = static_cast<Index>(w);
    if (channel < model_.sensors().responses.size()) {
      columns.col(place) = offset_slopes(channel, scale(place));
    } else {
      others.push_back(which[w]);
      places.push_back(place);
    }
  }
  columns(Eigen::all, places) = differences(unknowns, others, scale(places), threads);
  return columns;
}

MatrixXd SegmentEvidence::differences(const VectorXd& unknowns, const std::vector<std::size_t>& which,
                                      const VectorXd& scale, unsigned threads) const {
  constexpr std::size_t together = Lanes::count / 2;  // either side of each
  MatrixXd columns(size(), static_cast<Index>(which.size()));
  std::vector<Index> first{0};
  for (std::size_t i = 0; i < segments_.size(); ++i) first.push_back(first.back() + rows_in(i));
  const auto moved = [&](std::size_t w, double side) {
    VectorXd end = unknowns;
    end(static_cast<Index>(which[w])) += side * scale(static_cast<Index>(w));
    return end;
  };
  std::vector<VectorXd> ends;
  for (std::size_t w = 0; w < which.size(); ++w)
    for (const double side : {0.5, -0.5}) ends.push_back(moved(w, side));
  // Columns of all segments one after the other.
  const std::size_t count = segments_.size() * which.size();
  in_parallel((count + together - 1) / together, threads, [&](std::size_t task) {
    const std::size_t begin = task * together, end = std::min(begin + together, count);
    std::vector<std::size_t> segments;
    std::vector<SegmentTrial> trials;
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t side = 0; side < 2; ++side) {
        segments.push_back(i / which.size());
        trials.push_back(frozen_trial(segments.back(), ends[2 * (i % which.size()) + side]));
      }
    std::vector<VectorXd> errors = frozen_errors(segments, trials);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t segment = i / which.size(), up = 2 * (i - begin);
      VectorXd above(rows_in(segment)), below(rows_in(segment));
      rows_of(segment, std::move(errors[up]), above);
      rows_of(segment, std::move(errors[up + 1]), below);
      columns.col(static_cast<Index>(i % which.size())).segment(first[segment], above.size()) = above - below;
    }
  });
  for (std::size_t w = 0; w < which.size(); ++w) {
    auto column = columns.col(static_cast<Index>(w));
    const bool there =
        has_frequencies(moved(w, 0.5), model_.modes()) && has_frequencies(moved(w, -0.5), model_.modes());
    if (!there || !column.allFinite()) column.setZero();
  }
  return columns;
}

std::vector<SegmentEvidence::Disturbed> SegmentEvidence::disturbed() const {
  std::vector<Disturbed> records;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (frozen_[i].disturbance == 0) continue;
    if (records.empty() || records.back().record != segments_[i].record)
      records.push_back({segments_[i].record, 0, {}});
    Disturbed& record = records.back();
    ++record.segments;
    if (frozen_[i].disturbance > 2) record.worst_s.push_back(segments_[i].in_record_s);
  }
  return records;
}

namespace {

SegmentEvidence::Left left_of(const Segment& first, std::size_t channel) {
  SegmentEvidence::Left left;
  left.record = first.record;
  left.channel = channel;
  left.sample_s = first.sample_s;
  left.from_s = first.in_record_s - 0.5 * static_cast<double>(first.response.cols()) * first.sample_s;
  return left;
}

}  // namespace

std::vector<SegmentEvidence::Left> SegmentEvidence::left(const VectorXd& unknowns) const {
  const std::vector<LeftOfSegment> by_segment = left_by(unknowns);
  std::vector<SegmentTrial> trials;
  for (std::size_t i = 0; i < segments_.size(); ++i) trials.push_back(frozen_trial(i, unknowns));
  const std::vector<VectorXd> errors = model_.errors(trials);
  std::vector<Left> all;
  const auto channels = static_cast<Index>(model_.sensors().responses.size());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& s = segments_[i];
    const Index samples = s.response.cols();
    if (i == 0 || segments_[i - 1].record != s.record)
      for (Index c = 0; c < channels; ++c)
        all.push_back(left_of(s, model_.sensors().responses[static_cast<std::size_t>(c)]));
    const Frozen& f = frozen_[i];
    MatrixXd known(s.response.size(), f.state_basis.cols() + f.change_basis.cols());
    known << f.state_basis, f.change_basis;
    VectorXd foreign = VectorXd::Zero(s.response.size());
    for (Index c = 0; c < channels && f.foreign.size() > 0; ++c)
      foreign.segment(c * samples, samples) = f.foreign.row(c).transpose() / s.noise_sd(c);
    foreign = seen(i, std::move(foreign));
    const MatrixXd moved = known.rightCols(known.cols() - foreign_[i].cols());
    foreign -= moved * (moved.transpose() * foreign);
    for (Index c = 0; c < channels; ++c) {
      Left& left = all[all.size() - static_cast<std::size_t>(channels - c)];
      const VectorXd rest = by_segment[i].rest.segment(c * samples, samples);
      for (Index k = 0; k < samples; ++k) {
        left.rest.push_back(s.noise_sd(c) * (rest(k) + foreign(c * samples + k)));
        left.noise.push_back(s.noise_sd(c) * rest(k));
        left.unwhited.push_back(s.noise_sd(c) * errors[i](c * samples + k));
        left.reading.push_back(s.response(c, k));
      }
      MatrixXd slow = wander_columns(s, c);
      for (auto column : slow.colwise()) column = seen(i, column);
      slow = beyond(known, std::move(slow));
      const double gained = (slow.transpose() * by_segment[i].rest).squaredNorm(),
                   freedom = slow.colwise().squaredNorm().sum();
      left.slow += gained;
      left.slow_freedom += freedom;
      left.other += rest.squaredNorm() - gained;
      left.other_freedom += static_cast<double>(samples) - freedom;
      left.to_s = s.in_record_s + 0.5 * static_cast<double>(samples) * s.sample_s;
    }
  }
  for (Left& left : all)
    left.rms = std::sqrt(std::inner_product(left.rest.begin(), left.rest.end(), left.rest.begin(), 0.0) /
                         static_cast<double>(left.rest.size()));
  return all;
}

std::vector<SegmentEvidence::RecordSize> SegmentEvidence::record_sizes() const {
  std::vector<RecordSize> sizes;
  for (const Segment& s : measured_) {
    if (sizes.empty() || sizes.back().record != s.record) sizes.push_back({s.record, s.excitation.cols() > 0, 0});
    const Eigen::MatrixXd& what = sizes.back().driven ? s.excitation : s.response;
    sizes.back().size = std::max(sizes.back().size, what.row(0).cwiseAbs().maxCoeff());
  }
  return sizes;
}

std::vector<Segment> SegmentEvidence::predicted(std::size_t record, const VectorXd& unknowns, double level) const {
  // A record's segments stand one behind the other.
  std::size_t first = 0;
  while (first < segments_.size() && segments_[first].record != record) ++first;
  std::size_t end = first;
  while (end < segments_.size() && segments_[end].record == record) ++end;
  const std::vector<VectorXd> states = states_at(first, end, unknowns, Stretch::whole);
  std::vector<Segment> segments;
  for (std::size_t i = first; i < end; ++i) {
    Segment& s = segments.emplace_back(segments_[i]);
    s.excitation *= level;
    s.response.setZero();
    if (i < noise_.size()) s.noise_sd *= noise_[i].white_sd();
    s.wandering.clear();
    s.tones.clear();
    s.coloured.clear();
  }
  std::vector<SegmentTrial> trials;
  for (std::size_t i = 0; i < segments.size(); ++i)
    trials.push_back({segments[i], segments[i].response.cols(), unknowns, level * states[i]});
  std::vector<StretchOfMotion> motions;
  const std::vector<VectorXd> errors = model_.errors(trials, nullptr, &motions);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& motion = motions[i];
    const Index last = motion.displacement.cols() - 1;
    if (!errors[i].allFinite() || (motion.displacement.col(last).isZero(0) && motion.velocity.col(last).isZero(0)))
      return {};
    const Index samples = segments[i].response.cols();
    for (Index c = 0; c < segments[i].response.rows(); ++c)
      segments[i].response.row(c) = -segments[i].noise_sd(c) * errors[i].segment(c * samples, samples).transpose();
  }
  return segments;
}

SegmentEvidence SegmentEvidence::of_known_noise(std::vector<Segment> segments) const {
  SegmentEvidence evidence(model_, std::move(segments), 1);
  evidence.noise_is_known_ = true;
  return evidence;
}

VectorXd SegmentEvidence::mean_square_error(const VectorXd& unknowns) const {
  const auto channels = static_cast<Index>(model_.sensors().response_names.size());
  VectorXd sum = VectorXd::Zero(channels);
  double count = 0;
  std::vector<VectorXd> states = states_at(0, segments_.size(), unknowns, Stretch::whole);
  std::vector<SegmentTrial> trials;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    trials.push_back(frozen_trial(i, unknowns));
    trials.back().state = std::move(states[i]);
  }
  const std::vector<VectorXd> errors = model_.errors(trials);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& s = segments_[i];
    const Index samples = s.response.cols();
    const VectorXd& error = errors[i];
    for (Index c = 0; c < channels; ++c)
      sum(c) += error.segment(c * samples, samples).squaredNorm() * s.noise_sd(c) * s.noise_sd(c);
    count += static_cast<double>(samples);
  }
  return sum / count;
}

VectorXd SegmentEvidence::mean_square_signal() const {
  VectorXd sum = VectorXd::Zero(static_cast<Index>(model_.sensors().response_names.size()));
  double count = 0;
  for (const Segment& s : segments_) {
    sum += s.response.rowwise().squaredNorm();
    count += static_cast<double>(s.response.cols());
  }
  return sum / count;
}

}  // namespace secular
