#include "diagnose/evidence/segment_model.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/evidence/segment_readings.hpp"

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd state_steps(const VectorXd& state) {
  return 1e-4 * state.cwiseAbs().cwiseMax(1e-3 * state.cwiseAbs().maxCoeff() + 1e-30);
}

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
    if (s.frequency_offset.size() > 0) start.parameters[k] *= 1 + s.frequency_offset(static_cast<Index>(k));
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

bool SegmentModel::remembers(const VectorXd& unknowns) const {
  const std::vector<double> extra = table_.faults(unknowns.data() + model_->symbols.size()).extra.amplitude;
  return std::any_of(extra.begin(), extra.end(), [](double a) { return a != 0; }) ||
         std::any_of(forces_.begin(), forces_.end(), [&](const StateForce& force) {
           return unknowns(static_cast<Index>(force.strength_symbol)) != 0 &&
                  force.law.kind != ForceLaw::Kind::state;
         });
}

std::vector<VectorXd> SegmentModel::errors(const std::vector<SegmentTrial>& trials,
                                           std::vector<std::vector<Index>>* jumps,
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
  if (jumps)
    for (const StretchOfMotion& motion : motions) jumps->push_back(motion.jumps);
  if (computed) *computed = std::move(motions);
  return all;
}

}  // namespace secular
