#include "diagnose/state_force.hpp"

#include <algorithm>
#include <cmath>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;

namespace {

/// Exponents beyond are as good as a wall; below zero a force would be infinite at rest.
constexpr double largest_exponent = 15;

}  // namespace

double power_law(const StateForce& force, double displacement, double velocity, double exponent) {
  const double x = is_of_velocity(force.law) ? velocity : displacement;
  const double size = std::pow(std::abs(x) / force.scale, std::clamp(exponent, 0.0, largest_exponent));
  if (force.law == StateForce::Law::loss_power) return size * velocity;
  if (force.law == StateForce::Law::speed_power) return force.scale * size;
  return x == 0 ? 0 : std::copysign(force.scale * size, x);
}

std::vector<double> slips_of(const StateForce& force, double shape) {
  if (force.law == StateForce::Law::slider) return {shape};
  std::vector<double> slips;
  if (force.law == StateForce::Law::spread_slider)
    for (std::size_t i = 0; i < spread_sliders; ++i)
      slips.push_back(shape * (static_cast<double>(i) + 0.5) / static_cast<double>(spread_sliders));
  return slips;
}

RowVectorXd slider_stretch(const RowVectorXd& path, double slip) {
  RowVectorXd stretch(path.size());
  double z = 0, before = path(path.size() - 1);
  for (int turn = 0; turn < 2; ++turn)
    for (Index i = 0; i < path.size(); ++i) {
      z = std::clamp(z + path(i) - before, -slip, slip);
      before = path(i);
      stretch(i) = z;
    }
  return stretch;
}

RowVectorXd signal_over_turn(const StateForce& force, const MatrixXd& displacement, const MatrixXd& velocity,
                             double shape) {
  const auto mode = static_cast<Index>(force.mode);
  RowVectorXd signal = RowVectorXd::Zero(displacement.cols());
  if (const std::vector<double> slips = slips_of(force, shape); !slips.empty()) {
    for (const double slip : slips)
      signal += slider_stretch(displacement.row(mode), slip) / static_cast<double>(slips.size());
    return signal;
  }
  for (Index p = 0; p < signal.size(); ++p)
    signal(p) = power_law(force, displacement(mode, p), velocity(mode, p), shape);
  return signal;
}

}  // namespace secular
