#include "measure/signal/displacement.hpp"

#include <stdexcept>

namespace secular {

using Eigen::Index;
using Eigen::MatrixXd;

std::complex<double> displacement_of(std::complex<double> acceleration, double frequency, double growth) {
  const std::complex<double> pole(growth, frequency);
  if (pole == 0.0) throw std::invalid_argument("a constant acceleration has no displacement amplitude");
  return acceleration / (pole * pole);
}

DisplacementComponent displacement_component(const Decomposition& acceleration, std::size_t pole, Index channel) {
  const ToneEstimate tone = acceleration.tone(pole, channel);  // refuses other families
  const Index row = acceleration.first_function(pole);
  const double p = acceleration.amplitudes(row, channel), q = acceleration.amplitudes(row + 1, channel);
  DisplacementComponent component;
  component.value = displacement_of({0.5 * p, -0.5 * q}, tone.frequency);
  if (acceleration.covariance.size() == 0) return component;
  const bool free_frequency = parameter_count(acceleration.poles[pole]) == 1;
  const Index at = acceleration.amplitude_row(row, channel);
  const double inverse = 1 / (tone.frequency * tone.frequency);
  MatrixXd slope = MatrixXd::Zero(2, acceleration.covariance.rows());
  slope(0, at) = -0.5 * inverse;
  slope(1, at + 1) = 0.5 * inverse;
  if (free_frequency) {
    const Index unknown = acceleration.first_parameter(pole);
    slope(0, unknown) = -2 / tone.frequency * component.value.real();
    slope(1, unknown) = -2 / tone.frequency * component.value.imag();
  }
  component.covariance = slope * acceleration.covariance * slope.transpose();
  return component;
}

}  // namespace secular
