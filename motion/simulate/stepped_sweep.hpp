#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "estimator/model/compiled_model.hpp"

namespace secular {

/// One dwell of a sweep: frequency (rad/s) and peak amplitude of every excitation.
struct SweepStep {
  std::vector<double> frequency, forcing;
};

/// A sweep in steps on the full equations of motion: each dwell goes on from the state in which the one before
/// ended, without a jump of the excitation's phase, until the response has settled.
struct SteppedSweep {
  Eigen::VectorXd parameters;  ///< by CompiledModel::symbols, and possibly more
  std::vector<SweepStep> steps;
  /// Displacement of every mode that a dwell begins with at least, as disturbances of a test do: without it an
  /// unstable state of rest would last for ever.
  double disturbance = 0;
  double settled = 1e-3;    ///< relative change of the amplitude from window to window
  int window_periods = 40;  ///< of the slowest mode
  int window_limit = 400;   ///< of one dwell
};

struct SweepPoint {
  std::vector<double> amplitude;  ///< [mode]: peak at the mode's observed frequency
  bool settled = false;
};

/// Peak amplitudes at the end of every dwell. `done` is called after each. Throws NumericalFailure as
/// integrate_motion does.
std::vector<SweepPoint> stepped_sweep(const CompiledModel& model, const CompiledCase& resonance,
                                      const SteppedSweep& sweep, const std::function<void()>& done = {});

}  // namespace secular
