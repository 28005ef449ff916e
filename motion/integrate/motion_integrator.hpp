#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "estimator/model/compiled_model.hpp"
#include "motion/balance/motion_balance.hpp"

namespace secular {

/// A small change of every mode's equation of motion: acceleration -stiffness*q - damping*dq/dt (1/s^2, 1/s).
struct LinearChange {
  double stiffness = 0, damping = 0;
};

/// An equation beside the model: x'' + 2 damping frequency x' + frequency^2 x = first excitation.
struct SideOscillator {
  double frequency = 1, damping = 0;
};

/// What drives a stretch of motion: values at even steps of half a sample, model's excitations x (2*samples - 1).
struct DrivingSignal {
  Eigen::MatrixXd half_steps;  ///< of three samples at least
  double sample_s = 0;
};

/// What is integrated over a stretch.
struct MotionStart {
  std::vector<double> parameters;
  Eigen::VectorXd state;  ///< displacements, then velocities
  std::shared_ptr<const DrivingSignal> signal;
  Eigen::Index samples = 0;
  int substeps = 1;
  std::vector<LinearChange> change = {};  ///< by mode; empty: none
  std::optional<SideOscillator> side = {};
};

/// A stretch of motion at its samples.
struct StretchOfMotion {
  Eigen::MatrixXd displacement, velocity, acceleration;  ///< modes x samples
  Eigen::RowVectorXd side;                               ///< x'' of the side oscillator (empty without)
  std::vector<Eigen::Index> jumps;                       ///< accelerations jump between this sample and the next
};

/// Integrates the full equations of motion over evenly spaced samples: fourth-order Runge-Kutta with `substeps`
/// equal steps from sample to sample, the driving signal interpolated by polynomials of fourth degree. Where the
/// equations jump with the sign of a coordinate's velocity (dry friction), a step holds to one side of the jump and
/// ends where the velocity comes to zero, so that motions are continuous in the parameters; a coordinate that is
/// pushed back either way stays where it is. Sliders among `forces` start unstretched and end steps where they give
/// way or turn; what relaxes starts amid a vibration at its mode's frequency. Samples beyond 1e6 times it stay
/// zero.
class MotionIntegrator {
 public:
  /// Keeps a reference to the model.
  MotionIntegrator(const CompiledModel& model, std::vector<StateForce> forces)
      : model_(model), forces_(std::move(forces)) {}

  /// At samples 0, 1, ... of `start`, the first at its state.
  StretchOfMotion motion(const MotionStart& start) const;
  /// The same motions, to the last bit, in far less time: those whose samples are as many, as far apart and as
  /// finely divided are integrated side by side.
  std::vector<StretchOfMotion> motions(const std::vector<MotionStart>& starts) const;

 private:
  std::vector<StretchOfMotion> side_by_side(const std::vector<MotionStart>& starts) const;

  const CompiledModel& model_;
  std::vector<StateForce> forces_;
};

}  // namespace secular
