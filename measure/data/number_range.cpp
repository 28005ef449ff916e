#include "measure/data/number_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "input/input_error.hpp"

namespace secular {
namespace {

constexpr double smallest = 1e-30, largest = 1e30;  // derived: tenth powers are numbers

constexpr const char* right = "a unit or a FACTOR that makes its largest number lie between 1e-30 and 1e30";

}  // namespace

std::string number_range_fault(std::span<const double> samples) {
  double peak = 0;
  for (const double x : samples)
    if (std::isfinite(x)) peak = std::max(peak, std::abs(x));
  if (peak == 0 || (peak >= smallest && peak <= largest)) return {};
  return fmt::format("its largest number, {:.4g}, has powers that are {} number of double precision", peak,
                     peak > 1 ? "above the largest" : "below the smallest");
}

void require_number_range(std::span<const double> samples, const std::string& file, const std::string& place) {
  if (const std::string fault = number_range_fault(samples); !fault.empty())
    throw InputError(file, place, fault, right);
}

}  // namespace secular
