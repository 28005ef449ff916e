#include "motion/simulate/stepper.hpp"

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "input/stop_request.hpp"
#include "motion/simulate/dormand_prince_87.hpp"

namespace secular {
namespace {

namespace odeint = boost::numeric::odeint;

using DormandPrince = decltype(odeint::make_dense_output(0.0, 0.0, 0.0, odeint::runge_kutta_dopri5<OdeState>()));
using BulirschStoer = odeint::bulirsch_stoer_dense_out<OdeState>;

// A stepper of Odeint with dense output. It is made anew at every start: extrapolation remembers its last order.
template <class Method>
class DenseStepper final : public Stepper {
 public:
  DenseStepper(const StepperSettings& settings, std::function<Method()> make)
      : first_step_(settings.first_step), make_(std::move(make)) {}

  void start(const OdeState& state, double time) override {
    method_.emplace(make_());
    method_->initialize(state, time, first_step_);
    previous_ = time;
  }
  void advance(const OdeRate& rate, double) override { previous_ = method_->do_step(std::cref(rate)).first; }
  double previous_time() const override { return previous_; }
  double time() const override { return method_->current_time(); }
  const OdeState& state() const override { return method_->current_state(); }
  void state_at(double when, OdeState& result) const override { method_->calc_state(when, result); }

 private:
  double first_step_, previous_ = 0;
  std::function<Method()> make_;
  std::optional<Method> method_;
};

// Cubic Hermite interpolation between the states of a step: of the method's own order.
class FixedStepper final : public Stepper {
 public:
  explicit FixedStepper(double step) : step_(step) {}

  void start(const OdeState& state, double time) override {
    state_ = before_ = state;
    time_ = previous_ = time;
  }
  void advance(const OdeRate& rate, double target) override {
    const double rest = target - time_;
    const double step = rest > 0 ? rest / std::max(1.0, std::ceil(rest / step_ - 1e-6)) : step_;
    before_ = state_;
    previous_ = time_;
    rate_ = &rate;
    method_.do_step(std::cref(rate), state_, time_, step);
    time_ = rest > 0 && std::abs(rest - step) < 1e-9 * step ? target : time_ + step;
  }
  double previous_time() const override { return previous_; }
  double time() const override { return time_; }
  const OdeState& state() const override { return state_; }
  void state_at(double when, OdeState& result) const override {
    const double step = time_ - previous_;
    if (step <= 0) {
      result = state_;
      return;
    }
    OdeState from(state_.size()), to(state_.size());
    (*rate_)(before_, from, previous_);
    (*rate_)(state_, to, time_);
    const double s = (when - previous_) / step, r = 1 - s;
    result.resize(state_.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = r * r * (1 + 2 * s) * before_[i] + s * s * (1 + 2 * r) * state_[i] +
                  step * s * r * (r * from[i] - s * to[i]);
  }

 private:
  double step_, time_ = 0, previous_ = 0;
  OdeState state_, before_;
  const OdeRate* rate_ = nullptr;
  odeint::runge_kutta4<OdeState> method_;
};

// Error-controlled steps that meet the target. States within a step come from a step of their own from its begin,
// as accurate as the step itself: the search for events (dry friction, slip) asks for them, samples do not.
class HighOrderStepper final : public Stepper {
 public:
  explicit HighOrderStepper(const StepperSettings& s)
      : first_step_(s.first_step),
        longest_(s.largest_step > 0 ? s.largest_step : std::numeric_limits<double>::infinity()),
        method_({s.absolute_tolerance, s.relative_tolerance}, {}, DormandPrince87::stepper<OdeState>()) {}

  void start(const OdeState& state, double time) override {
    state_ = before_ = state;
    time_ = previous_ = time;
    wanted_ = first_step_;
  }
  void advance(const OdeRate& rate, double target) override {
    constexpr int most_attempts = 500;
    before_ = state_;
    previous_ = time_;
    rate_ = &rate;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      end_if_stopped();
      const double rest = target - previous_;
      double step = std::min(wanted_, longest_);
      const bool last = rest > 0 && rest <= step * (1 + 1e-9);
      if (rest > 0) step = last ? rest : rest / std::ceil(rest / step);
      time_ = previous_;
      wanted_ = step;
      if (method_.try_step(std::cref(rate), before_, time_, state_, wanted_) == odeint::fail) continue;
      if (last) time_ = target;
      return;
    }
    throw odeint::step_adjustment_error("no step within the tolerance");
  }
  double previous_time() const override { return previous_; }
  double time() const override { return time_; }
  const OdeState& state() const override { return state_; }
  void state_at(double when, OdeState& result) const override {
    result = before_;
    if (when > previous_) inner_.do_step(std::cref(*rate_), result, previous_, when - previous_);
  }

 private:
  using Method = DormandPrince87::Generic<OdeState>;

  double first_step_, longest_, wanted_ = 0, time_ = 0, previous_ = 0;
  OdeState state_, before_;
  const OdeRate* rate_ = nullptr;
  odeint::controlled_runge_kutta<Method> method_;
  mutable Method inner_ = DormandPrince87::stepper<OdeState>();
};

}  // namespace

std::unique_ptr<Stepper> make_stepper(const StepperSettings& s) {
  switch (s.method) {
    case Integrator::dormand_prince:
      return std::make_unique<DenseStepper<DormandPrince>>(s, [s] {
        return odeint::make_dense_output(s.absolute_tolerance, s.relative_tolerance, s.largest_step,
                                         odeint::runge_kutta_dopri5<OdeState>());
      });
    case Integrator::bulirsch_stoer:
      return std::make_unique<DenseStepper<BulirschStoer>>(s, [s] {
        return BulirschStoer(s.absolute_tolerance, s.relative_tolerance, 1.0, 1.0, s.largest_step, true);
      });
    case Integrator::dormand_prince_87:
      return std::make_unique<HighOrderStepper>(s);
    case Integrator::runge_kutta_4:
      break;
  }
  return std::make_unique<FixedStepper>(s.largest_step);
}

}  // namespace secular
