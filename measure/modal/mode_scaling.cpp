#include "measure/modal/mode_scaling.hpp"

#include <cmath>
#include <stdexcept>

namespace secular {

using Complex = std::complex<double>;

ScaledShape scale_shape(const Eigen::Ref<const Eigen::VectorXcd>& shape) {
  const Complex squares = (shape.array() * shape.array()).sum();
  if (!(std::abs(squares) > 1e-6 * shape.squaredNorm()))
    throw std::invalid_argument("scale_shape: the squares of the shape cancel");
  ScaledShape result;
  result.factor = std::sqrt(squares);
  result.shape = shape / result.factor;
  Eigen::Index largest = 0;
  result.shape.real().cwiseAbs().maxCoeff(&largest);
  if (result.shape(largest).real() < 0) {
    result.shape = -result.shape;
    result.factor = -result.factor;
  }
  return result;
}

}  // namespace secular
