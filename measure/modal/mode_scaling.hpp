#pragma once

#include <Eigen/Core>
#include <complex>

namespace secular {

/// A mode shape (size p) scaled by Eq. (2.2), sum of squares one, and the factor that was taken out:
/// original = factor * shape. The squares of a complex shape are not its moduli: the rule also turns the shape so
/// that its real part is as large as it can be. Of the two signs the one that makes the largest real part positive.
struct ScaledShape {
  Eigen::VectorXcd shape;
  std::complex<double> factor;
};

/// Whether Eq. (2.2) cannot scale a shape: of a travelling wave or a whirling shaft (1, i) the squares cancel, here
/// to less than 1e-6 of the sum of their moduli.
bool squares_cancel(const Eigen::Ref<const Eigen::VectorXcd>& shape);

/// A shape whose squares cancel gets the sum of squared moduli one instead, and its largest entry is real and
/// positive. Throws std::invalid_argument for a shape of zeros.
ScaledShape scale_shape(const Eigen::Ref<const Eigen::VectorXcd>& shape);

}  // namespace secular
