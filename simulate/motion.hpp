#pragma once

#include <functional>
#include <string>
#include <vector>

#include "estimator/compiled_model.hpp"

namespace secular {

/// Displacements, velocities and accelerations of every mode at one instant.
struct MotionSample {
  double time = 0;
  std::vector<double> displacement, velocity, acceleration;
};

/// The excitations of a model at a time.
using ExcitationSignal = std::function<void(double time, ExcitationSample* samples)>;

struct MotionSettings {
  double relative_tolerance = 1e-10;
  double absolute_tolerance = 1e-14;  ///< in the coordinates' units
  double largest_step = 0;            ///< s; 0: no limit. For pulses that a long step could jump over
  std::string label = "motion";       ///< names the record in messages
};

/// Integrates the full equations of motion from `displacement`, `velocity` at time `from` and hands over samples at
/// first, first + step, ... (count of them). Dormand-Prince 5(4) with dense output (Boost.Odeint); where the
/// velocity of a mode comes to zero and its acceleration changes sign with it (dry friction), that mode is held
/// until the force exceeds the friction. At the end displacement and velocity hold the state at the last sample.
/// Throws InputError for a motion that grows beyond bounds, with its time.
void integrate_motion(const CompiledModel& model, const double* parameters, const ExcitationSignal& excitation,
                      double from, std::vector<double>& displacement, std::vector<double>& velocity, double first,
                      double step, std::size_t count, const MotionSettings& settings,
                      const std::function<void(const MotionSample&)>& sample);

}  // namespace secular
