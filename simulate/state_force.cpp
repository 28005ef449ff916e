#include "simulate/state_force.hpp"

#include <algorithm>
#include <cmath>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;

namespace {

/// Exponents beyond are as good as a wall; below zero a force would be infinite at rest.
constexpr double largest_exponent = 15;

/// A path is closed where its slider's stretch comes back to this share of the slip; by the secant only where turns
/// bring stretches together at all.
constexpr double same_stretch = 1e-10, steepest = 0.999;
constexpr int most_turns = 12;

}  // namespace

double power_law(const StateForce& force, double displacement, double velocity, double exponent) {
  const double x = is_of_velocity(force.law) ? velocity : displacement;
  const double size = std::pow(std::abs(x) / force.scale, std::clamp(exponent, 0.0, largest_exponent));
  if (force.law == StateForce::Law::loss_power) return size * velocity;
  if (force.law == StateForce::Law::speed_power) return force.scale * size;
  return x == 0 ? 0 : std::copysign(force.scale * size, x);
}

double Slider::advanced(double stretch, double way) const {
  if (!smooth) return std::clamp(stretch + way, -slip, slip);
  // In the direction of the way, u = z/slip and s = |way|/slip: du/ds = 1 + u^2 until the spring is slack (tan),
  // 1 - u^2 from there on (tanh).
  const double size = std::abs(slip), direction = way < 0 ? -1 : 1;
  if (!(size > 0)) return 0;
  double u = direction * stretch / size, s = std::abs(way) / size;
  if (u < 0) {
    const double slack = -std::atan(u);
    if (s < slack) return direction * size * std::tan(s - slack);
    s -= slack;
    u = 0;
  }
  const double tanh_s = std::tanh(s);
  return direction * size * (u + tanh_s) / (1 + u * tanh_s);
}

std::vector<Slider> sliders_of(const StateForce& force, double shape) {
  if (force.law == StateForce::Law::slider) return {{shape, false}};
  if (force.law == StateForce::Law::smooth_slider) return {{shape, true}};
  std::vector<Slider> sliders;
  if (force.law == StateForce::Law::spread_slider)
    for (std::size_t i = 0; i < spread_sliders; ++i)
      sliders.push_back({shape * (static_cast<double>(i) + 0.5) / static_cast<double>(spread_sliders), false});
  return sliders;
}

RowVectorXd slider_stretch(const RowVectorXd& path, const Slider& slider) {
  RowVectorXd stretch(path.size());
  const auto turn_from = [&](double z) {
    double before = path(path.size() - 1);
    for (Index i = 0; i < path.size(); ++i) {
      z = slider.advanced(z, path(i) - before);
      before = path(i);
      stretch(i) = z;
    }
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
  return stretch;
}

RowVectorXd signal_over_turn(const StateForce& force, const MatrixXd& displacement, const MatrixXd& velocity,
                             double shape) {
  const auto mode = static_cast<Index>(force.mode);
  RowVectorXd signal = RowVectorXd::Zero(displacement.cols());
  if (const std::vector<Slider> sliders = sliders_of(force, shape); !sliders.empty()) {
    for (const Slider& slider : sliders)
      signal += slider_stretch(displacement.row(mode), slider) / static_cast<double>(sliders.size());
    return signal;
  }
  for (Index p = 0; p < signal.size(); ++p)
    signal(p) = power_law(force, displacement(mode, p), velocity(mode, p), shape);
  return signal;
}

}  // namespace secular
