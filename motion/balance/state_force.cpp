#include "motion/balance/state_force.hpp"

#include <algorithm>
#include <cmath>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;

namespace {

/// A path is closed where its slider's stretch comes back to this share of the slip; by the secant only where turns
/// bring stretches together at all.
constexpr double same_stretch = 1e-10, steepest = 0.999;
constexpr int most_turns = 12;

// Steps of a path that do not turn: a slider goes them as it goes their sum.
struct Run {
  Index first = 0, end = 0;
  double way = 0;
};

std::vector<Run> runs_of(const RowVectorXd& way) {
  std::vector<Run> runs;
  for (Index i = 0; i < way.size(); ++i) {
    if (runs.empty() || way(i) * runs.back().way < 0) runs.push_back({i, i, 0});
    runs.back().end = i + 1;
    runs.back().way += way(i);
  }
  return runs;
}

// A smooth slider without its units. In the direction of the way, u = z/slip and s = |way|/slip: du/ds = 1 + u^2
// until the spring is slack, u = tan(phase), 1 - u^2 from there on, u = tanh(phase); the phase grows by s.
double phase_of(double u) {
  return u < 0 ? std::atan(u) : std::atanh(std::min(u, 1.0));
}

double stretch_at(double phase) {
  return phase < 0 ? std::tan(phase) : std::tanh(phase);
}

// The steps of one run, one after the other.
class SlidingRun {
 public:
  SlidingRun(const Slider& slider, double stretch, double way)
      : slider_(slider), stretch_(stretch), signed_slip_(std::copysign(slider.slip, way)) {
    if (slider.smooth && slider.slip != 0) phase_ = phase_of(stretch / signed_slip_);
  }

  double after(double way) {
    if (!slider_.smooth || slider_.slip == 0) return stretch_ = slider_.advanced(stretch_, way);
    phase_ += way / signed_slip_;
    return signed_slip_ * stretch_at(phase_);
  }

 private:
  Slider slider_;
  double stretch_, signed_slip_;
  double phase_ = 0;
};

}  // namespace

double Slider::smoothly_advanced(double stretch, double way) const {
  if (slip == 0) return 0;
  const double signed_slip = std::copysign(slip, way);
  return signed_slip * stretch_at(phase_of(stretch / signed_slip) + way / signed_slip);
}

std::vector<Slider> sliders_of(const StateForce& force, double shape) {
  const double slip = std::abs(shape);
  if (force.law.kind == ForceLaw::Kind::slider) return {{slip, false}};
  if (force.law.kind == ForceLaw::Kind::smooth_slider) return {{slip, true}};
  std::vector<Slider> sliders;
  if (force.law.kind == ForceLaw::Kind::spread_slider)
    for (std::size_t i = 0; i < spread_sliders; ++i)
      sliders.push_back({slip * (static_cast<double>(i) + 0.5) / static_cast<double>(spread_sliders), false});
  return sliders;
}

RowVectorXd slider_stretch(const RowVectorXd& path, const Slider& slider) {
  RowVectorXd way(path.size());  // to every point from the one before
  for (Index i = 0; i < path.size(); ++i) way(i) = path(i) - path(i == 0 ? path.size() - 1 : i - 1);
  const std::vector<Run> runs = runs_of(way);
  const auto turn_from = [&](double z) {
    for (const Run& run : runs) z = slider.advanced(z, run.way);
    return z;
  };
  // A turn brings different beginnings nearer to one another, but little where a smooth slider hardly gives way:
  // the beginning that comes back is found by the secant.
  double start = 0, end = turn_from(start);
  for (int i = 0; i < most_turns && std::abs(end - start) > same_stretch * std::abs(slider.slip); ++i) {
    const double next = turn_from(end), slope = (next - end) / (end - start);
    start = slope < steepest ? end + (next - end) / (1 - slope) : next;
    end = turn_from(start);
  }
  RowVectorXd stretch(path.size());
  double z = start;
  for (const Run& run : runs) {
    SlidingRun sliding(slider, z, run.way);
    for (Index i = run.first; i < run.end; ++i) stretch(i) = z = sliding.after(way(i));
  }
  return stretch;
}

double squared_amplitude(const RowVectorXd& signal) {
  return 2 * (signal.array() - signal.mean()).square().mean();
}

RowVectorXd signal_over_turn(const StateForce& force, const MatrixXd& displacement, const MatrixXd& velocity,
                             double shape) {
  const auto mode = static_cast<Index>(force.mode);
  RowVectorXd signal = RowVectorXd::Zero(displacement.cols());
  if (const std::vector<Slider> sliders = sliders_of(force, shape); !sliders.empty()) {
    for (const Slider& slider : sliders)
      signal += slider_stretch(displacement.row(mode), slider) / static_cast<double>(sliders.size());
    return force.per_stretch(shape) * signal;
  }
  for (Index p = 0; p < signal.size(); ++p)
    signal(p) = force.law.value(displacement(mode, p), velocity(mode, p), shape, force.scale);
  return signal;
}

}  // namespace secular
