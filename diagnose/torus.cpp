#include "diagnose/torus.hpp"

#include <cmath>
#include <numbers>

namespace secular {

using Eigen::Index;

Torus::Torus(int dimensions, int highest, Index points) : dimensions_(dimensions) {
  phases_.push_back({0, 0});
  for (int m = 0; m <= (dimensions == 1 ? 0 : highest); ++m)
    for (int n = m == 0 ? 1 : m - highest; n <= highest - m; ++n) phases_.push_back({n, m});
  const Index total = dimensions == 1 ? points : points * points;
  cosine_.resize(lines(), total);
  sine_.resize(lines(), total);
  // Half a step off zero: turning points of the leading line then fall between two samples, where a jump of dry
  // friction is represented best.
  for (Index p = 0; p < total; ++p) {
    const double first =
        2 * std::numbers::pi * (static_cast<double>(p % points) + 0.5) / static_cast<double>(points);
    const double second =
        2 * std::numbers::pi * (static_cast<double>(p / points) + 0.5) / static_cast<double>(points);
    for (Index l = 0; l < lines(); ++l) {
      const double angle = phase(l)[0] * first + phase(l)[1] * second;
      cosine_(l, p) = std::cos(angle);
      sine_(l, p) = std::sin(angle);
    }
  }
}

std::optional<Index> Torus::find(const LinePhase& wanted) const {
  for (Index l = 0; l < lines(); ++l)
    if (phase(l) == wanted) return l;
  return std::nullopt;
}

Eigen::MatrixXd Torus::samples(const Eigen::MatrixXcd& coefficients) const {
  Eigen::MatrixXd real = 2 * coefficients.real();
  real.col(0) *= 0.5;
  return real * cosine_ - 2 * coefficients.imag() * sine_;
}

Eigen::MatrixXcd Torus::coefficients(const Eigen::MatrixXd& samples) const {
  const double weight = 1 / static_cast<double>(points());
  Eigen::MatrixXcd result(samples.rows(), lines());
  result.real() = weight * samples * cosine_.transpose();
  result.imag() = -weight * samples * sine_.transpose();
  return result;
}

}  // namespace secular
