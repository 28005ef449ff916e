#pragma once

#include <vector>

#include "diagnose/evidence/segment.hpp"

namespace secular {

/// What the first samples of a segment are computed with.
struct SegmentTrial {
  const Segment& segment;
  Eigen::Index samples;             ///< from its first one on
  const Eigen::VectorXd& unknowns;  ///< the model's symbols, then those of the fault table
  Eigen::VectorXd state;            ///< where it begins: displacements, then velocities, 2*modes
  std::vector<LinearChange> change = {};
};

/// Errors, channel after channel of `samples` each, with zeros at the samples `at`.
Eigen::VectorXd silenced(Eigen::VectorXd error, Eigen::Index samples, const std::vector<Eigen::Index>& at);

/// By each part of a state, the step of differences: a ten thousandth of it, or of a thousandth of the largest.
Eigen::VectorXd state_steps(const Eigen::VectorXd& state);

/// What the full equations of motion and the sensors make of segments.
class SegmentModel {
 public:
  SegmentModel(const CompiledModel& model, std::vector<StateForce> forces, SensorModel sensors, FaultTable table);

  const CompiledModel& model() const { return *model_; }
  std::size_t modes() const { return model_->modes(); }
  const SensorModel& sensors() const { return sensors_; }
  /// Unknown that is the offset of a response channel.
  std::size_t offset(std::size_t channel) const { return model_->symbols.size() + table_.offset(channel); }

  /// Whether what acts at a time hangs on more than the state and the excitation then: on what was before
  /// (sliders, what relaxes, an extra mode) or on all of the excitation.
  bool remembers(const Eigen::VectorXd& unknowns) const;

  /// Measured minus computed, in units of the noise, by trial: channel after channel, `samples` each. A motion that
  /// passes a million times its beginning counts as zero from there on. `jumps`: of every trial's motion, see
  /// StretchOfMotion. `computed`: the motions, by trial.
  std::vector<Eigen::VectorXd> errors(const std::vector<SegmentTrial>& trials,
                                      std::vector<std::vector<Eigen::Index>>* jumps = nullptr,
                                      std::vector<StretchOfMotion>* computed = nullptr) const;

 private:
  MotionStart start_of(const SegmentTrial& trial, const Faults& faults) const;

  const CompiledModel* model_;
  std::vector<StateForce> forces_;
  SensorModel sensors_;
  FaultTable table_;
};

}  // namespace secular
