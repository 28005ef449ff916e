#include "numerics/third_differences.hpp"

namespace secular {

std::vector<double> third_differences(std::span<const double> values) {
  std::vector<double> third;
  for (std::size_t i = 0; i + 3 < values.size(); ++i)
    third.push_back(values[i + 3] - 3 * values[i + 2] + 3 * values[i + 1] - values[i]);
  return third;
}

}  // namespace secular
