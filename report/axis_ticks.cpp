#include "report/axis_ticks.hpp"

#include <algorithm>
#include <cmath>

#include "report/number_format.hpp"

namespace secular::report {
namespace {

/// A step of 1, 2 or 5 times 10^exponent.
struct Step {
  int mantissa = 1;
  int exponent = 0;
};

Step nice_step(double rough) {
  const int exponent = static_cast<int>(std::floor(std::log10(rough)));
  const double mantissa = rough / std::pow(10.0, exponent);
  if (mantissa <= 1.0 + 1e-9) return {1, exponent};
  if (mantissa <= 2.0 + 1e-9) return {2, exponent};
  if (mantissa <= 5.0 + 1e-9) return {5, exponent};
  return {1, exponent + 1};
}

/// Integer * 10^exponent without the rounding of a negative power: 3 * 10^-1 is 0.3, not 0.30000000000000004.
double decimal(double integer, int exponent) {
  return exponent >= 0 ? integer * std::pow(10.0, exponent) : integer / std::pow(10.0, -exponent);
}

int power_for(double largest) {
  if (largest == 0) return 0;
  const int exponent = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  if (exponent >= -2 && exponent < 5) return 0;
  return 3 * static_cast<int>(std::floor(exponent / 3.0));
}

std::string decade_label(int exponent, bool plain) {
  return plain ? format_fixed(std::pow(10.0, exponent), std::max(0, -exponent)) : "10" + superscript(exponent);
}

}  // namespace

AxisTicks linear_ticks(double low, double high, int count) {
  const Step step = nice_step((high - low) / std::max(count, 1));
  const double size = decimal(step.mantissa, step.exponent);
  const double slack = 1e-9 * (high - low) / size;
  AxisTicks axis;
  axis.power_of_ten = power_for(std::max(std::abs(low), std::abs(high)));
  const int decimals = std::max(0, axis.power_of_ten - step.exponent);
  const double first = std::ceil(low / size - slack), last = std::floor(high / size + slack);
  for (double multiple = first; multiple <= last && axis.ticks.size() < 100; ++multiple) {
    const double in_label = decimal(multiple * step.mantissa, step.exponent - axis.power_of_ten);
    axis.ticks.push_back({decimal(multiple * step.mantissa, step.exponent), format_fixed(in_label, decimals)});
  }
  // One tick alone shows no scale.
  return axis.ticks.size() < 2 && count < 8 ? linear_ticks(low, high, std::max(count, 1) * 2) : axis;
}

AxisTicks logarithmic_ticks(double low, double high, int count) {
  const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
  AxisTicks axis;
  if (last - first >= 1) {
    const int stride = std::max(1, (last - first + std::max(count, 1) - 1) / std::max(count, 1));
    const bool plain = first >= -3 && last <= 4;
    for (int exponent = first - 1; exponent <= last; ++exponent) {
      if (exponent >= first)
        axis.ticks.push_back({decimal(1, exponent), exponent % stride == 0 ? decade_label(exponent, plain) : ""});
      for (int digit = 2; stride == 1 && digit <= 9; ++digit) {
        const double minor = decimal(digit, exponent);
        if (minor > low && minor < high) axis.ticks.push_back({minor, ""});
      }
    }
    return axis;
  }
  for (int exponent = first - 1; exponent <= last; ++exponent)
    for (const int digit : {1, 2, 5}) {
      const double position = decimal(digit, exponent);
      if (position >= low * (1 - 1e-9) && position <= high * (1 + 1e-9)) axis.ticks.push_back({position, ""});
    }
  if (axis.ticks.size() < 3) return linear_ticks(low, high, count);
  // One or two decades: one power of ten for all labels.
  axis.power_of_ten = power_for(high);
  for (Tick& tick : axis.ticks) {
    const double in_label = tick.position / std::pow(10.0, axis.power_of_ten);
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(in_label) + 1e-9)));
    tick.label = format_fixed(in_label, decimals);
  }
  return axis;
}

}  // namespace secular::report
