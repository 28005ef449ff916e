#include "thesis/procedures/frequency_response_regression.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "input/numerical_failure.hpp"

namespace secular {

using Eigen::Index;

FrequencyResponseFit frequency_response_regression(const FrequencyResponseData& data) {
  const Index count = data.amplitude.size();
  if (data.forcing.size() != count || data.excitation_frequency.size() != count ||
      data.condition.size() != static_cast<std::size_t>(count) ||
      (data.cos_gamma.size() != 0 && data.cos_gamma.size() != count))
    throw std::invalid_argument("the data of a frequency response have different lengths");
  const double w0 = data.omega0;
  Eigen::MatrixXd design(count, 2);
  Eigen::VectorXd response(count);
  std::vector<int> cluster;
  Index row = 0;
  for (Index i = 0; i < count; ++i) {
    const double a = data.amplitude(i), force = data.forcing(i);
    const double damping = w0 * data.linear + 4 * w0 * w0 / (3 * std::numbers::pi) * a * data.quadratic +
                           0.375 * w0 * w0 * w0 * a * a * data.cubic;
    if (!(force > damping)) continue;
    const double sign = data.cos_gamma.size() == 0 ? 1 : std::copysign(1.0, data.cos_gamma(i));
    design.row(row) << a * a, -sign * std::sqrt(force * force - damping * damping);
    response(row) = 0.5 * w0 * (data.excitation_frequency(i) - 2 * w0);
    cluster.push_back(data.condition[static_cast<std::size_t>(i)]);
    ++row;
  }
  if (row < 3)
    throw NumericalFailure(Ending::out_of_range,
                           "the damping needs less force than there was in " + std::to_string(row) + " of " +
                               std::to_string(count) +
                               " ensembles: a frequency response needs three or more of them");
  FrequencyResponseFit result;
  result.left_out = static_cast<std::size_t>(count - row);
  result.fit = linear_fit(design.topRows(row), response.head(row), cluster);
  result.stiffness = result.fit.coefficients(0);
  result.excitation = result.fit.coefficients(1);
  return result;
}

}  // namespace secular
