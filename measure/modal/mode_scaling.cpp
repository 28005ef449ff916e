#include "measure/modal/mode_scaling.hpp"

#include <cmath>
#include <stdexcept>

namespace secular {

using Complex = std::complex<double>;

bool squares_cancel(const Eigen::Ref<const Eigen::VectorXcd>& shape) {
  return !(std::abs((shape.array() * shape.array()).sum()) > 1e-6 * shape.squaredNorm());
}

ScaledShape scale_shape(const Eigen::Ref<const Eigen::VectorXcd>& shape) {
  if (!(shape.squaredNorm() > 0)) throw std::invalid_argument("scale_shape: a shape of zeros");
  ScaledShape result;
  result.factor = std::sqrt((shape.array() * shape.array()).sum());
  if (squares_cancel(shape)) {
    Eigen::Index largest = 0;
    shape.cwiseAbs2().maxCoeff(&largest);
    result.factor = std::polar(shape.norm(), std::arg(shape(largest)));
  }
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
