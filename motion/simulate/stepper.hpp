#pragma once

#include <functional>
#include <memory>
#include <vector>

namespace secular {

/// How the equations of motion are integrated.
enum class Integrator {
  dormand_prince,     ///< Runge-Kutta 5(4), step control, dense output of order 4
  bulirsch_stoer,     ///< extrapolation of variable order, step control, dense output: fewest evaluations where the
                      ///< motion is smooth and the tolerance tight
  runge_kutta_4,      ///< classical, fixed step: fastest where a moderate accuracy does
  dormand_prince_87,  ///< Runge-Kutta 8(7), step control, steps end at the samples: fastest where the tolerance is
                      ///< tight and samples are not much closer than a tenth of the shortest period
};

using OdeState = std::vector<double>;
using OdeRate = std::function<void(const OdeState& state, OdeState& rate, double time)>;

/// One step after another of an ordinary differential equation, with the state at any time within the last step.
class Stepper {
 public:
  virtual ~Stepper() = default;
  virtual void start(const OdeState& state, double time) = 0;
  /// A step of free length, or, of methods without dense output, one that meets `target` after a whole number of
  /// such steps.
  virtual void advance(const OdeRate& rate, double target) = 0;
  virtual double previous_time() const = 0;
  virtual double time() const = 0;
  virtual const OdeState& state() const = 0;
  virtual void state_at(double when, OdeState& result) const = 0;
};

struct StepperSettings {
  Integrator method = Integrator::dormand_prince;
  double relative_tolerance = 1e-10, absolute_tolerance = 1e-14;
  double first_step = 0;    ///< s, of methods with step control
  double largest_step = 0;  ///< s; 0: no limit. The fixed step's length
};

/// Steppers of Boost.Odeint.
std::unique_ptr<Stepper> make_stepper(const StepperSettings& settings);

}  // namespace secular
