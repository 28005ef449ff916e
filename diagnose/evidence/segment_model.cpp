#include "diagnose/evidence/segment_model.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "diagnose/evidence/segment_readings.hpp"
#include "numerics/hertz.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd silenced(VectorXd error, Index samples, const std::vector<Index>& at) {
  for (Index first = 0; first + samples <= error.size(); first += samples)
    for (const Index sample : at)
      if (sample < samples) error(first + sample) = 0;
  return error;
}

SegmentModel::SegmentModel(const CompiledModel& model, std::vector<StateForce> forces, SensorModel sensors,
                           FaultTable table)
    : model_(&model), forces_(std::move(forces)), sensors_(std::move(sensors)), table_(std::move(table)) {}

MotionStart SegmentModel::start_of(const SegmentTrial& trial, const Faults& faults) const {
  const Segment& s = trial.segment;
  MotionStart start;
  start.parameters.assign(trial.unknowns.data(), trial.unknowns.data() + model_->symbols.size());
  for (std::size_t k = 0; k < model_->modes(); ++k) {
    start.parameters[k] *= 1 + faults.frequency_drift[k] * s.time_s;
    if (s.frequency_shift.size() > 0) start.parameters[k] *= 1 + s.frequency_shift(static_cast<Index>(k));
  }
  start.state = trial.state;
  start.samples = trial.samples;
  start.substeps = s.substeps;
  start.change = trial.change;
  const std::vector<double>& extra = faults.extra.amplitude;
  if (s.excitation.rows() > 0 && std::any_of(extra.begin(), extra.end(), [](double a) { return a != 0; }))
    start.side = SideOscillator{faults.extra.frequency, faults.extra.damping};
  return start;
}

std::vector<VectorXd> SegmentModel::errors(const std::vector<SegmentTrial>& trials, std::vector<Index>* jumps,
                                           std::vector<StretchOfMotion>* computed) const {
  std::vector<Faults> faults;
  std::vector<MotionStart> starts;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const Segment& s = trials[i].segment;
    faults.push_back(table_.faults(trials[i].unknowns.data() + model_->symbols.size()));
    starts.push_back(start_of(trials[i], faults.back()));
    // Trials of a segment have one signal, unless a fault makes it another.
    const bool again =
        i > 0 && &trials[i - 1].segment == &s && drive_alike(s, faults[i - 1].excitation, faults[i].excitation);
    starts.back().signal =
        again ? starts[i - 1].signal : std::make_shared<const DrivingSignal>(true_signal(s, faults[i].excitation));
  }
  std::vector<StretchOfMotion> motions = MotionIntegrator(*model_, forces_).motions(starts);
  std::vector<VectorXd> all;
  for (std::size_t i = 0; i < trials.size(); ++i)
    all.push_back(reading_errors(trials[i].segment, sensors_, faults[i], *starts[i].signal, motions[i]));
  if (jumps) *jumps = motions.front().jumps;
  if (computed) *computed = std::move(motions);
  return all;
}

// Displacements and velocities at the first sample by a sinusoid at every natural frequency over the first turns.
VectorXd SegmentModel::guessed_state(const Segment& s, const VectorXd& unknowns) const {
  const auto modes = static_cast<Index>(model_->modes());
  const MatrixXd modal = sensors_.filter * s.response;
  VectorXd state = VectorXd::Zero(2 * modes);
  for (Index k = 0; k < modes; ++k) {
    const double w = unknowns(k);
    const auto samples = static_cast<Index>(
        std::min(static_cast<double>(s.response.cols()), std::floor(1.2 * two_pi / w / s.sample_s) + 3));
    const Eigen::ArrayXd phase =
        Eigen::ArrayXd::LinSpaced(samples, 0, static_cast<double>(samples - 1)) * (w * s.sample_s);
    MatrixXd waves(samples, 3);
    waves.col(0) = phase.cos();
    waves.col(1) = phase.sin();
    waves.col(2).setOnes();
    const VectorXd fit = waves.colPivHouseholderQr().solve(modal.row(k).head(samples).transpose());
    // Of the measured quantity; divided by i w as often as it is differentiated.
    std::complex<double> amplitude(fit(0), -fit(1));
    for (int d = 0; d < sensors_.derivatives; ++d) amplitude /= std::complex<double>(0, w);
    state(k) = amplitude.real();
    state(modes + k) = (amplitude * std::complex<double>(0, w)).real();
  }
  return state;
}

double SegmentModel::improve_state(const Segment& s, const VectorXd& unknowns, VectorXd& state, Index samples,
                                   const std::vector<Index>& at_jumps) const {
  const auto size = static_cast<Index>(2 * model_->modes());
  const auto errors_from = [&](const VectorXd& at) {
    return silenced(errors({{s, samples, unknowns, at}}).front(), samples, at_jumps);
  };
  // Scales of displacement and velocity from the channels.
  const double frequency = unknowns(0);
  const double largest = s.response.cwiseAbs().maxCoeff() /
                         std::max(1e-300, sensors_.shapes.cwiseAbs().maxCoeff()) /
                         std::pow(frequency, sensors_.derivatives);
  VectorXd step(size);
  step.head(size / 2).setConstant(1e-4 * largest);
  step.tail(size / 2).setConstant(1e-4 * largest * frequency);
  VectorXd error = errors_from(state);
  for (int i = 0; i < 10; ++i) {
    std::vector<SegmentTrial> trials(static_cast<std::size_t>(size), {s, samples, unknowns, state});
    for (Index k = 0; k < size; ++k) trials[static_cast<std::size_t>(k)].state(k) += step(k);
    const std::vector<VectorXd> moved_errors = errors(trials);
    MatrixXd slope(error.size(), size);
    for (Index k = 0; k < size; ++k)
      slope.col(k) = silenced(moved_errors[static_cast<std::size_t>(k)], samples, at_jumps) - error;
    const VectorXd change = -slope.colPivHouseholderQr().solve(error);
    if (!change.allFinite()) break;
    double factor = 1, gain = -1;
    for (int half = 0; half < 5 && gain < 0; ++half, factor *= 0.3) {
      const VectorXd moved = state + factor * change.cwiseProduct(step);
      const VectorXd next = errors_from(moved);
      if (!(next.squaredNorm() < error.squaredNorm())) continue;
      gain = error.squaredNorm() - next.squaredNorm();
      state = moved;
      error = next;
    }
    if (gain < 1e-3 + 1e-6 * error.squaredNorm()) break;
  }
  return error.squaredNorm();
}

void SegmentModel::find_state(const Segment& s, const VectorXd& unknowns, VectorXd& state) const {
  const Index samples = s.response.cols();
  // A long stretch has many minima: a new state is found from its beginning on, and the better one stays.
  VectorXd fresh = guessed_state(s, unknowns);
  for (const Index part : {samples / 8, samples / 3})
    if (part > 8) improve_state(s, unknowns, fresh, part);
  const double fresh_error = improve_state(s, unknowns, fresh, samples);
  if (state.size() > 0 && improve_state(s, unknowns, state, samples) <= fresh_error) return;
  state = fresh;
}

}  // namespace secular
