#include "diagnose/evidence/noise_levels.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "numerics/median.hpp"
#include "numerics/third_differences.hpp"

namespace secular {

using Eigen::Index;
using Eigen::VectorXd;

// By the median of |normal|, 0.6745.
double roughness(const std::vector<double>& values) {
  std::vector<double> third = third_differences(values);
  for (double& difference : third) difference = std::abs(difference);
  return upper_median(std::move(third)) / (0.6745 * std::sqrt(third_difference_variance));
}

double lower_quartile(std::vector<double> values) {
  const auto quarter = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), quarter, values.end());
  return *quarter;
}

double white_variance(const VectorXd& error, Index samples, const std::vector<Index>& silent) {
  VectorXd live = VectorXd::Ones(samples);
  for (const Index sample : silent) live(sample) = 0;
  double sum = 0, count = 0;
  for (Index first = 0; first + samples <= error.size(); first += samples) {
    const std::vector<double> third = third_differences({error.data() + first, static_cast<std::size_t>(samples)});
    for (std::size_t d = 0; d < third.size(); ++d) {
      const auto i = static_cast<Index>(d);
      sum += third[d] * third[d];
      count += live(i) + 9 * live(i + 1) + 9 * live(i + 2) + live(i + 3);
    }
  }
  return count > 0 ? sum / count : 1;
}

double white_level(const std::vector<double>& variances) {
  return std::max(1e-3, std::sqrt(std::accumulate(variances.begin(), variances.end(), 0.0) /
                                  static_cast<double>(variances.size())));
}

}  // namespace secular
