#include "effects/force_law.hpp"

#include <algorithm>
#include <cmath>

namespace secular::force_law {
namespace {

double power(double x, double exponent, double scale) {
  return std::pow(std::abs(x) / scale, std::clamp(exponent, 0.0, 15.0));
}

double odd_power(double x, double exponent, double scale) {
  return x == 0 ? 0 : std::copysign(scale * power(x, exponent, scale), x);
}

}  // namespace

const ForceLaw displacement_power{
    ForceLaw::Kind::state,
    [](double x, double, double exponent, double scale) { return odd_power(x, exponent, scale); }, false, true};
const ForceLaw velocity_power{
    ForceLaw::Kind::state,
    [](double, double v, double exponent, double scale) { return odd_power(v, exponent, scale); }, true, true};
const ForceLaw loss_power{ForceLaw::Kind::state, [](double x, double v, double exponent, double scale) {
                            return power(x, exponent, scale) * v;
                          }};
const ForceLaw speed_power{
    ForceLaw::Kind::state,
    [](double, double v, double exponent, double scale) { return scale * power(v, exponent, scale); }, true, true};
const ForceLaw saturation{ForceLaw::Kind::state,
                          [](double x, double, double most, double) { return most * std::tanh(x / most) - x; }};
const ForceLaw decay_with_speed{
    ForceLaw::Kind::state, [](double, double v, double speed, double) { return std::exp(-std::abs(v) / speed); }};

}  // namespace secular::force_law
