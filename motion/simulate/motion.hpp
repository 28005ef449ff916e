#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "effects/force_law.hpp"
#include "estimator/model/compiled_model.hpp"
#include "motion/simulate/stepper.hpp"

namespace secular {

/// The excitations of a model at a time.
using ExcitationSignal = std::function<void(double time, ExcitationSample* samples)>;

/// Displacements, velocities and accelerations of every mode at one instant, and the excitations as they acted.
struct MotionSample {
  double time = 0;
  std::vector<double> displacement, velocity, acceleration;
  std::vector<ExcitationSample> excitation;
};

/// A spring in series with a slider (Jenkins element) on one mode: its elastic displacement z follows dz/dt = v and
/// stays within +-slip. z is handed to the model as the value of an excitation.
struct SlipElement {
  std::size_t mode = 0, excitation = 0;
  double slip = 0;
};

/// A spring in series with a damper (Maxwell element) on one mode: its elastic displacement z follows
/// dz/dt = v - z/time_constant.
struct RelaxingElement {
  std::size_t mode = 0, excitation = 0;
  double time_constant = 1;  ///< s
};

/// A force of one mode by a law of its displacement and velocity, handed to the model as the value of an
/// excitation.
struct LawElement {
  std::size_t mode = 0, excitation = 0;
  ForceLaw::Value law = nullptr;
  double shape = 0;
};

/// Shaker between command and base: an armature on its suspension, driven by a force that would give it the
/// commanded acceleration c if it were free. Its displacement X obeys
///   D2(X) + 2*damping*omega*D(X) + omega^2*X = c - sum_k feedback[k]*D2(v_k),
/// and D2(X) is the excitation F*cos(Omega*t) that acts and is measured: below its suspension's frequency the
/// shaker gives less, and the structure pulls at it by feedback[k] = (participation factor of mode k)/(mass of
/// armature, table and structure); 0: nothing disturbs it. The excitation's time derivatives leave the feedback's
/// out, which matters only to models with D(F*cos(Omega*t)).
struct Armature {
  double omega = 0;    ///< rad/s
  double damping = 0;  ///< ratio
  std::vector<double> feedback;
};

struct MotionSettings {
  Integrator method = Integrator::dormand_prince;
  double relative_tolerance = 1e-10;
  double absolute_tolerance = 1e-14;  ///< in the coordinates' units
  double largest_step = 0;            ///< s; 0: no limit. For pulses that a long step could jump over
  double fixed_step = 0;              ///< s, of runge_kutta_4; 0: a sixteenth of `step`
  std::string label = "motion";       ///< names the record in messages
  std::vector<SlipElement> slip_elements;
  std::vector<RelaxingElement> relaxing_elements;
  std::vector<LawElement> law_elements;
  std::vector<std::size_t> clocks;  ///< excitations whose value is the time plus `clock_origin`
  double clock_origin = 0;
  std::vector<std::size_t> levels;   ///< excitations whose value is the square of `level`
  double level = 0;                  ///< amplitude of the first excitation
  std::optional<Armature> armature;  ///< of the first excitation
};

/// Equations of motion with all that they depend on.
struct MotionEquations {
  const CompiledModel& model;
  const double* parameters;  ///< by CompiledModel::symbols
  const ExcitationSignal& excitation;
};

/// A motion from `from` on, with samples at first, first + step, ... (count of them).
struct SampleTimes {
  double from = 0;
  double first = 0;
  double step = 0;
  std::size_t count = 0;
};

/// All that the rest of a motion depends on.
struct MotionState {
  std::vector<double> displacement, velocity;
  /// By MotionSettings::slip_elements; empty: first loaded from z = 0.
  std::vector<double> elastic_displacement = {};
  std::vector<double> relaxing_displacement = {};  ///< by MotionSettings::relaxing_elements; empty: relaxed
  double base = 0, base_rate = 0;                  ///< displacement and velocity of the armature
};

/// Integrates the full equations of motion from `state` and hands over samples, by a method of Boost.Odeint with
/// dense output. Where the velocity of a mode comes to zero and its acceleration changes sign with it (dry
/// friction), that mode is held until the force exceeds the friction. Slip elements are exact: z is the
/// displacement from an anchor while the element sticks and +-slip while it slides, and the instants between are
/// located to rounding. At the end `state` is that of the last sample. Throws NumericalFailure for a motion that
/// grows beyond bounds, with its time.
void integrate_motion(const MotionEquations& equations, const SampleTimes& times, const MotionSettings& settings,
                      MotionState& state, const std::function<void(const MotionSample&)>& sample);

}  // namespace secular
