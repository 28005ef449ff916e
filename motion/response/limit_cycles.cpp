#include "motion/response/limit_cycles.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using ConstVector = Eigen::Ref<const VectorXd>;

/// Of a growth over the largest one: zero.
constexpr double rounding = 1e-9;

VectorXcd alone(const ResponseField& field, Index mode, double amplitude) {
  VectorXcd b = VectorXcd::Zero(static_cast<Index>(field.active().size()));
  b(mode) = amplitude;
  return b;
}

// How fast every mode turns in the frame in which the cycle stands still, over the rate of its own mode. Nothing
// where no free phase moves it.
std::optional<VectorXd> turning(const ResponseField& field, Index mode) {
  for (Index s = 0; s < field.symmetries().rows(); ++s)
    if (std::abs(field.symmetries()(s, mode)) > rounding)
      return VectorXd(field.symmetries().row(s).transpose() / field.symmetries()(s, mode));
  return std::nullopt;
}

// By the eigenvalues of the linearised equations; the one nearest to zero is that of the free phase.
bool is_stable(const ResponseField& field, const ConstVector& parameters, Index mode, double amplitude,
               const VectorXd& turns) {
  const VectorXcd b = alone(field, mode, amplitude);
  const double rate = (field.modulation(parameters, b)(mode) / amplitude).imag();
  VectorXd state = VectorXd::Zero(2 * b.size());
  state(2 * mode) = amplitude;
  MatrixXd jacobian = field.full(amplitude, parameters).jacobian(state, parameters);
  for (Index k = 0; k < b.size(); ++k) {  // minus i*rate*turns
    jacobian(2 * k, 2 * k + 1) += rate * turns(k);
    jacobian(2 * k + 1, 2 * k) -= rate * turns(k);
  }
  const VectorXcd eigenvalues = jacobian.eigenvalues();
  Index phase = 0;
  eigenvalues.cwiseAbs().minCoeff(&phase);
  for (Index i = 0; i < eigenvalues.size(); ++i)
    if (i != phase && !(eigenvalues(i).real() < 0)) return false;
  return true;
}

}  // namespace

std::vector<LimitCycle> limit_cycles(const ResponseField& field, const ConstVector& parameters, std::size_t mode,
                                     double largest, int points) {
  const auto own = static_cast<Index>(mode);
  const std::optional<VectorXd> turns = turning(field, own);
  if (!turns) return {};
  VectorXd undriven = parameters;
  undriven.tail(static_cast<Index>(field.model().excitations.size())).setZero();
  const auto at = [&](double amplitude) { return backbone(field, undriven, mode, amplitude, 1).front(); };
  const std::vector<BackbonePoint> curve = backbone(field, undriven, mode, largest, points);
  double fastest = 0;
  for (const BackbonePoint& point : curve) fastest = std::max(fastest, std::abs(point.growth));
  std::vector<LimitCycle> cycles;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    BackbonePoint low = i == 0 ? at(1e-6 * largest) : curve[i - 1], high = curve[i];
    // A growth that vanishes everywhere is that of an undamped mode: no cycle is isolated.
    if (!(low.growth * high.growth < 0) ||
        std::max(std::abs(low.growth), std::abs(high.growth)) < rounding * fastest)
      continue;
    for (int bisection = 0; bisection < 60; ++bisection) {
      const BackbonePoint middle = at(0.5 * (low.amplitude + high.amplitude));
      (middle.growth * low.growth > 0 ? low : high) = middle;
    }
    VectorXcd rates = field.modulation(undriven, alone(field, own, high.amplitude));
    rates(own) = 0;
    if (rates.norm() > rounding * fastest * high.amplitude) continue;
    cycles.push_back({high, is_stable(field, undriven, own, high.amplitude, *turns)});
  }
  return cycles;
}

}  // namespace secular
