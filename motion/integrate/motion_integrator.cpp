#include "motion/integrate/motion_integrator.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "input/stop_request.hpp"
#include "motion/integrate/jumping_motion.hpp"
#include "motion/integrate/motion_flow.hpp"
#include "motion/integrate/runge_kutta.hpp"

namespace secular {

using Eigen::Index;

namespace {

// Steps of motions side by side, whose accelerations have neither jumps nor corners.
class SmoothMotions {
 public:
  using State = std::vector<Lanes>;

  SmoothMotions(MotionFlow<Lanes>& flow, const State& start) : flow_(flow), step_(start.size()) {}

  void begin(double at, const State& state) { derivative(at, state, state, step_.rate()); }
  const State& rate() const { return step_.rate(); }

  std::array<bool, Lanes::count> advance(double at, double half_steps, double step, State& state, bool begun) {
    if (!begun) begin(at, state);
    step_.take(at, half_steps, Lanes(step), state,
               [&](double time, const State& stage, const State& origin, State& rate) {
                 derivative(time, stage, origin, rate);
               });
    state.swap(step_.end());
    return {};
  }

 private:
  void derivative(double at, const State& state, const State& origin, State& rate) {
    flow_.drive(at);
    flow_.accelerate(state, state.data() + flow_.modes(), origin, rate.data() + flow_.modes());
    flow_.complete(state, rate);
  }

  MotionFlow<Lanes>& flow_;
  RungeKutta<Lanes> step_;
};

// Some motions at their samples, one lane each.
template <class Number>
class Records {
 public:
  /// All of as many samples.
  Records(std::span<const MotionStart> starts, std::size_t modes)
      : pace_(starts.front()), modes_(modes), motions_(starts.size()) {
    const Index samples = pace_.samples;
    for (std::size_t m = 0; m < starts.size(); ++m) {
      StretchOfMotion& motion = motions_[m];
      motion.displacement = Eigen::MatrixXd::Zero(static_cast<Index>(modes), samples);
      motion.velocity = motion.acceleration = motion.displacement;
      if (starts[m].side) motion.side = Eigen::RowVectorXd::Zero(samples);
      bound_.push_back(1e6 * (starts[m].state.cwiseAbs().maxCoeff() + 1e-3));
    }
  }

  /// One of the motions: samples and steps of all are its.
  const MotionStart& pace() const { return pace_; }

  /// Of the motions that are within their bounds.
  void take(Index sample, const std::vector<Number>& state, const std::vector<Number>& rate) {
    for (std::size_t m = 0; m < motions_.size(); ++m) {
      if (bound_[m] == 0) continue;
      StretchOfMotion& motion = motions_[m];
      for (std::size_t k = 0; k < modes_; ++k) {
        const auto row = static_cast<Index>(k);
        motion.displacement(row, sample) = Motions<Number>::of(state[k], m);
        motion.velocity(row, sample) = Motions<Number>::of(state[modes_ + k], m);
        motion.acceleration(row, sample) = Motions<Number>::of(rate[modes_ + k], m);
      }
      if (motion.side.size() > 0) motion.side(sample) = Motions<Number>::of(rate[2 * modes_ + 1], m);
    }
  }

  /// Whether any motion is still within its bound.
  bool within(const std::vector<Number>& state) {
    bool any = false;
    for (std::size_t m = 0; m < motions_.size(); ++m) {
      for (std::size_t i = 0; i < 2 * modes_; ++i)
        if (!(std::abs(Motions<Number>::of(state[i], m)) < bound_[m])) bound_[m] = 0;
      any = any || bound_[m] > 0;
    }
    return any;
  }

  /// `jumped`: whether a motion jumped between this sample and the next.
  void add_jumps(Index sample, const std::array<bool, Motions<Number>::count>& jumped) {
    for (std::size_t m = 0; m < motions_.size(); ++m)
      if (std::vector<Index>& jumps = motions_[m].jumps;
          jumped[m] && bound_[m] > 0 && (jumps.empty() || jumps.back() < sample))
        jumps.push_back(sample);
  }
  std::vector<StretchOfMotion> get() { return std::move(motions_); }

 private:
  const MotionStart& pace_;
  std::size_t modes_;
  std::vector<StretchOfMotion> motions_;
  std::vector<double> bound_;  // 0: was passed
};

template <class Number, class Stepper>
std::vector<StretchOfMotion> follow(Stepper& stepper, std::vector<Number> state, Records<Number> records) {
  const MotionStart& pace = records.pace();
  const double step = pace.signal->sample_s / pace.substeps, half_steps = 2.0 / pace.substeps;
  for (Index i = 0; i < pace.samples; ++i) {
    const auto begin = static_cast<double>(2 * i);
    stepper.begin(begin, state);
    end_if_stopped();
    records.take(i, state, stepper.rate());
    if (i + 1 == pace.samples) break;
    for (int s = 0; s < pace.substeps; ++s)
      records.add_jumps(i, stepper.advance(begin + half_steps * s, half_steps, step, state, s == 0));
    if (!records.within(state)) break;
  }
  return records.get();
}

// Whether two motions have their samples and steps at the same times.
bool go_in_step(const MotionStart& a, const MotionStart& b) {
  return a.samples == b.samples && a.substeps == b.substeps && a.signal->sample_s == b.signal->sample_s &&
         a.signal->half_steps.rows() == b.signal->half_steps.rows();
}

}  // namespace

StretchOfMotion MotionIntegrator::motion(const MotionStart& start) const {
  const std::span<const MotionStart> one(&start, 1);
  MotionFlow<double> flow(model_, forces_, one);
  const std::vector<double> state = flow.state_of(one);
  JumpingMotion<double> stepper(flow, state, 1);
  return follow(stepper, state, Records<double>(one, model_.modes())).front();
}

std::vector<StretchOfMotion> MotionIntegrator::side_by_side(const std::vector<MotionStart>& starts) const {
  if (starts.size() == 1) return {motion(starts.front())};
  MotionFlow<Lanes> flow(model_, forces_, starts);
  const std::vector<Lanes> state = flow.state_of(starts);
  Records<Lanes> records(starts, model_.modes());
  JumpingMotion<Lanes> jumping(flow, state, starts.size());
  if (jumping.has_corners()) return follow(jumping, state, std::move(records));
  SmoothMotions smooth(flow, state);
  return follow(smooth, state, std::move(records));
}

std::vector<StretchOfMotion> MotionIntegrator::motions(const std::vector<MotionStart>& starts) const {
  std::vector<StretchOfMotion> all(starts.size());
  std::vector<bool> done(starts.size(), false);
  for (std::size_t first = 0; first < starts.size(); ++first) {
    std::vector<std::size_t> places;
    std::vector<MotionStart> together;
    const std::size_t most = model_.acceleration_of_lanes ? Lanes::count : 1;
    for (std::size_t i = first; i < starts.size() && together.size() < most; ++i)
      if (!done[i] && go_in_step(starts[first], starts[i])) {
        places.push_back(i);
        together.push_back(starts[i]);
        done[i] = true;
      }
    if (together.empty()) continue;
    std::vector<StretchOfMotion> motions = side_by_side(together);
    for (std::size_t m = 0; m < places.size(); ++m) all[places[m]] = std::move(motions[m]);
  }
  return all;
}

}  // namespace secular
