#include "measure/modal/modal_mass.hpp"

#include <Eigen/Dense>
#include <stdexcept>

namespace secular {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::complex<double> modal_mass(std::complex<double> pole, std::complex<double> driving_point_shape,
                                std::complex<double> receptance_amplitude) {
  return driving_point_shape / (std::complex<double>(0, 2 * pole.imag()) * receptance_amplitude);
}

MatrixXd mass_normalised_shapes(const Eigen::Ref<const MatrixXd>& shapes,
                                const Eigen::Ref<const VectorXd>& masses) {
  if (shapes.cols() != masses.size()) throw std::invalid_argument("mass_normalised_shapes: one mass a shape");
  if (!(masses.minCoeff() > 0)) throw std::invalid_argument("mass_normalised_shapes: a mass is not positive");
  return shapes * masses.cwiseSqrt().cwiseInverse().asDiagonal();
}

DynamicMatrices dynamic_matrices(const Eigen::Ref<const MatrixXd>& shapes,
                                 const Eigen::Ref<const Eigen::VectorXcd>& poles) {
  if (shapes.cols() != poles.size() || shapes.cols() > shapes.rows())
    throw std::invalid_argument("dynamic_matrices: one pole a shape, no more shapes than channels");
  const Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition(shapes);
  if (decomposition.rank() < shapes.cols())
    throw std::invalid_argument("dynamic_matrices: the shapes are dependent");
  const MatrixXd inverse = decomposition.pseudoInverse();
  const VectorXd twice_decay = -2 * poles.real();  // 2 zeta omega
  const VectorXd square = poles.cwiseAbs2();       // omega^2
  return {inverse.transpose() * inverse, inverse.transpose() * twice_decay.asDiagonal() * inverse,
          inverse.transpose() * square.asDiagonal() * inverse};
}

}  // namespace secular
