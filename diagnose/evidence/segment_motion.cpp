#include "diagnose/evidence/segment_motion.hpp"

#include <algorithm>
#include <cmath>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Parabola through three neighbouring half steps: value and first two derivatives at `at` (in half steps).
ExcitationSample interpolated(const Eigen::MatrixXd& half_steps, Index row, double at, double half_step_s) {
  const Index last = half_steps.cols() - 1;
  const auto middle = std::clamp<Index>(static_cast<Index>(std::lround(at)), 1, std::max<Index>(1, last - 1));
  if (last < 2) return {half_steps(row, 0), 0, 0};
  const double before = half_steps(row, middle - 1), here = half_steps(row, middle),
               after = half_steps(row, middle + 1);
  const double x = at - static_cast<double>(middle);
  const double slope = 0.5 * (after - before), bend = after - 2 * here + before;
  return {here + slope * x + 0.5 * bend * x * x, (slope + bend * x) / half_step_s,
          bend / (half_step_s * half_step_s)};
}

// A force that is not switched off, with the state of its sliders.
struct ActiveForce {
  const StateForce* force;
  double shape;
  std::vector<Slider> sliders;
  std::vector<double> stretch;
};

class Stretch {
 public:
  Stretch(const CompiledModel& model, const std::vector<StateForce>& forces, std::span<const double> parameters,
          const DrivingSignal& signal, const std::vector<LinearChange>& change, const SideOscillator* side)
      : model_(model),
        parameters_(parameters),
        signal_(signal),
        change_(change),
        side_(side),
        modes_(static_cast<Index>(model.modes())),
        excitation_(model.excitations.size()),
        driven_(std::min(signal.half_steps.rows(), static_cast<Index>(excitation_.size()))) {
    for (const StateForce& force : forces) {
      if (parameters[force.strength_symbol] == 0) continue;
      const double shape = force.shape(parameters);
      std::vector<Slider> sliders = sliders_of(force, shape);
      std::vector<double> stretch(sliders.size(), 0.0);
      active_.push_back({&force, shape, std::move(sliders), std::move(stretch)});
    }
  }

  // Derivative of (displacements, velocities, side displacement, side velocity); time in half steps of the samples.
  void derivative(double at, const VectorXd& state, const VectorXd& origin, VectorXd& rate) {
    for (Index j = 0; j < driven_; ++j)
      excitation_[static_cast<std::size_t>(j)] = interpolated(signal_.half_steps, j, at, 0.5 * signal_.sample_s);
    for (const ActiveForce& active : active_) {
      const StateForce& force = *active.force;
      const auto mode = static_cast<Index>(force.mode);
      double value = active.sliders.empty()
                         ? force.law.value(state(mode), state(modes_ + mode), active.shape, force.scale)
                         : 0;
      for (std::size_t i = 0; i < active.sliders.size(); ++i)
        value += active.sliders[i].advanced(active.stretch[i], state(mode) - origin(mode)) /
                 static_cast<double>(active.sliders.size());
      excitation_[force.excitation] = {value, 0, 0};
    }
    model_.acceleration(parameters_.data(), excitation_.data(), state.data(), state.data() + modes_,
                        rate.data() + modes_);
    rate.head(modes_) = state.segment(modes_, modes_);
    for (std::size_t k = 0; k < change_.size(); ++k) {
      const auto i = static_cast<Index>(k);
      rate(modes_ + i) -= change_[k].stiffness * state(i) + change_[k].damping * state(modes_ + i);
    }
    if (side_) {
      const double x = state(2 * modes_), v = state(2 * modes_ + 1);
      const double force = excitation_.empty() ? 0 : excitation_[0].value;
      rate(2 * modes_) = v;
      rate(2 * modes_ + 1) =
          force - 2 * side_->damping * side_->frequency * v - side_->frequency * side_->frequency * x;
    }
  }

  StretchOfMotion run(const VectorXd& start, Index samples, int substeps) {
    const Index size = 2 * modes_ + (side_ ? 2 : 0);
    VectorXd state = VectorXd::Zero(size);
    state.head(2 * modes_) = start;
    StretchOfMotion motion;
    motion.displacement = Eigen::MatrixXd::Zero(modes_, samples);
    motion.velocity = motion.displacement;
    motion.acceleration = motion.displacement;
    if (side_) motion.side = Eigen::RowVectorXd::Zero(samples);
    const double bound = 1e6 * (start.cwiseAbs().maxCoeff() + 1e-3);
    const double step = signal_.sample_s / substeps, half_steps = 2.0 / substeps;
    VectorXd k1(size), k2(size), k3(size), k4(size), moved(size);
    for (Index i = 0; i < samples; ++i) {
      derivative(static_cast<double>(2 * i), state, state, k1);
      motion.displacement.col(i) = state.head(modes_);
      motion.velocity.col(i) = state.segment(modes_, modes_);
      motion.acceleration.col(i) = k1.segment(modes_, modes_);
      if (side_) motion.side(i) = k1(2 * modes_ + 1);
      if (i + 1 == samples) break;
      for (int s = 0; s < substeps; ++s) {
        const double at = static_cast<double>(2 * i) + half_steps * s;
        if (s > 0) derivative(at, state, state, k1);
        moved = state + 0.5 * step * k1;
        derivative(at + 0.5 * half_steps, moved, state, k2);
        moved = state + 0.5 * step * k2;
        derivative(at + 0.5 * half_steps, moved, state, k3);
        moved = state + step * k3;
        derivative(at + half_steps, moved, state, k4);
        moved = state + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        for (ActiveForce& active : active_) {
          const auto mode = static_cast<Index>(active.force->mode);
          for (std::size_t e = 0; e < active.sliders.size(); ++e)
            active.stretch[e] = active.sliders[e].advanced(active.stretch[e], moved(mode) - state(mode));
        }
        state.swap(moved);
      }
      if (!(state.head(2 * modes_).cwiseAbs().maxCoeff() < bound)) break;
    }
    return motion;
  }

 private:
  const CompiledModel& model_;
  std::span<const double> parameters_;
  const DrivingSignal& signal_;
  const std::vector<LinearChange>& change_;
  const SideOscillator* side_;
  Index modes_;
  std::vector<ExcitationSample> excitation_;  // zero where neither the signal nor a force drives
  Index driven_;
  std::vector<ActiveForce> active_;
};

}  // namespace

StretchOfMotion integrate_stretch(const CompiledModel& model, const std::vector<StateForce>& forces,
                                  std::span<const double> parameters, const DrivingSignal& signal,
                                  const VectorXd& state, Index samples, int substeps,
                                  const std::vector<LinearChange>& change, const SideOscillator* side) {
  return Stretch(model, forces, parameters, signal, change, side).run(state, samples, substeps);
}

}  // namespace secular
