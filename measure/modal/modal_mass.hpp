#pragma once

#include <Eigen/Core>
#include <complex>

namespace secular {

/// Modal mass of Eq. (2.7) from one reference: pole of the mode (rad/s), its shape at the driving point (scaled by
/// Eq. (2.2)) and the initial modal amplitude B(r, q) of the receptance, all with that scale. Complex where the
/// mode is: its real part is the mass, the rest says how far from normal the estimate is. kg for receptance in m/N.
std::complex<double> modal_mass(std::complex<double> pole, std::complex<double> driving_point_shape,
                                std::complex<double> receptance_amplitude);

/// Eq. (2.13): columns of self-normalised shapes (p x n) over the square roots of the modal masses (kg): kg^-1/2.
/// Throws std::invalid_argument for a mass that is not positive.
Eigen::MatrixXd mass_normalised_shapes(const Eigen::Ref<const Eigen::MatrixXd>& shapes,
                                       const Eigen::Ref<const Eigen::VectorXd>& masses);

/// Matrices of the band that the modes span, in the channels' coordinates (p x p).
struct DynamicMatrices {
  Eigen::MatrixXd mass;       ///< kg, Eq. (2.14)
  Eigen::MatrixXd damping;    ///< kg/s, Eq. (2.19)
  Eigen::MatrixXd stiffness;  ///< kg/s^2, Eq. (2.20)
};

/// Eqs. (2.14), (2.19), (2.20) from mass-normalised shapes (p x n, n <= p) and poles (rad/s). With fewer modes than
/// channels the inverse is the pseudo-inverse: matrices of rank n that act on the span of the shapes. Throws
/// std::invalid_argument for dependent shapes or sizes that differ.
DynamicMatrices dynamic_matrices(const Eigen::Ref<const Eigen::MatrixXd>& shapes,
                                 const Eigen::Ref<const Eigen::VectorXcd>& poles);

}  // namespace secular
